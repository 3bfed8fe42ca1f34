//! Kelvin's wave along a wall: what holds Coriolis' force there.

use std::f64::consts::TAU;

use motes_core::cutoff::Named;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::linear::systems::{Location, ShallowWater, Units};
use motes_core::equation::linear::{LinearDynamics, LinearStorage, Particle, Still};
use motes_core::integrator::{Clock, RK4};
use motes_core::pairs::HalfLoop;

const MOST: usize = 4096;
type Storage = LinearStorage<f64, Location<f64>, 2, 3, MOST, { 4 * MOST + 129 }>;

/// A wave of length 1 between walls 1 apart, g = H = 1, f = 2: along x between walls across y, or
/// along y between walls across x.
#[derive(Clone, Copy, Debug)]
struct Kelvin {
    /// The direction across the walls.
    walls: usize,
    /// Particles along each direction.
    n: u32,
}

const CORIOLIS: f64 = 2.0;

impl Kelvin {
    /// `η = v = e^(∓fs) cos 2π(r - t)`, r along the walls and s across; the velocity across is 0.
    fn state(&self, [x, y]: [f64; 2], time: f64) -> [f64; 3] {
        let (along, across) = match self.walls {
            0 => (y, -x),
            _ => (x, y),
        };
        let height = (-CORIOLIS * across).exp() * (TAU * (along - time)).cos();
        match self.walls {
            0 => [height, 0.0, height],
            _ => [height, height, 0.0],
        }
    }

    /// The largest velocity across after a period, and the error of all, root mean square; both in
    /// the root mean square of the height.
    fn errors(&self) -> [f64; 2] {
        let size = f64::from(self.n);
        let mut storage = Box::new(Storage::new());
        for k in 0..self.n * self.n {
            let place = |k: u32| (f64::from(k) + 0.5) / size - 0.5;
            let position = [place(k / self.n), place(k % self.n)];
            storage
                .push(Particle {
                    position: position.map(|x| x * size),
                    weight: 1.0,
                    value: self.state(position, 0.0),
                })
                .unwrap();
        }
        let mut axes = [Axis::periodic(-0.5 * size, 0.5 * size); 2];
        axes[self.walls] = Axis::walls(-0.5 * size, 0.5 * size);
        let solver = LinearDynamics::new(
            Domain { axes },
            (Named::QuinticSpline, 0.7 * size.powf(0.25)),
            ShallowWater::new(1.0, 1.0, CORIOLIS / size, Units::ONE),
            Still,
            0.5,
        );
        let (mut state, mut work) = storage.parts();
        let engine = &mut HalfLoop;
        solver.prepare(engine, &mut state, &mut work).unwrap();
        let mut clock = Clock::new(size);
        while let Some(left) = clock.left() {
            let step = solver.time_step(&state, clock.time, RK4.stability(), left);
            let step = (clock.time, step.unwrap());
            solver
                .advance(&RK4, engine, &mut state, &mut work, step)
                .unwrap();
            clock.tick(step.1).unwrap();
        }
        let (mut across, mut squares, mut heights) = (0.0f64, 0.0, 0.0);
        for (x, u) in state.position.iter().zip(state.value.iter()) {
            let exact = self.state(x.map(|x| x / size), 1.0);
            across = across.max(u[1 + self.walls].abs());
            squares += u
                .iter()
                .zip(exact)
                .map(|(u, v)| (u - v) * (u - v))
                .sum::<f64>();
            heights += exact[0] * exact[0];
        }
        [
            across / (heights / (size * size)).sqrt(),
            (squares / heights).sqrt(),
        ]
    }
}

/// Nothing flows across, to first order in the width: `r θ` or, next to a wall, θ = 0.75. A flat
/// image of the surface leaves a quarter of the amplitude there at any resolution.
#[test]
fn a_kelvin_wave_between_walls_converges() {
    let thread = std::thread::Builder::new().stack_size(64 << 20);
    let test = || {
        for walls in [1, 0] {
            let errors = [16, 32, 64].map(|n| Kelvin { walls, n }.errors());
            for part in 0..2 {
                let [coarse, _, fine] = errors.map(|error| error[part]);
                let order = 0.5 * (coarse / fine).log2();
                assert!(order > 0.7, "across {walls}: {errors:?}, order {order}");
            }
            assert!(errors[2][0] < 0.05, "across {walls}: {errors:?}");
        }
    };
    thread.spawn(test).unwrap().join().unwrap();
}
