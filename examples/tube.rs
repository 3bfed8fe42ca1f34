//! A solver in 40 lines: a shock tube with the core alone, no files and no command line.
//!
//! `cargo run --release --example tube`

use motes_core::cutoff::CubicSpline;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{GasDynamics, GasStorage, Stretch, Width};
use motes_core::error::Error;
use motes_core::integrator::Clock;
use motes_core::material::IdealGas;
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;

const N: usize = 225;
const CELLS: usize = cell_bound(N as u32) as usize + 1;

fn main() -> Result<(), Error> {
    let solver = GasDynamics {
        domain: Domain {
            axes: [Axis::walls(-100.0, 100.0)],
        },
        cut_off: CubicSpline,
        width: Width::Adaptive { eta: 1.2 },
        viscosity: Pairwise(Coefficients {
            alpha: 1.0,
            beta: 2.0,
        }),
        equation_of_state: IdealGas::new(1.4),
        courant: 0.3,
        smallest_omega: 0.03,
    };
    let mut storage = GasStorage::<f64, 1, N, CELLS>::new();
    let left = Stretch {
        lower: -100.0,
        upper: 0.0,
        particles: 200,
        mass: 0.5,
        velocity: 0.0,
        energy: 1.8,
    };
    let right = Stretch {
        lower: 0.0,
        upper: 100.0,
        particles: 25,
        energy: 1.4,
        ..left
    };
    for particle in left.particles(1.2).chain(right.particles(1.2)) {
        storage.push(particle)?;
    }
    let (mut gas, mut work) = storage.parts();
    solver.prepare(&mut HalfLoop, &mut gas, &mut work)?;
    let mut clock = Clock::new(25.0);
    while let Some(left) = clock.left() {
        let dt = solver.time_step(&gas, left)?;
        solver.advance(&mut HalfLoop, &mut gas, &mut work, dt)?;
        clock.tick(dt);
    }
    println!(
        "{} steps, density behind the contact {:.3}, digest {}",
        clock.steps,
        gas.density[190],
        gas.digest()
    );
    Ok(())
}
