//! Physical viscosity in every scalar: a shear wave decays by `ν k²` between walls, momentum is exact in
//! fixed point, and what is proven to fit a format does.

use std::f64::consts::PI;

mod made;

use fixed::types::extra::{U16, U19, U32};
use made::{Made, agree};
use motes_core::cutoff::WendlandC2;
use motes_core::digest::Digest;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::Inviscid;
use motes_core::equation::gas::{
    Diffusion, Gas, GasDynamics, NoSlip, Options, OptionsStorage, Particle, Width,
};
use motes_core::error::{Error, Parameter};
use motes_core::integrator::{LeapFrog, Stepper};
use motes_core::material::Isothermal;
use motes_core::neighbours::cell_bound;
use motes_core::pairs::{Engine, HalfLoop, PlainLoop};
use motes_core::scalar::{Checked, Q32, Q64, Scalar};

const COLUMNS: usize = 24;
const ROWS: usize = 9;
const N: usize = COLUMNS * ROWS;
const CELLS: usize = cell_bound(N as u32) as usize + 1;
const ETA: f64 = 1.3;

type Memory<S> = OptionsStorage<S, 2, N, CELLS>;
type Plane<'a, S> = GasDynamics<'a, S, WendlandC2, Inviscid, Isothermal<S>, Options<S, 2>, 2>;

/// Between walls across the first direction, periodic along the second.
fn plane<S: Scalar>(material: &[Isothermal<S>; 1], diffusion: [f64; 2]) -> Plane<'_, S> {
    let [viscosity, bulk_viscosity] = diffusion.map(S::from_f64);
    GasDynamics {
        domain: Domain {
            axes: [
                Axis::walls(S::ZERO, S::count(COLUMNS as u32)),
                Axis::periodic(S::ZERO, S::count(ROWS as u32)),
            ],
        },
        cut_off: WendlandC2,
        width: Width::adaptive(S::from_f64(ETA)),
        viscosity: Inviscid,
        materials: material,
        physics: Options {
            diffusion: Diffusion {
                viscosity,
                bulk_viscosity,
                heat: S::ZERO,
            },
            ..Options::OFF
        },
        courant: S::from_f64(0.3),
        smallest_omega: S::from_f64(1.0 / 32.0),
    }
}

/// Half a wave between the walls: where they let it slip `u_y = A cos(π x/L)`, where it sticks to them
/// `A sin(π x/L)`.
fn wave(x: f64, sticks: bool) -> f64 {
    let phase = PI * x / COLUMNS as f64;
    if sticks { phase.sin() } else { phase.cos() }
}

fn memory<S: Scalar>(amplitude: f64, sticks: bool) -> Memory<S> {
    let mut memory = Memory::<S>::new();
    for k in 0..N {
        let [x, y] = [k / ROWS, k % ROWS].map(|i| i as f64 + 0.5);
        let particle = Particle {
            position: [x, y].map(S::from_f64),
            velocity: [S::ZERO, S::from_f64(amplitude * wave(x, sticks))],
            mass: S::ONE,
            energy: S::ONE,
            epsilon: S::from_f64(ETA),
            material: 0,
        };
        memory.push(particle).unwrap();
    }
    memory
}

fn amplitude<S: Scalar>(gas: &Gas<'_, S, 2>, sticks: bool) -> f64 {
    let terms = gas.position.iter().zip(gas.velocity.iter());
    let sum: f64 = terms
        .map(|(x, u)| u[1].to_f64() * wave(x[0].to_f64(), sticks))
        .sum();
    2.0 * sum / gas.len() as f64
}

/// The rate of decay over `ν k²`, and what the momentum along walls has come to that it slips along.
fn decay<S: Scalar>(sticks: bool) -> (f64, f64) {
    let (size, nu, k) = (0.25, 0.5, PI / COLUMNS as f64);
    let material = [Isothermal::new(0.125)];
    let mut dynamics = plane::<S>(&material, [nu, 0.0]);
    if sticks {
        dynamics.physics.walls = stuck(0.0);
    }
    let memory = memory::<S>(size, sticks);
    let mut run = Stepper::new(dynamics, LeapFrog, HalfLoop, memory).unwrap();
    let before = amplitude(&run.state(), sticks);
    while run.clock().time.to_f64() < 0.1 / (nu * k * k) {
        run.step().unwrap();
    }
    let time = run.clock().time.to_f64();
    let rate = (before / amplitude(&run.state(), sticks)).ln() / (nu * k * k * time);
    let momentum: f64 = run.state().velocity.iter().map(|u| u[1].to_f64()).sum();
    (rate, momentum.abs() / N as f64)
}

/// Scalar, bound of the error of the rate, last place, decay.
type Row = (&'static str, f64, f64, fn(bool) -> (f64, f64));

/// At 48 particles a wave the width takes 0.2 %; the sums are 4 % less than integrals, and normalised. In q15.16 the terms of a pair, 1e-3 and less, are rounded
/// to 1.5e-5: to 2 % of the smaller ones.
const ROWS_OF: [Row; 5] = [
    ("f64", 0.005, 1.1e-16, decay::<f64>),
    ("f32", 0.005, 6.0e-8, decay::<f32>),
    ("q31.32", 0.005, 2.3e-10, decay::<Q64<U32>>),
    ("q12.19", 0.01, 1.9e-6, decay::<Q32<U19>>),
    ("q15.16", 0.02, 1.5e-5, decay::<Q32<U16>>),
];

#[test]
fn a_shear_wave_between_walls_decays_by_the_viscosity_in_every_scalar() {
    for (scalar, bound, ulp, decay) in ROWS_OF {
        let (rate, momentum) = decay(false);
        println!("{scalar}: {rate:.5} of the exact rate, momentum {momentum:e}");
        assert!((rate - 1.0).abs() < bound, "{scalar}: {rate}");
        // Velocities are rounded in every step, 100 or so, without a bias.
        assert!(momentum < 8.0 * ulp, "{scalar}: {momentum:e}");
    }
}

#[test]
fn a_shear_wave_between_walls_that_it_sticks_to_decays_by_the_viscosity_in_every_scalar() {
    for (scalar, bound, _, decay) in ROWS_OF {
        let (rate, _) = decay(true);
        println!("{scalar}: {rate:.5} of the exact rate");
        assert!((rate - 1.0).abs() < bound, "{scalar}: {rate}");
    }
}

/// Nothing slips along the walls, and the upper one moves.
fn stuck<S: Scalar>(speed: f64) -> NoSlip<S, 2> {
    let upper = [S::ZERO, S::from_f64(speed)];
    NoSlip {
        velocity: [[Some([S::ZERO; 2]), Some(upper)], [None; 2]],
    }
}

fn steps<S: Scalar>(amplitude: f64, diffusion: [f64; 2], walls: NoSlip<S, 2>) -> Made {
    let material = [Isothermal::new(0.125)];
    let mut dynamics = plane::<S>(&material, diffusion);
    dynamics.physics.walls = walls;
    let made = Stepper::new(dynamics, LeapFrog, HalfLoop, memory::<S>(amplitude, false))
        .and_then(|mut run| (0..3).try_for_each(|_| run.step().map(|_| ())));
    Made::from(made)
}

#[test]
fn a_proven_stress_does_not_overflow() {
    type Q = Q32<U19>;
    let mut pairs = Vec::new();
    for power in [-2, 2, 5, 7, 9, 11] {
        let size = 2f64.powi(power);
        for (velocity, diffusion) in [
            (size, [0.5, 0.0]),
            (size, [0.0, 0.5]),
            (1.0, [size, 0.0]),
            (1.0, [size, size]),
        ] {
            let guarded = steps::<Q>(velocity, diffusion, NoSlip::NONE);
            let marked = steps::<Checked<Q>>(velocity, diffusion, NoSlip::NONE);
            pairs.push((guarded, marked));
        }
    }
    agree(&pairs);
}

#[test]
fn proven_walls_do_not_overflow() {
    type Q = Q32<U19>;
    let speeds = (0..11).map(|power| f64::from(1 << power));
    let steps_at = |speed| {
        let guarded = steps::<Q>(1.0, [0.5, 0.25], stuck(speed));
        (guarded, steps::<Checked<Q>>(1.0, [0.5, 0.25], stuck(speed)))
    };
    agree(&speeds.map(steps_at).collect::<Vec<_>>());
}

/// The order of summation and the two ends of a pair are the same in both loops of the core.
#[test]
fn both_loops_give_the_same_bits() {
    fn digests<S: Scalar>() -> [Digest; 2] {
        fn digest<S: Scalar>(engine: impl Engine<S, 2>) -> Digest {
            let material = [Isothermal::new(0.125)];
            let mut dynamics = plane::<S>(&material, [0.5, 0.25]);
            dynamics.physics.walls = stuck(0.25);
            let memory = memory::<S>(0.25, false);
            let mut run = Stepper::new(dynamics, LeapFrog, engine, memory).unwrap();
            for _ in 0..5 {
                run.step().unwrap();
            }
            run.state().digest()
        }
        [digest::<S>(HalfLoop), digest::<S>(PlainLoop)]
    }
    for [half, plain] in [digests::<f64>(), digests::<f32>(), digests::<Q32<U16>>()] {
        assert_eq!(half, plain);
    }
}

/// A wall that leaves its place, or whose velocity is no number, is refused before it meets the state.
#[test]
fn impossible_walls_are_refused() {
    let material = [Isothermal::new(0.125)];
    for velocity in [[0.25, 0.0], [0.0, f64::NAN], [0.0, f64::INFINITY]] {
        let mut dynamics = plane::<f64>(&material, [0.5, 0.0]);
        let memory = memory::<f64>(0.25, true);
        dynamics.physics.walls = stuck(0.0);
        let mut run = Stepper::new(dynamics, LeapFrog, HalfLoop, memory).unwrap();
        let before = run.state().digest();
        run.dynamics.physics.walls.velocity[0][1] = Some(velocity);
        let parameter = Parameter::Wall { axis: 0, end: 1 };
        assert_eq!(run.step(), Err(Error::Parameter { parameter }));
        assert_eq!(run.state().digest(), before);
    }
}
