//! Steps that are shorter than the last place of a position add up.

use fixed::types::extra::{U16, U19, U32};
use motes_core::cutoff::CubicSpline;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{GasDynamics, Packing, Particle, Plain, PlainStorage, Width};
use motes_core::error::Error;
use motes_core::material::{IdealGas, Named};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;
use motes_core::scalar::{Checked, Micro, Q32, Q64, Scalar};

const N: usize = 8;
const CELLS: usize = cell_bound(N as u32) as usize + 1;
const STEPS: u32 = 2000;
/// In last places of a position a step.
const SPEED: f64 = 0.3;

/// How far a uniform stream between 16 and 24 has gone after so many steps, in last places, and how far it
/// should have; `place` is the last place there.
fn gone<S: Scalar>(place: f64) -> Result<[f64; 2], Error> {
    let dynamics = GasDynamics {
        domain: Domain {
            axes: [Axis::periodic(S::count(16), S::count(16 + N as u32))],
        },
        cut_off: CubicSpline,
        width: Width::Adaptive {
            eta: S::ONE,
            packing: Packing::Cubic,
        },
        viscosity: Pairwise(Coefficients {
            alpha: S::ZERO,
            beta: S::ZERO,
        }),
        materials: &[Named::IdealGas(IdealGas::new(1.4))],
        physics: Plain::DEFAULT,
        courant: S::from_f64(0.3),
        smallest_omega: S::from_f64(1.0 / 32.0),
    };
    let mut storage = PlainStorage::<S, 1, N, CELLS>::new();

    for k in 0..N {
        storage.push(Particle {
            position: [S::from_f64(16.25 + k as f64)],
            velocity: [S::from_f64(SPEED)],
            mass: S::ONE,
            energy: S::from_f64(0.25),
            epsilon: S::ONE,
            material: 0,
        })?;
    }
    let (mut gas, mut work) = storage.parts();
    dynamics.prepare(&mut HalfLoop, &mut gas, &mut work)?;
    let start = gas.position[0][0].to_f64();
    for _ in 0..STEPS {
        dynamics.advance(&mut HalfLoop, &mut gas, &mut work, S::from_f64(place))?;
    }
    let gone = (gas.position[0][0].to_f64() - start) / place;
    Ok([gone, gas.velocity[0][0].to_f64() * f64::from(STEPS)])
}

fn goes<S: Scalar>(place: f64) {
    let [gone, expected] = gone::<S>(place).unwrap();
    let off = (gone - expected).abs();
    assert!(off <= 1.0, "{gone} for {expected} places");
}

#[test]
fn a_stream_goes_where_its_speed_leads_it() {
    goes::<f32>(2f64.powi(-19));
    goes::<Micro>(2f64.powi(-19));
    goes::<Q32<U19>>(2f64.powi(-19));
    goes::<Q32<U16>>(2f64.powi(-16));
    goes::<Q64<U32>>(2f64.powi(-32));
    goes::<Checked<Q32<U19>>>(2f64.powi(-19));
}
