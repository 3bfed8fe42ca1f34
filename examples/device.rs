//! A control loop on a device: a wall that follows a sensor, in fixed-point numbers and static memory,
//! with no heap and no panic. This file runs on a server too; `embedded/` holds a whole firmware.
//! `docs/own-device.md` explains each part. `cargo run --release --example device`

use fixed::types::extra::U16;
use motes_core::cloud::{Frame, Particle, Still, Units};
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

/// 0.24 m of brick in 48 particles: 5 mm, and the 50 s in which heat spreads so far, are 1.
const WALL: Frame = Frame {
    middle: [0.12, 0.0, 0.0],
    units: Units {
        length: 0.005,
        velocity: 0.005 / 50.0,
    },
};

const PARTICLES: usize = 48;
const CELLS: usize = cell_bound(PARTICLES as u32) as usize + 1;
/// All memory of the wall, in .bss. On a device: `static_cell::ConstStaticCell`.
static MEMORY: Mutex<DirectStorage<S, 1, 1, PARTICLES, CELLS>> = Mutex::new(DirectStorage::new());

/// What a sensor outside says, in °C: a swing of a day about 5.
fn sensor(minute: u32) -> f64 {
    let part = f64::from(minute % 1440) / 1440.0;
    5.0 + 8.0 * (1.0 - 4.0 * (part - 0.5).abs())
}

#[rustfmt::skip]
fn main() -> Result<(), Error> {
    let mut memory = MEMORY.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    for k in 0..PARTICLES {
        let place = WALL.place([0.005 * (k as f64 + 0.5)]);
        memory.push(Particle { position: place, weight: S::ONE, value: [WALL.number(20.0)] })?;
    }
    let [outside] = WALL.place([0.0]);
    let [inside] = WALL.place([0.24]);
    let mut problem = NamedProblem::heat([WALL.diffusivity(5e-7)]);
    // 8 W/(m² K) over the 1.5e6 J/(m³ K) that brick holds, from the room at 20 °C.
    let room = Drive::Constant(WALL.number(20.0));
    problem.walls[0][1] = [DrivenCondition::Exchange { rate: WALL.velocity(5.3e-6), outside: room }];
    let wall = DiffusionDynamics {
        domain: Domain { axes: [Axis::walls(outside, inside)] },
        problem, field: Still, cut_off: QuinticSpline, epsilon: WALL.length(0.009),
        form: Form::Direct, mean: Mean::Arithmetic, courant: WALL.number(0.8),
    };
    let method = DiffusionMethod { scheme: Scheme::Stabilised(9), longest: WALL.duration(600.0) };
    let mut run = Stepper::new(wall, method, HalfLoop, &mut *memory)?;

    for minute in 0..5 * 1440 {
        // 25 W/(m² K) from the air outside, which is what the sensor says.
        let air = Drive::Constant(WALL.number(sensor(minute)));
        let condition = DrivenCondition::Exchange { rate: WALL.velocity(1.7e-5), outside: air };
        run.dynamics.problem.walls[0][0] = [condition];
        // Nothing depends on the time itself: from 0 in each tick, it never leaves the format.
        run.set_time(S::ZERO);
        run.advance_to(WALL.duration(60.0))?;
    }
    let state = run.state();
    let celsius = |k: usize| state.value[k][0].to_f64();
    println!("after five days {:.1} °C outside, {:.1} °C inside", celsius(0), celsius(PARTICLES - 1));
    Ok(())
}
