//! A system of your own: waves with a mass (Klein-Gordon), on particles that move, against the exact
//! solution. `docs/linear.md` explains each part.
//!
//! `cargo run --release --example own_system`

use std::f64::consts::TAU;

use motes_core::cutoff::Named;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::linear::{
    FirstOrderSystem, LinearDynamics, LinearStorage, Nothing, Particle, Place, State, Wave,
};
use motes_core::error::Error;
use motes_core::integrator::{Clock, RK4};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;
use motes_core::scalar::{Number, Scalar};

const N: usize = 256;
const CELLS: usize = cell_bound(N as u32) as usize + 1;
type Storage = LinearStorage<f64, Nothing, 1, 3, N, CELLS>;
type Solver = LinearDynamics<f64, Named, KleinGordon<f64>, Wave<f64>, 1, 3>;

/// What the cut-off costs: the step is proportional to `1/kappa`.
const CUT_OFFS: [Named; 4] = [
    Named::QuinticSpline,
    Named::SmoothTwo,
    Named::SmoothFour,
    Named::SmoothSix,
];

/// `φ_tt = φ_xx - m² φ` as `∂a/∂t + ∂b/∂x + m c = 0`, `∂b/∂t + ∂a/∂x = 0`, `∂c/∂t - m a = 0` for
/// `a = φ_t`, `b = -φ_x`, `c = m φ`. `A` is symmetric and `A⁰` antisymmetric: nothing grows.
#[derive(Clone, Copy)]
struct KleinGordon<S> {
    mass: S,
}

impl<S: Scalar> FirstOrderSystem<S, 1, 3> for KleinGordon<S> {
    type Medium = Nothing;
    const IS_UNIFORM: bool = true;

    fn medium(&self, _: &Place<S, 1>) -> Nothing {
        Nothing
    }
    fn flux<M: Number<Scalar = S>>(&self, _: &Nothing, n: &[M; 1], u: &[M; 3]) -> [M; 3] {
        let [a, b, _] = *u;
        [n[0] * b, n[0] * a, M::zero()]
    }
    fn decay(&self, _: &Place<S, 1>, u: &[S; 3]) -> [S; 3] {
        [self.mass * u[2], S::ZERO, -(self.mass * u[0])]
    }
    fn speed(&self, _: &Nothing) -> S {
        S::ONE
    }
    fn damping(&self) -> S {
        self.mass
    }
}

/// The wave `φ = cos(kx - ωt)`, `ω² = k² + m²`: two wavelengths in the box, `m = k`.
fn exact(x: f64, time: f64, box_length: f64) -> [f64; 3] {
    let k = 2.0 * TAU / box_length;
    let frequency = (2.0 * k * k).sqrt();
    let (sine, cosine) = (k * x - frequency * time).sin_cos();
    [frequency * sine, k * sine, k * cosine].map(|u| u / k)
}

/// `(Σ w |u|²)^(1/2)` of what a function makes of each particle's position and state.
fn norm(state: &State<'_, f64, 1, 3>, of: impl Fn(f64, [f64; 3]) -> [f64; 3]) -> f64 {
    let particles = state.position.iter().zip(state.value.iter());
    let squares = particles.zip(state.weight.iter()).map(|((x, &u), w)| {
        let u = of(x[0], u);
        w * u.iter().map(|u| u * u).sum::<f64>()
    });
    squares.sum::<f64>().sqrt()
}

/// `n` particles in solver units: the spacing is 1, the box `n` long, its middle 0.
fn solver(n: u32, cut_off: Named) -> Solver {
    let length = f64::from(n);
    LinearDynamics::new(
        Domain {
            axes: [Axis::periodic(-0.5 * length, 0.5 * length)],
        },
        // eps = 1.0 h^0.75 in boxes.
        (cut_off, length.powf(0.25)),
        KleinGordon {
            mass: 2.0 * TAU / length,
        },
        Wave {
            amplitude: 0.2,
            length,
            phase: 0.0,
        },
        0.5,
    )
}

/// Runs `n` particles a quarter of the box long. The relative error, and how much the energy norm
/// changed.
fn run(n: u32) -> Result<[f64; 2], Error> {
    let length = f64::from(n);
    let solver = solver(n, Named::SmoothFour);
    let mut storage = Storage::new();
    for k in 0..n {
        let x = f64::from(k) + 0.5 - 0.5 * length;
        storage.push(Particle {
            position: [x],
            weight: 1.0,
            value: exact(x, 0.0, length),
        })?;
    }
    let (mut state, mut work) = storage.parts();
    let engine = &mut HalfLoop;
    solver.prepare(engine, &mut state, &mut work)?;
    let before = norm(&state, |_, u| u);
    let mut clock = Clock::new(0.25 * length);
    while let Some(left) = clock.left() {
        let dt = solver.time_step(&state, clock.time, RK4.stability(), left)?;
        solver.advance(&RK4, engine, &mut state, &mut work, (clock.time, dt))?;
        clock.tick(dt)?;
    }
    let after = norm(&state, |_, u| u);
    let error = norm(&state, |x, u| {
        let exact = exact(x, clock.end, length);
        [u[0] - exact[0], u[1] - exact[1], u[2] - exact[2]]
    });
    Ok([error / after, after / before - 1.0])
}

fn main() -> Result<(), Error> {
    for cut_off in CUT_OFFS {
        println!(
            "{}: kappa = {:.3}",
            cut_off.name(),
            solver(8, cut_off).slope
        );
    }
    println!("particles  error     change of the energy norm");
    for n in [64, 128, 256] {
        let [error, change] = run(n)?;
        println!("{n:9}  {error:.2e}  {change:+.1e}");
    }
    Ok(())
}
