//! What a run conserves: momentum to the rounding of velocities, energy to the order of the
//! leap-frog.

mod clouds;

use clouds::Cloud;
use fixed::types::extra::{U19, U32};
use motes_core::cutoff::CubicSpline;
use motes_core::domain::Side;
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{Gas, Width};
use motes_core::scalar::{Q32, Q64, Scalar};
use motes_solver::engine::{HostScalar, Threads};

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

/// About the middle of the box.
fn angular_momentum<S: Scalar>(gas: &Gas<'_, S, 2>) -> f64 {
    let middle = 0.5 * cloud().per_side as f64;
    let particles = gas
        .mass
        .iter()
        .zip(gas.position.iter())
        .zip(gas.velocity.iter());
    particles
        .map(|((mass, position), velocity)| {
            let [x, y] = position.map(|x| x.to_f64() - middle);
            let [u, v] = velocity.map(Scalar::to_f64);
            mass.to_f64() * (x * v - y * u)
        })
        .sum()
}

/// What should stay as it is.
struct Drift {
    /// The larger of the two, over total mass times sound speed.
    momentum: f64,
    /// Over total mass times sound speed times the side of the box.
    angular_momentum: f64,
    /// Relative.
    energy: f64,
}

/// The drift over some steps in a box with these sides.
fn drift<S: HostScalar>(side: Side, courant: f64, steps: u32) -> Drift {
    let viscosity = Pairwise(Coefficients {
        alpha: S::ONE,
        beta: S::from_f64(2.0),
    });
    let width = Width::adaptive(S::from_f64(1.2));
    let mut solver = cloud().solver([[side; 2]; 2], CubicSpline, width, viscosity);
    solver.courant = S::from_f64(courant);
    let mut arrays = cloud().arrays::<S, 2>();
    let (mut gas, mut work) = arrays.parts();
    let mut engine = Threads::new(1).unwrap();
    solver.prepare(&mut engine, &mut gas, &mut work).unwrap();
    let sums = |gas: &Gas<'_, S, 2>| {
        let momenta = [0, 1].map(|axis| momentum(gas, axis));
        (momenta, angular_momentum(gas), energy(gas))
    };
    let before = sums(&gas);
    for _ in 0..steps {
        let dt = solver.time_step(&gas, S::ONE).unwrap();
        solver
            .advance(&mut engine, &mut gas, &mut work, dt)
            .unwrap();
    }
    let after = sums(&gas);
    let mass: f64 = gas.mass.iter().map(|mass| mass.to_f64()).sum();
    let moved = [0, 1].map(|axis| (after.0[axis] - before.0[axis]).abs() / mass);
    Drift {
        momentum: moved[0].max(moved[1]),
        angular_momentum: (after.1 - before.1).abs() / (mass * cloud().per_side as f64),
        energy: (after.2 - before.2).abs() / before.2,
    }
}

/// Scalar, its last place at 1, its drift.
type Row = (&'static str, f64, fn(Side, f64, u32) -> Drift);

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
        let momentum = drift(Side::Periodic, 0.3, STEPS).momentum;
        let bound = 8.0 * ulp * (f64::from(STEPS) / particles).sqrt();
        println!("{scalar}: momentum drifts by {momentum:.1e}, bound {bound:.1e}");
        assert!(momentum < bound, "{scalar}: {momentum:e} above {bound:e}");
    }
}

/// On a free cloud: pair forces are along lines of centres. What rounding of velocities and
/// positions leaves walks as the momentum does, with an arm of about a box: a few steps, in
/// which the cloud does not expand by much.
#[test]
fn angular_momentum_drifts_by_no_more_than_rounding() {
    let particles = f64::from(14 * 14);
    const STEPS: u32 = 50;
    for (scalar, ulp, drift) in MOMENTUM {
        let drift = drift(Side::Free, 0.3, STEPS).angular_momentum;
        let bound = 8.0 * ulp * (f64::from(STEPS) / particles).sqrt();
        println!("{scalar}: angular momentum drifts by {drift:.1e}, bound {bound:.1e}");
        assert!(drift < bound, "{scalar}: {drift:e} above {bound:e}");
    }
}

/// The leap-frog's energy error over a fixed time falls with the step.
#[test]
fn energy_error_falls_with_the_time_step() {
    let errors = [1, 2, 4]
        .map(|part| drift::<f64>(Side::Periodic, 0.3 / f64::from(part), STEPS * part).energy);
    println!("energy drifts by {errors:?} at steps of 1, 1/2 and 1/4");
    // 2.52e-4, all of it of the viscosity: 2e-4 where pressures, too, go by the trapezoidal rule.
    assert!(errors[0] < 2.6e-4, "{errors:?}");
    let order = (errors[0] / errors[2]).log2() / 2.0;
    assert!((1.9..2.2).contains(&order), "order {order} from {errors:?}");
}
