//! A shock tube with the core alone: no heap, no files, no command line.
//!
//! `cargo run --release --example tube`

use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{PlainStorage, Stretch, Tube, Width};
use motes_core::integrator::{LeapFrog, Stepper};
use motes_core::{cutoff::CubicSpline, domain::Side, error::Error};
use motes_core::{neighbours::cell_bound, pairs::HalfLoop};

const CELLS: usize = cell_bound(225) as usize + 1;

#[rustfmt::skip]
fn main() -> Result<(), Error> {
    let dense = Stretch { lower: -100.0, upper: 0.0, particles: 200, mass: 0.5, velocity: 0.0, energy: 1.8 };
    let thin = Stretch { lower: 0.0, upper: 100.0, particles: 25, ..dense };
    let tube = Tube {
        half_length: 100.0, sides: [Side::Mirror; 2], stretches: &[dense, thin], gamma: 1.4,
        width: Width::adaptive(1.2), courant: 0.3, end: 25.0,
    };
    let materials = [tube.material()];
    let solver = tube.solver(CubicSpline, Pairwise(Coefficients::usual()), &materials);
    let mut storage = PlainStorage::<f64, 1, 225, CELLS>::new();
    tube.fill(|particle| storage.push(particle))?;
    let mut run = Stepper::new(solver, LeapFrog, HalfLoop, &mut storage)?.until(tube.duration());
    while run.step()?.is_some() {}
    println!("{} steps", run.clock().steps);
    println!("digest {}", run.state().digest());
    Ok(())
}
