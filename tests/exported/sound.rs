//! Made by `motes export tests/exported/sound.toml`, not by hand.
//!
//! Before a device runs it in a scalar, `motes run` tells whether the scalar can hold it.
//!
//! In memory that lies still, `static` on a device, and to the end:
//!
//! ```ignore
//! let mut run = start::<f32>(&mut memory)?;
//! while run.step()?.is_some() {}
//! run.state().digest() // that of `motes run` with this scalar
//! ```
//!
//! It needs the crate `libm`, in the version of `motes-core`.
#![allow(clippy::approx_constant)]

use motes_core::cloud::Frame;
use motes_core::cutoff::Named as CutOff;
use motes_core::domain::{Axis, Domain, Side};
use motes_core::equation::linear::systems::{Acoustics, Units};
use motes_core::equation::linear::{
    Addition, FirstOrderSystem, LinearDynamics, LinearStorage, Particle, Place, Rotation, Sourced,
};
use motes_core::error::Error;
use motes_core::integrator::{SSP_RK3, Stepper};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = "sound";

/// Number of particles.
pub const PARTICLES: usize = 216;

/// Cells they can take, and one.
pub const CELLS: usize = 993;

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::CubicSpline;

/// The way between the solver's numbers and those of the scenario.
pub const FRAME: Frame = Frame {
    middle: [0.0, 0.0, 0.0],
    units: Units {
        length: 0.33333333333333337,
        velocity: 2.0,
    },
};

/// The source: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct Supply;

impl<S: Scalar> Addition<S, 3, 4> for Supply {
    fn add(&self, place: &Place<S, 3>, rates: &mut [S; 4]) {
        let [x, y, z, t] = FRAME.point(place);
        rates[0] += FRAME.rate::<S>({
            let v0 = libm::exp(-8.0 * elementary::power(libm::sqrt(x * x + y * y + z * z), 2.0));
            v0 * libm::sin(9.0 * t)
        });
        rates[1] += FRAME.rate::<S>(0.0);
        rates[2] += FRAME.rate::<S>(0.0);
        rates[3] += FRAME.rate::<S>(0.1 * z);
    }
}

/// The equations without that source.
fn unsourced<S: Scalar>() -> Acoustics<S> {
    let units = Units {
        length: 0.33333333333333337,
        velocity: 2.0,
    };
    Acoustics::new(1.3, 2.0, units)
}

/// The equations.
pub fn system<S: Scalar>() -> Sourced<Acoustics<S>, Supply> {
    Sourced {
        system: unsourced(),
        source: Supply,
    }
}

/// What the particles follow.
pub fn motion<S: Scalar>() -> Rotation<S, 3> {
    Rotation {
        rate: S::from_f64(0.06666666666666668),
        center: [S::from_f64(0.3), S::from_f64(0.0), S::from_f64(0.0)],
    }
}

/// The domain, in solver units.
pub fn domain<S: Scalar>() -> Domain<S, 3> {
    Domain {
        axes: [
            Axis {
                lower: S::from_f64(-3.0),
                upper: S::from_f64(3.0),
                sides: [Side::Free, Side::Free],
            },
            Axis {
                lower: S::from_f64(-3.0),
                upper: S::from_f64(3.0),
                sides: [Side::Free, Side::Free],
            },
            Axis {
                lower: S::from_f64(-3.0),
                upper: S::from_f64(3.0),
                sides: [Side::Periodic, Side::Periodic],
            },
        ],
    }
}

/// The particles at the start, in solver units.
#[rustfmt::skip]
pub static CLOUD: [Particle<f64, 3, 4>; PARTICLES] = [
    Particle { position: [-2.5, -2.5, -2.5], weight: 1.0, value: [0.00024036947641951364, 0.0, 0.06944444444444446, 0.0] },
    Particle { position: [-2.5, -2.5, -1.5], weight: 1.0, value: [0.0014221925405226796, 0.0, 0.06944444444444446, 0.0] },
    Particle { position: [-2.5, -2.5, -0.4999999999999999], weight: 1.0, value: [0.0034593773364647584, 0.0, 0.06944444444444446, 0.0] },
    Particle { position: [-2.5, -2.5, 0.5000000000000002], weight: 1.0, value: [0.0034593773364647524, 0.0, 0.06944444444444446, 0.0] },
    Particle { position: [-2.5, -2.5, 1.5], weight: 1.0, value: [0.0014221925405226796, 0.0, 0.06944444444444446, 0.0] },
    Particle { position: [-2.5, -2.5, 2.5], weight: 1.0, value: [0.00024036947641951364, 0.0, 0.06944444444444446, 0.0] },
    Particle { position: [-2.5, -1.5, -2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-2.5, -1.5, -1.5], weight: 1.0, value: [0.00841467748920115, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-2.5, -1.5, -0.4999999999999999], weight: 1.0, value: [0.020468075714350484, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-2.5, -1.5, 0.5000000000000002], weight: 1.0, value: [0.020468075714350484, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-2.5, -1.5, 1.5], weight: 1.0, value: [0.00841467748920115, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-2.5, -1.5, 2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-2.5, -0.4999999999999999, -2.5], weight: 1.0, value: [0.0034593773364647524, 0.0, 0.013888888888888888, 0.0] },
    Particle { position: [-2.5, -0.4999999999999999, -1.5], weight: 1.0, value: [0.020468075714350484, 0.0, 0.013888888888888888, 0.0] },
    Particle { position: [-2.5, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [0.049787068367863924, 0.0, 0.013888888888888888, 0.0] },
    Particle { position: [-2.5, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [0.049787068367863924, 0.0, 0.013888888888888888, 0.0] },
    Particle { position: [-2.5, -0.4999999999999999, 1.5], weight: 1.0, value: [0.020468075714350484, 0.0, 0.013888888888888888, 0.0] },
    Particle { position: [-2.5, -0.4999999999999999, 2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, 0.013888888888888888, 0.0] },
    Particle { position: [-2.5, 0.5000000000000002, -2.5], weight: 1.0, value: [0.0034593773364647524, 0.0, -0.013888888888888897, 0.0] },
    Particle { position: [-2.5, 0.5000000000000002, -1.5], weight: 1.0, value: [0.020468075714350484, 0.0, -0.013888888888888897, 0.0] },
    Particle { position: [-2.5, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [0.049787068367863924, 0.0, -0.013888888888888897, 0.0] },
    Particle { position: [-2.5, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [0.049787068367863924, 0.0, -0.013888888888888897, 0.0] },
    Particle { position: [-2.5, 0.5000000000000002, 1.5], weight: 1.0, value: [0.020468075714350484, 0.0, -0.013888888888888897, 0.0] },
    Particle { position: [-2.5, 0.5000000000000002, 2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.013888888888888897, 0.0] },
    Particle { position: [-2.5, 1.5, -2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [-2.5, 1.5, -1.5], weight: 1.0, value: [0.00841467748920115, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [-2.5, 1.5, -0.4999999999999999], weight: 1.0, value: [0.020468075714350484, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [-2.5, 1.5, 0.5000000000000002], weight: 1.0, value: [0.020468075714350484, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [-2.5, 1.5, 1.5], weight: 1.0, value: [0.00841467748920115, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [-2.5, 1.5, 2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [-2.5, 2.5, -2.5], weight: 1.0, value: [0.00024036947641951364, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [-2.5, 2.5, -1.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [-2.5, 2.5, -0.4999999999999999], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [-2.5, 2.5, 0.5000000000000002], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [-2.5, 2.5, 1.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [-2.5, 2.5, 2.5], weight: 1.0, value: [0.0002403694764195145, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [-1.5, -2.5, -2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-1.5, -2.5, -1.5], weight: 1.0, value: [0.00841467748920115, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-1.5, -2.5, -0.4999999999999999], weight: 1.0, value: [0.020468075714350484, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-1.5, -2.5, 0.5000000000000002], weight: 1.0, value: [0.020468075714350484, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-1.5, -2.5, 1.5], weight: 1.0, value: [0.00841467748920115, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-1.5, -2.5, 2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, 0.04166666666666667, 0.0] },
    Particle { position: [-1.5, -1.5, -2.5], weight: 1.0, value: [0.00841467748920115, 0.0, 0.025, 0.0] },
    Particle { position: [-1.5, -1.5, -1.5], weight: 1.0, value: [0.049787068367863965, 0.0, 0.025, 0.0] },
    Particle { position: [-1.5, -1.5, -0.4999999999999999], weight: 1.0, value: [0.12110333239232973, 0.0, 0.025, 0.0] },
    Particle { position: [-1.5, -1.5, 0.5000000000000002], weight: 1.0, value: [0.12110333239232973, 0.0, 0.025, 0.0] },
    Particle { position: [-1.5, -1.5, 1.5], weight: 1.0, value: [0.049787068367863965, 0.0, 0.025, 0.0] },
    Particle { position: [-1.5, -1.5, 2.5], weight: 1.0, value: [0.008414677489201165, 0.0, 0.025, 0.0] },
    Particle { position: [-1.5, -0.4999999999999999, -2.5], weight: 1.0, value: [0.020468075714350484, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-1.5, -0.4999999999999999, -1.5], weight: 1.0, value: [0.12110333239232973, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-1.5, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [0.2945748283101073, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-1.5, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [0.2945748283101073, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-1.5, -0.4999999999999999, 1.5], weight: 1.0, value: [0.12110333239232973, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-1.5, -0.4999999999999999, 2.5], weight: 1.0, value: [0.020468075714350505, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-1.5, 0.5000000000000002, -2.5], weight: 1.0, value: [0.020468075714350484, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [-1.5, 0.5000000000000002, -1.5], weight: 1.0, value: [0.12110333239232973, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [-1.5, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [0.2945748283101073, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [-1.5, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [0.2945748283101073, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [-1.5, 0.5000000000000002, 1.5], weight: 1.0, value: [0.12110333239232973, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [-1.5, 0.5000000000000002, 2.5], weight: 1.0, value: [0.020468075714350505, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [-1.5, 1.5, -2.5], weight: 1.0, value: [0.00841467748920115, 0.0, -0.025, 0.0] },
    Particle { position: [-1.5, 1.5, -1.5], weight: 1.0, value: [0.049787068367863965, 0.0, -0.025, 0.0] },
    Particle { position: [-1.5, 1.5, -0.4999999999999999], weight: 1.0, value: [0.12110333239232973, 0.0, -0.025, 0.0] },
    Particle { position: [-1.5, 1.5, 0.5000000000000002], weight: 1.0, value: [0.12110333239232973, 0.0, -0.025, 0.0] },
    Particle { position: [-1.5, 1.5, 1.5], weight: 1.0, value: [0.049787068367863965, 0.0, -0.025, 0.0] },
    Particle { position: [-1.5, 1.5, 2.5], weight: 1.0, value: [0.008414677489201165, 0.0, -0.025, 0.0] },
    Particle { position: [-1.5, 2.5, -2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [-1.5, 2.5, -1.5], weight: 1.0, value: [0.008414677489201165, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [-1.5, 2.5, -0.4999999999999999], weight: 1.0, value: [0.020468075714350505, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [-1.5, 2.5, 0.5000000000000002], weight: 1.0, value: [0.020468075714350505, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [-1.5, 2.5, 1.5], weight: 1.0, value: [0.008414677489201165, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [-1.5, 2.5, 2.5], weight: 1.0, value: [0.001422192540522682, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [-0.4999999999999999, -2.5, -2.5], weight: 1.0, value: [0.0034593773364647524, 0.0, 0.013888888888888886, 0.0] },
    Particle { position: [-0.4999999999999999, -2.5, -1.5], weight: 1.0, value: [0.020468075714350484, 0.0, 0.013888888888888886, 0.0] },
    Particle { position: [-0.4999999999999999, -2.5, -0.4999999999999999], weight: 1.0, value: [0.049787068367863924, 0.0, 0.013888888888888886, 0.0] },
    Particle { position: [-0.4999999999999999, -2.5, 0.5000000000000002], weight: 1.0, value: [0.049787068367863924, 0.0, 0.013888888888888886, 0.0] },
    Particle { position: [-0.4999999999999999, -2.5, 1.5], weight: 1.0, value: [0.020468075714350484, 0.0, 0.013888888888888886, 0.0] },
    Particle { position: [-0.4999999999999999, -2.5, 2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, 0.013888888888888886, 0.0] },
    Particle { position: [-0.4999999999999999, -1.5, -2.5], weight: 1.0, value: [0.020468075714350484, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, -1.5, -1.5], weight: 1.0, value: [0.12110333239232973, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, -1.5, -0.4999999999999999], weight: 1.0, value: [0.2945748283101073, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, -1.5, 0.5000000000000002], weight: 1.0, value: [0.2945748283101073, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, -1.5, 1.5], weight: 1.0, value: [0.12110333239232973, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, -1.5, 2.5], weight: 1.0, value: [0.020468075714350505, 0.0, 0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, -2.5], weight: 1.0, value: [0.049787068367863924, 0.0, 0.0027777777777777766, 0.0] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, -1.5], weight: 1.0, value: [0.29457482831010745, 0.0, 0.0027777777777777766, 0.0] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [0.7165313105737894, 0.0, 0.0027777777777777766, 0.0] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [0.7165313105737892, 0.0, 0.0027777777777777766, 0.0] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, 1.5], weight: 1.0, value: [0.29457482831010745, 0.0, 0.0027777777777777766, 0.0] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, 2.5], weight: 1.0, value: [0.049787068367863965, 0.0, 0.0027777777777777766, 0.0] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, -2.5], weight: 1.0, value: [0.049787068367863924, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, -1.5], weight: 1.0, value: [0.2945748283101073, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [0.7165313105737893, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [0.7165313105737892, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, 1.5], weight: 1.0, value: [0.2945748283101073, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, 2.5], weight: 1.0, value: [0.049787068367863965, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [-0.4999999999999999, 1.5, -2.5], weight: 1.0, value: [0.020468075714350484, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, 1.5, -1.5], weight: 1.0, value: [0.12110333239232973, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, 1.5, -0.4999999999999999], weight: 1.0, value: [0.2945748283101073, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, 1.5, 0.5000000000000002], weight: 1.0, value: [0.2945748283101073, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, 1.5, 1.5], weight: 1.0, value: [0.12110333239232973, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, 1.5, 2.5], weight: 1.0, value: [0.020468075714350505, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [-0.4999999999999999, 2.5, -2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [-0.4999999999999999, 2.5, -1.5], weight: 1.0, value: [0.020468075714350505, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [-0.4999999999999999, 2.5, -0.4999999999999999], weight: 1.0, value: [0.049787068367863965, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [-0.4999999999999999, 2.5, 0.5000000000000002], weight: 1.0, value: [0.049787068367863965, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [-0.4999999999999999, 2.5, 1.5], weight: 1.0, value: [0.020468075714350505, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [-0.4999999999999999, 2.5, 2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [0.5000000000000002, -2.5, -2.5], weight: 1.0, value: [0.0034593773364647524, 0.0, -0.013888888888888895, 0.0] },
    Particle { position: [0.5000000000000002, -2.5, -1.5], weight: 1.0, value: [0.020468075714350484, 0.0, -0.013888888888888895, 0.0] },
    Particle { position: [0.5000000000000002, -2.5, -0.4999999999999999], weight: 1.0, value: [0.049787068367863924, 0.0, -0.013888888888888895, 0.0] },
    Particle { position: [0.5000000000000002, -2.5, 0.5000000000000002], weight: 1.0, value: [0.049787068367863924, 0.0, -0.013888888888888895, 0.0] },
    Particle { position: [0.5000000000000002, -2.5, 1.5], weight: 1.0, value: [0.020468075714350484, 0.0, -0.013888888888888895, 0.0] },
    Particle { position: [0.5000000000000002, -2.5, 2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.013888888888888895, 0.0] },
    Particle { position: [0.5000000000000002, -1.5, -2.5], weight: 1.0, value: [0.020468075714350484, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, -1.5, -1.5], weight: 1.0, value: [0.12110333239232973, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, -1.5, -0.4999999999999999], weight: 1.0, value: [0.2945748283101073, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, -1.5, 0.5000000000000002], weight: 1.0, value: [0.2945748283101073, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, -1.5, 1.5], weight: 1.0, value: [0.12110333239232973, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, -1.5, 2.5], weight: 1.0, value: [0.020468075714350505, 0.0, -0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, -2.5], weight: 1.0, value: [0.049787068367863924, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, -1.5], weight: 1.0, value: [0.2945748283101073, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [0.7165313105737893, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [0.7165313105737892, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, 1.5], weight: 1.0, value: [0.2945748283101073, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, 2.5], weight: 1.0, value: [0.049787068367863965, 0.0, -0.0027777777777777783, 0.0] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, -2.5], weight: 1.0, value: [0.049787068367863924, 0.0, 0.00277777777777778, 0.0] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, -1.5], weight: 1.0, value: [0.2945748283101073, 0.0, 0.00277777777777778, 0.0] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [0.7165313105737892, 0.0, 0.00277777777777778, 0.0] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [0.7165313105737889, 0.0, 0.00277777777777778, 0.0] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, 1.5], weight: 1.0, value: [0.2945748283101073, 0.0, 0.00277777777777778, 0.0] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, 2.5], weight: 1.0, value: [0.049787068367863965, 0.0, 0.00277777777777778, 0.0] },
    Particle { position: [0.5000000000000002, 1.5, -2.5], weight: 1.0, value: [0.020468075714350484, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, 1.5, -1.5], weight: 1.0, value: [0.12110333239232973, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, 1.5, -0.4999999999999999], weight: 1.0, value: [0.2945748283101073, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, 1.5, 0.5000000000000002], weight: 1.0, value: [0.2945748283101073, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, 1.5, 1.5], weight: 1.0, value: [0.12110333239232973, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, 1.5, 2.5], weight: 1.0, value: [0.020468075714350505, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [0.5000000000000002, 2.5, -2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, 0.013888888888888893, 0.0] },
    Particle { position: [0.5000000000000002, 2.5, -1.5], weight: 1.0, value: [0.020468075714350505, 0.0, 0.013888888888888893, 0.0] },
    Particle { position: [0.5000000000000002, 2.5, -0.4999999999999999], weight: 1.0, value: [0.049787068367863965, 0.0, 0.013888888888888893, 0.0] },
    Particle { position: [0.5000000000000002, 2.5, 0.5000000000000002], weight: 1.0, value: [0.049787068367863965, 0.0, 0.013888888888888893, 0.0] },
    Particle { position: [0.5000000000000002, 2.5, 1.5], weight: 1.0, value: [0.020468075714350505, 0.0, 0.013888888888888893, 0.0] },
    Particle { position: [0.5000000000000002, 2.5, 2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, 0.013888888888888893, 0.0] },
    Particle { position: [1.5, -2.5, -2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [1.5, -2.5, -1.5], weight: 1.0, value: [0.00841467748920115, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [1.5, -2.5, -0.4999999999999999], weight: 1.0, value: [0.020468075714350484, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [1.5, -2.5, 0.5000000000000002], weight: 1.0, value: [0.020468075714350484, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [1.5, -2.5, 1.5], weight: 1.0, value: [0.00841467748920115, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [1.5, -2.5, 2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.04166666666666667, 0.0] },
    Particle { position: [1.5, -1.5, -2.5], weight: 1.0, value: [0.00841467748920115, 0.0, -0.025, 0.0] },
    Particle { position: [1.5, -1.5, -1.5], weight: 1.0, value: [0.049787068367863965, 0.0, -0.025, 0.0] },
    Particle { position: [1.5, -1.5, -0.4999999999999999], weight: 1.0, value: [0.12110333239232973, 0.0, -0.025, 0.0] },
    Particle { position: [1.5, -1.5, 0.5000000000000002], weight: 1.0, value: [0.12110333239232973, 0.0, -0.025, 0.0] },
    Particle { position: [1.5, -1.5, 1.5], weight: 1.0, value: [0.049787068367863965, 0.0, -0.025, 0.0] },
    Particle { position: [1.5, -1.5, 2.5], weight: 1.0, value: [0.008414677489201165, 0.0, -0.025, 0.0] },
    Particle { position: [1.5, -0.4999999999999999, -2.5], weight: 1.0, value: [0.020468075714350484, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [1.5, -0.4999999999999999, -1.5], weight: 1.0, value: [0.12110333239232973, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [1.5, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [0.2945748283101073, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [1.5, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [0.2945748283101073, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [1.5, -0.4999999999999999, 1.5], weight: 1.0, value: [0.12110333239232973, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [1.5, -0.4999999999999999, 2.5], weight: 1.0, value: [0.020468075714350505, 0.0, -0.008333333333333331, 0.0] },
    Particle { position: [1.5, 0.5000000000000002, -2.5], weight: 1.0, value: [0.020468075714350484, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [1.5, 0.5000000000000002, -1.5], weight: 1.0, value: [0.12110333239232973, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [1.5, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [0.2945748283101073, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [1.5, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [0.2945748283101073, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [1.5, 0.5000000000000002, 1.5], weight: 1.0, value: [0.12110333239232973, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [1.5, 0.5000000000000002, 2.5], weight: 1.0, value: [0.020468075714350505, 0.0, 0.008333333333333337, 0.0] },
    Particle { position: [1.5, 1.5, -2.5], weight: 1.0, value: [0.00841467748920115, 0.0, 0.025, 0.0] },
    Particle { position: [1.5, 1.5, -1.5], weight: 1.0, value: [0.049787068367863965, 0.0, 0.025, 0.0] },
    Particle { position: [1.5, 1.5, -0.4999999999999999], weight: 1.0, value: [0.12110333239232973, 0.0, 0.025, 0.0] },
    Particle { position: [1.5, 1.5, 0.5000000000000002], weight: 1.0, value: [0.12110333239232973, 0.0, 0.025, 0.0] },
    Particle { position: [1.5, 1.5, 1.5], weight: 1.0, value: [0.049787068367863965, 0.0, 0.025, 0.0] },
    Particle { position: [1.5, 1.5, 2.5], weight: 1.0, value: [0.008414677489201165, 0.0, 0.025, 0.0] },
    Particle { position: [1.5, 2.5, -2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [1.5, 2.5, -1.5], weight: 1.0, value: [0.008414677489201165, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [1.5, 2.5, -0.4999999999999999], weight: 1.0, value: [0.020468075714350505, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [1.5, 2.5, 0.5000000000000002], weight: 1.0, value: [0.020468075714350505, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [1.5, 2.5, 1.5], weight: 1.0, value: [0.008414677489201165, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [1.5, 2.5, 2.5], weight: 1.0, value: [0.001422192540522682, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [2.5, -2.5, -2.5], weight: 1.0, value: [0.00024036947641951364, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [2.5, -2.5, -1.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [2.5, -2.5, -0.4999999999999999], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [2.5, -2.5, 0.5000000000000002], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [2.5, -2.5, 1.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [2.5, -2.5, 2.5], weight: 1.0, value: [0.0002403694764195145, 0.0, -0.06944444444444445, 0.0] },
    Particle { position: [2.5, -1.5, -2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [2.5, -1.5, -1.5], weight: 1.0, value: [0.008414677489201165, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [2.5, -1.5, -0.4999999999999999], weight: 1.0, value: [0.020468075714350505, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [2.5, -1.5, 0.5000000000000002], weight: 1.0, value: [0.020468075714350505, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [2.5, -1.5, 1.5], weight: 1.0, value: [0.008414677489201165, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [2.5, -1.5, 2.5], weight: 1.0, value: [0.001422192540522682, 0.0, -0.041666666666666664, 0.0] },
    Particle { position: [2.5, -0.4999999999999999, -2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [2.5, -0.4999999999999999, -1.5], weight: 1.0, value: [0.020468075714350505, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [2.5, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [0.049787068367863965, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [2.5, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [0.049787068367863965, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [2.5, -0.4999999999999999, 1.5], weight: 1.0, value: [0.020468075714350505, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [2.5, -0.4999999999999999, 2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, -0.013888888888888885, 0.0] },
    Particle { position: [2.5, 0.5000000000000002, -2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, 0.013888888888888895, 0.0] },
    Particle { position: [2.5, 0.5000000000000002, -1.5], weight: 1.0, value: [0.020468075714350505, 0.0, 0.013888888888888895, 0.0] },
    Particle { position: [2.5, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [0.049787068367863965, 0.0, 0.013888888888888895, 0.0] },
    Particle { position: [2.5, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [0.049787068367863965, 0.0, 0.013888888888888895, 0.0] },
    Particle { position: [2.5, 0.5000000000000002, 1.5], weight: 1.0, value: [0.020468075714350505, 0.0, 0.013888888888888895, 0.0] },
    Particle { position: [2.5, 0.5000000000000002, 2.5], weight: 1.0, value: [0.0034593773364647584, 0.0, 0.013888888888888895, 0.0] },
    Particle { position: [2.5, 1.5, -2.5], weight: 1.0, value: [0.0014221925405226796, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [2.5, 1.5, -1.5], weight: 1.0, value: [0.008414677489201165, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [2.5, 1.5, -0.4999999999999999], weight: 1.0, value: [0.020468075714350505, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [2.5, 1.5, 0.5000000000000002], weight: 1.0, value: [0.020468075714350505, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [2.5, 1.5, 1.5], weight: 1.0, value: [0.008414677489201165, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [2.5, 1.5, 2.5], weight: 1.0, value: [0.001422192540522682, 0.0, 0.041666666666666664, 0.0] },
    Particle { position: [2.5, 2.5, -2.5], weight: 1.0, value: [0.0002403694764195145, 0.0, 0.06944444444444443, 0.0] },
    Particle { position: [2.5, 2.5, -1.5], weight: 1.0, value: [0.001422192540522682, 0.0, 0.06944444444444443, 0.0] },
    Particle { position: [2.5, 2.5, -0.4999999999999999], weight: 1.0, value: [0.0034593773364647675, 0.0, 0.06944444444444443, 0.0] },
    Particle { position: [2.5, 2.5, 0.5000000000000002], weight: 1.0, value: [0.0034593773364647584, 0.0, 0.06944444444444443, 0.0] },
    Particle { position: [2.5, 2.5, 1.5], weight: 1.0, value: [0.001422192540522682, 0.0, 0.06944444444444443, 0.0] },
    Particle { position: [2.5, 2.5, 2.5], weight: 1.0, value: [0.0002403694764195145, 0.0, 0.06944444444444443, 0.0] },
];

/// All memory of a run but the stack.
pub type Memory<S> = LinearStorage<
    S,
    <Sourced<Acoustics<S>, Supply> as FirstOrderSystem<S, 3, 4>>::Medium,
    3,
    4,
    PARTICLES,
    CELLS,
>;

/// A run between two steps.
pub type Run<'m, S> =
    Stepper<S, LinearDynamics<S, CutOff, Sourced<Acoustics<S>, Supply>, Rotation<S, 3>, 3, 4>, HalfLoop, &'m mut Memory<S>, 3>;

/// A run at its start. Error: what the scalar cannot hold.
pub fn start<S: Scalar>(memory: &mut Memory<S>) -> Result<Run<'_, S>, Error> {
    let cloud = memory;
    cloud.clear();
    for particle in &CLOUD {
        cloud.push(particle.rounded())?;
    }
    let width = (CUT_OFF, S::from_f64(0.9));
    let dynamics = LinearDynamics::new(domain(), width, system(), motion(), S::from_f64(0.5));
    let method = SSP_RK3;
    Ok(Stepper::new(dynamics, method, HalfLoop, cloud)?.until(S::from_f64(1.4999999999999998)))
}

#[allow(dead_code, reason = "formulas use some of it")]
#[rustfmt::skip]
mod elementary {
//! What formulas compute beyond the signs of Rust and the functions of `libm`. A program that is made
//! of a formula holds this very file: it has the bits of the formula.

/// `a^b`: a whole exponent up to 64 is multiplied out.
pub(super) fn power(a: f64, b: f64) -> f64 {
    if !(libm::fabs(b) <= 64.0 && b == libm::floor(b)) {
        return libm::pow(a, b);
    }
    let (mut product, mut square, mut left) = (1.0, a, libm::fabs(b) as u32);
    while left > 0 {
        if left % 2 == 1 {
            product *= square;
        }
        square *= square;
        left /= 2;
    }
    if b < 0.0 { 1.0 / product } else { product }
}

/// What a division by b leaves, of the sign of b, so that it is periodic: `x % 1` is a saw.
pub(super) fn remainder(a: f64, b: f64) -> f64 {
    a - b * libm::floor(a / b)
}

/// The smaller of two. A NaN is kept: `f64::min` would hide it.
pub(super) fn minimum(a: f64, b: f64) -> f64 {
    if a.is_nan() || a < b { a } else { b }
}

/// The larger of two; a NaN is kept.
pub(super) fn maximum(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// -1, 0 or 1; 0 at 0, where `signum` is 1, and for a NaN.
pub(super) fn sign(a: f64) -> f64 {
    truth(a > 0.0) - truth(a < 0.0)
}

/// 1 where something holds, else 0.
pub(super) fn truth(holds: bool) -> f64 {
    if holds { 1.0 } else { 0.0 }
}

/// The second where the first is not 0, else the third.
pub(super) fn choice(condition: f64, a: f64, b: f64) -> f64 {
    if condition == 0.0 { b } else { a }
}
}
