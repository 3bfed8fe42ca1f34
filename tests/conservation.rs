//! What a run conserves: momentum to the rounding of velocities, energy to the order of the
//! leap-frog.

mod clouds;

use clouds::Cloud;
use fixed::types::extra::{U19, U32};
use motes::engine::{HostScalar, Threads};
use motes_core::cutoff::CubicSpline;
use motes_core::domain::Side;
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{Gas, Width};
use motes_core::scalar::{Q32, Q64, Scalar};

const STEPS: u32 = 200;

fn cloud() -> Cloud {
    Cloud {
        per_side: 14,
        seed: 5,
        disorder: 0.3,
        speed: 0.4,
        masses: 0.3,
        eta: 1.2,
    }
}

fn momentum<S: Scalar>(gas: &Gas<'_, S, 2>, axis: usize) -> f64 {
    let terms = gas.mass.iter().zip(gas.velocity.iter());
    terms
        .map(|(mass, velocity)| mass.to_f64() * velocity[axis].to_f64())
        .sum()
}

fn energy<S: Scalar>(gas: &Gas<'_, S, 2>) -> f64 {
    let particles = gas
        .mass
        .iter()
        .zip(gas.velocity.iter())
        .zip(gas.energy.iter());
    particles
        .map(|((mass, velocity), energy)| {
            let [u, v] = velocity.map(Scalar::to_f64);
            mass.to_f64() * (energy.to_f64() + 0.5 * (u * u + v * v))
        })
        .sum()
}

/// Drift of the two momenta over total mass times sound speed, and relative drift of the
/// energy, over some steps in a periodic box.
fn drift<S: HostScalar>(courant: f64, steps: u32) -> (f64, f64) {
    let viscosity = Pairwise(Coefficients {
        alpha: S::ONE,
        beta: S::from_f64(2.0),
    });
    let width = Width::Adaptive {
        eta: S::from_f64(1.2),
    };
    let mut solver = cloud().solver([[Side::Periodic; 2]; 2], CubicSpline, width, viscosity);
    solver.courant = S::from_f64(courant);
    let mut arrays = cloud().arrays::<S, 2>();
    let (mut gas, mut work) = arrays.parts();
    let mut engine = Threads::new(1).unwrap();
    solver.prepare(&mut engine, &mut gas, &mut work).unwrap();
    let before = ([0, 1].map(|axis| momentum(&gas, axis)), energy(&gas));
    for _ in 0..steps {
        let dt = solver.time_step(&gas, S::ONE).unwrap();
        solver
            .advance(&mut engine, &mut gas, &mut work, dt)
            .unwrap();
    }
    let mass: f64 = gas.mass.iter().map(|mass| mass.to_f64()).sum();
    let moved = [0, 1].map(|axis| (momentum(&gas, axis) - before.0[axis]).abs() / mass);
    (
        moved[0].max(moved[1]),
        (energy(&gas) - before.1).abs() / before.1,
    )
}

/// Scalar, its last place at 1, its drift.
type Row = (&'static str, f64, fn(f64, u32) -> (f64, f64));

/// Every step rounds the velocity of each particle about four times, without a bias: over n
/// particles and s steps the mean velocity walks by about `4 ulp (s/n)^(1/2) / 2`. The bound is
/// four times that and the measured drift; a bias would give `s ulp`.
const MOMENTUM: [Row; 4] = [
    ("f64", 1.1e-16, drift::<f64>),
    ("f32", 6.0e-8, drift::<f32>),
    ("q12.19", 1.9e-6, drift::<Q32<U19>>),
    ("q31.32", 2.3e-10, drift::<Q64<U32>>),
];

#[test]
fn momentum_drifts_by_no_more_than_rounding() {
    let particles = f64::from(14 * 14);
    for (scalar, ulp, drift) in MOMENTUM {
        let (momentum, _) = drift(0.3, STEPS);
        let bound = 8.0 * ulp * (f64::from(STEPS) / particles).sqrt();
        println!("{scalar}: momentum drifts by {momentum:.1e}, bound {bound:.1e}");
        assert!(momentum < bound, "{scalar}: {momentum:e} above {bound:e}");
    }
}

/// The leap-frog's energy error over a fixed time falls with the step.
#[test]
fn energy_error_falls_with_the_time_step() {
    let errors = [1, 2, 4].map(|part| drift::<f64>(0.3 / f64::from(part), STEPS * part).1);
    println!("energy drifts by {errors:?} at steps of 1, 1/2 and 1/4");
    assert!(errors[0] < 2e-4, "{errors:?}");
    let order = (errors[0] / errors[2]).log2() / 2.0;
    assert!((0.8..2.2).contains(&order), "order {order} from {errors:?}");
}
