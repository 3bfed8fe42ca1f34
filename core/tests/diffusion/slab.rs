//! A slab from plain numbers, in the memory of a device.

use fixed::types::extra::U16;
use motes_core::cutoff::Named::QuinticSpline;
use motes_core::domain::Side;
use motes_core::equation::diffusion::{
    Conductor, DiffusionStorage, DirectStorage, Drive, DrivenCondition, Lists, Mean, NamedProblem,
    Slab,
};
use motes_core::equation::linear::{Particle, Still};
use motes_core::error::Error;
use motes_core::integrator::{RK4, Rkl2};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::{Q32, Scalar};

const N: usize = 32;
/// More than the 32 cells that 32 spacings of reach 6 take.
const CELLS: usize = 40;
const SERIES: &[(f64, f64)] = &[(0.0, 5.0), (0.7, 3.1), (2.0, 8.3)];
const CLOUD: [Particle<f64, 1, 1>; N] = {
    let mut cloud = [Particle {
        position: [0.0],
        weight: 1.0,
        value: [12.0],
    }; N];
    let mut k = 0;
    while k < N {
        cloud[k].position = [k as f64 - 15.5];
        k += 1;
    }
    cloud
};

/// Two layers between weather and a room.
const SLAB: Slab<'static> = Slab {
    half_length: 16.0,
    sides: [Side::Mirror; 2],
    problem: NamedProblem {
        conductor: Conductor::Layers {
            bounds: &[3.0],
            factors: &[1.0, 0.1],
        },
        walls: [[
            [DrivenCondition::Exchange {
                rate: 0.3,
                outside: Drive::Series(SERIES),
            }],
            [DrivenCondition::Value(Drive::Constant(20.0))],
        ]],
        ..NamedProblem::heat([1.7])
    },
    mean: Mean::Harmonic,
    cloud: &CLOUD,
    epsilon: 2.0,
    courant: 0.5,
    stages: 9,
    longest: 2.0,
    step: None,
    end: 2.0,
};

/// The digest after four steps, in the memory that `parts` lends.
macro_rules! digest {
    ($storage:expr, $solver:expr) => {{
        let mut storage = $storage;
        for particle in SLAB.particles() {
            storage.push(particle).unwrap();
        }
        let (mut state, mut work) = storage.parts();
        let solver = $solver;
        solver
            .prepare(&mut HalfLoop, &mut state, &mut work)
            .unwrap();
        let (mut time, dt) = (Scalar::from_f64(0.0), Scalar::from_f64(0.5));
        for _ in 0..4 {
            let step = (time, dt);
            solver
                .advance_split(
                    Rkl2::with_stages(7),
                    &mut HalfLoop,
                    &mut state,
                    &mut work,
                    step,
                )
                .unwrap();
            time += dt;
        }
        state.digest()
    }};
}

fn all_ways_have_one_digest<S: Scalar>() {
    let number = S::from_f64;
    let mut lists = Lists::<S, 3, 2>::new();
    let problem = SLAB.problem(&mut lists).unwrap();
    let solver = SLAB.dynamics(QuinticSpline, problem, Still);
    let lean = digest!(DirectStorage::<S, 1, 1, N, CELLS>::new(), solver);
    let full = digest!(DiffusionStorage::<S, 1, 1, N, CELLS>::new(), solver);
    assert_eq!(lean, full);
    let series: Vec<_> = SERIES
        .iter()
        .map(|&(t, u)| (number(t), number(u)))
        .collect();
    let by_hand = NamedProblem {
        conductor: Conductor::Layers {
            bounds: &[number(3.0)],
            factors: &[S::ONE, number(0.1)],
        },
        walls: [[
            [DrivenCondition::Exchange {
                rate: number(0.3),
                outside: Drive::Series(&series),
            }],
            [DrivenCondition::Value(Drive::Constant(number(20.0)))],
        ]],
        ..NamedProblem::heat([number(1.7)])
    };
    assert_eq!(problem, by_hand);
}

#[test]
fn all_storages_and_ways_to_make_a_problem_have_one_digest() {
    all_ways_have_one_digest::<f64>();
    all_ways_have_one_digest::<f32>();
    all_ways_have_one_digest::<Q32<U16>>();
}

#[test]
fn what_has_no_room_is_an_error() {
    assert_eq!(
        SLAB.problem(&mut Lists::<f64, 2, 2>::new()),
        Err(Error::Lengths)
    );
    assert_eq!(
        SLAB.problem(&mut Lists::<f64, 3, 1>::new()),
        Err(Error::Lengths)
    );
    let mut lists = Lists::<f64, 3, 2>::new();
    let solver = SLAB.dynamics(QuinticSpline, SLAB.problem(&mut lists).unwrap(), Still);
    let mut storage = DirectStorage::<f64, 1, 1, N, CELLS>::new();
    for particle in SLAB.particles() {
        storage.push(particle).unwrap();
    }
    let (mut state, mut work) = storage.parts();
    let (engine, step) = (&mut HalfLoop, (0.0, 0.01));
    solver.prepare(engine, &mut state, &mut work).unwrap();
    let by_rk4 = solver.advance(&RK4, engine, &mut state, &mut work, step);
    assert_eq!(by_rk4, Err(Error::Lengths));
}
