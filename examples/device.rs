//! The same solver as a static on a device: fixed-point numbers, a fixed capacity, no heap, no
//! panic. This file runs on a server too; `embedded/` holds a whole firmware.
//!
//! `cargo run --release --example device`

use fixed::types::extra::U19;
use motes_core::cutoff::CubicSpline;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{GasDynamics, Plain, PlainStorage, Stretch, Width};
use motes_core::error::Error;
use motes_core::material::IdealGas;
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;
use motes_core::scalar::{Q32, Scalar};
use std::sync::Mutex;

/// 32 bits, 19 of them behind the point.
type S = Q32<U19>;
const N: usize = 64;
const CELLS: usize = cell_bound(N as u32) as usize + 1;

/// All memory of the solver, in .bss. On a device: `static_cell::ConstStaticCell`.
static STORAGE: Mutex<PlainStorage<S, 1, N, CELLS>> = Mutex::new(PlainStorage::new());

/// A closed pipe, its left half hot: `steps` steps of a control loop. Returns the highest
/// pressure at the right end.
fn simulate(storage: &mut PlainStorage<S, 1, N, CELLS>, steps: u32) -> Result<S, Error> {
    let number = S::from_f64;
    let materials = [IdealGas::new(1.4)];
    let solver = GasDynamics {
        domain: Domain {
            axes: [Axis::walls(number(-32.0), number(32.0))],
        },
        cut_off: CubicSpline,
        width: Width::Adaptive { eta: number(1.2) },
        viscosity: Pairwise(Coefficients {
            alpha: S::ONE,
            beta: number(2.0),
        }),
        materials: &materials,
        physics: Plain::DEFAULT,
        courant: number(0.3),
        smallest_omega: number(0.03),
    };
    let cold = Stretch {
        lower: 0.0,
        upper: 32.0,
        particles: 32,
        mass: 1.0,
        velocity: 0.0,
        energy: 1.8,
    };
    let hot = Stretch {
        lower: -32.0,
        upper: 0.0,
        energy: 3.6,
        ..cold
    };
    storage.clear();
    for particle in hot.particles(1.2).chain(cold.particles(1.2)) {
        storage.push(particle.rounded())?;
    }
    let (mut gas, mut work) = storage.parts();
    solver.prepare(&mut HalfLoop, &mut gas, &mut work)?;
    let mut highest = S::ZERO;
    for _ in 0..steps {
        let dt = solver.time_step(&gas, S::ONE)?;
        solver.advance(&mut HalfLoop, &mut gas, &mut work, dt)?;
        let energy = gas.density[N - 1] * gas.energy[N - 1];
        highest = if energy > highest { energy } else { highest };
    }
    Ok(highest * number(0.4))
}

fn main() -> Result<(), Error> {
    let mut storage = STORAGE
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    println!(
        "highest pressure at the end: {:.4}",
        simulate(&mut storage, 400)?.to_f64()
    );
    println!("bytes of static memory: {}", size_of_val(&*storage));
    Ok(())
}
