//! A control loop on a device: a wall that follows a sensor, in fixed-point numbers and static memory,
//! with no heap and no panic. This file runs on a server too; `embedded/` holds a whole firmware.
//!
//! `cargo run --release --example device`

use fixed::types::extra::U16;
use motes_core::cloud::{Particle, Still};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::diffusion::{
    DiffusionDynamics, DirectStorage, Drive, DrivenCondition, Form, Mean, NamedProblem,
};
use motes_core::integrator::{DiffusionMethod, Scheme, Stepper};
use motes_core::scalar::{Q32, Scalar};
use motes_core::{cutoff::QuinticSpline, error::Error, neighbours::cell_bound, pairs::HalfLoop};
use std::sync::Mutex;

/// 32 bits, 16 of them behind the point.
type S = Q32<U16>;
const CELLS: usize = cell_bound(48) as usize + 1;
/// All memory of the wall, in .bss. On a device: `static_cell::ConstStaticCell`.
static MEMORY: Mutex<DirectStorage<S, 1, 1, 48, CELLS>> = Mutex::new(DirectStorage::new());

#[rustfmt::skip]
fn main() -> Result<(), Error> {
    let number = S::from_f64;
    let mut memory = MEMORY.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    for k in 0..48 {
        let x = number(f64::from(k) + 0.5);
        memory.push(Particle { position: [x], weight: S::ONE, value: [number(20.0)] })?;
    }
    let wall = DiffusionDynamics {
        domain: Domain { axes: [Axis::walls(S::ZERO, number(48.0))] },
        problem: NamedProblem::heat([S::ONE]), field: Still, cut_off: QuinticSpline, epsilon: number(2.0),
        form: Form::Direct, mean: Mean::Arithmetic, courant: number(0.8),
    };
    let method = DiffusionMethod { scheme: Scheme::Stabilised(9), longest: number(1000.0) };
    let mut run = Stepper::new(wall, method, HalfLoop, &mut *memory)?;
    for tick in 1..=600u32 {
        // What a sensor says: a fast swing about 10 degrees.
        let outside = number(10.0) + S::from_f64(if tick % 60 < 30 { 5.0 } else { -5.0 });
        run.dynamics.problem.walls[0][0] = [DrivenCondition::Value(Drive::Constant(outside))];
        run.advance_to(S::count(4 * tick))?;
    }
    let state = run.state();
    println!("10 at the outside, {:.2} in the middle", state.value[24][0].to_f64());
    Ok(())
}
