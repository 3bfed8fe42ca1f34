//! A solver in 40 lines and a few imports: a shock tube with the core alone, no files and no command line.
//!
//! `cargo run --release --example tube`

use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{PlainStorage, Stretch, Tube, Width};
use motes_core::{cutoff::CubicSpline, domain::Side, error::Error, integrator::Clock};
use motes_core::{neighbours::cell_bound, pairs::HalfLoop};

const N: usize = 225;
const CELLS: usize = cell_bound(N as u32) as usize + 1;

const LEFT: Stretch = Stretch {
    lower: -100.0,
    upper: 0.0,
    particles: 200,
    mass: 0.5,
    velocity: 0.0,
    energy: 1.8,
};

fn main() -> Result<(), Error> {
    let right = Stretch {
        lower: 0.0,
        upper: 100.0,
        particles: 25,
        ..LEFT
    };
    let tube = Tube {
        half_length: 100.0,
        sides: [Side::Mirror; 2],
        stretches: &[LEFT, right],
        gamma: 1.4,
        width: Width::Adaptive { eta: 1.2 },
        courant: 0.3,
        end: 25.0,
    };
    let materials = [tube.material()];
    let solver = tube.solver(
        CubicSpline,
        Pairwise(Coefficients {
            alpha: 1.0,
            beta: 2.0,
        }),
        &materials,
    );
    let mut storage = PlainStorage::<f64, 1, N, CELLS>::new();
    tube.particles()
        .try_for_each(|particle| storage.push(particle))?;
    let (mut gas, mut work) = storage.parts();
    solver.prepare(&mut HalfLoop, &mut gas, &mut work)?;
    let mut clock = Clock::new(tube.duration());
    while let Some(left) = clock.left() {
        let dt = solver.time_step(&gas, left)?;
        solver.advance(&mut HalfLoop, &mut gas, &mut work, dt)?;
        clock.tick(dt)?;
    }
    println!("{} steps, digest {}", clock.steps, gas.digest());
    Ok(())
}
