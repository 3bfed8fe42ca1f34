//! Made by `motes export tests/exported/medium.toml`, not by hand.
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
use motes_core::equation::linear::systems::{MatrixField, Units, VariableMatrices};
use motes_core::equation::linear::{
    Addition, FirstOrderSystem, LinearDynamics, LinearStorage, Particle, Place, Sourced,
    VelocityField,
};
use motes_core::error::Error;
use motes_core::integrator::{RK4, Stepper};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = "medium";

/// Number of particles.
pub const PARTICLES: usize = 144;

/// Cells they can take, and one.
pub const CELLS: usize = 705;

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::WendlandC2;

/// The way between the solver's numbers and those of the scenario.
pub const FRAME: Frame = Frame {
    middle: [0.5, 0.5, 0.0],
    units: Units {
        length: 0.08333333333333333,
        velocity: 1.3803001094012657,
    },
};

/// The matrices: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct Coefficients;

impl<S: Scalar> MatrixField<S, 2, 4> for Coefficients {
    fn flux(&self, place: &Place<S, 2>) -> [[[S; 4]; 4]; 2] {
        let [x, _, _, t] = FRAME.point(place);
        let mut flux = [[[S::ZERO; 4]; 4]; 2];
        flux[0][0][1] = FRAME.velocity(1.0 + 0.2 * libm::sin(core::f64::consts::TAU * x) * libm::cos(t));
        flux[0][1][0] = FRAME.velocity(1.0 + 0.2 * libm::sin(core::f64::consts::TAU * x) * libm::cos(t));
        flux[0][2][2] = FRAME.velocity(0.2);
        flux[1][0][0] = FRAME.velocity(0.1);
        flux[1][0][2] = FRAME.velocity(1.0 + 0.2 * libm::sin(core::f64::consts::TAU * x) * libm::cos(t));
        flux[1][2][0] = FRAME.velocity(1.0 + 0.2 * libm::sin(core::f64::consts::TAU * x) * libm::cos(t));
        flux
    }
    fn decay(&self, place: &Place<S, 2>, u: &[S; 4]) -> [S; 4] {
        let [_, y, _, t] = FRAME.point(place);
        let mut rates = [S::ZERO; 4];
        rates[0] += FRAME.rate::<S>(0.5 + elementary::power(libm::fabs(y - 0.5), 3.0)) * u[0];
        rates[1] += FRAME.rate::<S>(t) * u[1];
        rates[1] += FRAME.rate::<S>(-0.3) * u[2];
        rates[2] += FRAME.rate::<S>(0.3) * u[1];
        rates
    }
}

/// The source: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct Supply;

impl<S: Scalar> Addition<S, 2, 4> for Supply {
    fn add(&self, place: &Place<S, 2>, rates: &mut [S; 4]) {
        let [x, y, _, t] = FRAME.point(place);
        rates[0] += FRAME.rate::<S>(0.2 * libm::exp(-t) * elementary::choice(elementary::truth(x < 0.5), x, 1.0 - x));
        rates[1] += FRAME.rate::<S>(0.0);
        rates[2] += FRAME.rate::<S>(elementary::remainder(0.1 * libm::cos(core::f64::consts::TAU * y), 0.07));
    }
}

/// The equations without that source.
fn unsourced<S: Scalar>() -> VariableMatrices<S, Coefficients> {
    VariableMatrices {
        matrices: Coefficients,
        speed: S::from_f64(1.0),
        damping: S::from_f64(0.046487474882908116),
    }
}

/// The equations.
pub fn system<S: Scalar>() -> Sourced<VariableMatrices<S, Coefficients>, Supply> {
    Sourced {
        system: unsourced(),
        source: Supply,
    }
}

/// What the particles follow: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct Motion;

impl<S: Scalar> VelocityField<S, 2> for Motion {
    fn velocity(&self, place: &Place<S, 2>) -> [S; 2] {
        let [x, y, _, t] = FRAME.point(place);
        [
            FRAME.velocity(0.1 * libm::sin(core::f64::consts::TAU * x) * libm::cos(t)),
            FRAME.velocity(-0.05 * libm::sin(core::f64::consts::TAU * y) + 0.02 * t),
        ]
    }
    fn divergence(&self, place: &Place<S, 2>) -> S {
        let [x, y, _, t] = FRAME.point(place);
        FRAME.rate((0.1 * (libm::cos(core::f64::consts::TAU * x) * core::f64::consts::TAU) * libm::cos(t)) + (-0.05 * (libm::cos(core::f64::consts::TAU * y) * core::f64::consts::TAU)))
    }
    fn gradient(&self) -> S {
        S::from_f64(0.047417113498728625)
    }
    fn convergence(&self) -> S {
        S::from_f64(0.07112567024809294)
    }
}

/// The domain, in solver units.
pub fn domain<S: Scalar>() -> Domain<S, 2> {
    Domain {
        axes: [
            Axis {
                lower: S::from_f64(-6.0),
                upper: S::from_f64(6.0),
                sides: [Side::Periodic, Side::Periodic],
            },
            Axis {
                lower: S::from_f64(-6.0),
                upper: S::from_f64(6.0),
                sides: [Side::Periodic, Side::Periodic],
            },
        ],
    }
}

/// The particles at the start, in solver units.
#[rustfmt::skip]
pub static CLOUD: [Particle<f64, 2, 4>; PARTICLES] = [
    Particle { position: [-5.5, -5.5], weight: 1.0, value: [0.49999999999999994, 0.24999999999999997, -0.034034630350468636, 0.0] },
    Particle { position: [-5.5, -4.5], weight: 1.0, value: [0.8660254037844386, 0.6830127018922193, -0.10163336846363956, 0.0] },
    Particle { position: [-5.5, -3.4999999999999996], weight: 1.0, value: [1.0, 0.9330127018922194, -0.16783996369789844, 0.0] },
    Particle { position: [-5.5, -2.5], weight: 1.0, value: [0.8660254037844386, 0.9330127018922194, -0.23178973999766292, 0.0] },
    Particle { position: [-5.5, -1.5], weight: 1.0, value: [0.49999999999999994, 0.6830127018922194, -0.29270862062673275, 0.0] },
    Particle { position: [-5.5, -0.5000000000000002], weight: 1.0, value: [1.2246467991473532e-16, 0.2500000000000003, -0.3499407505789217, 0.0] },
    Particle { position: [-5.5, 0.49999999999999956], weight: 1.0, value: [0.0, -0.2499999999999996, -0.4029684775805267, 0.0] },
    Particle { position: [-5.5, 1.5], weight: 1.0, value: [0.0, -0.6830127018922193, -0.4514237704101383, 0.0] },
    Particle { position: [-5.5, 2.5000000000000004], weight: 1.0, value: [0.0, -0.9330127018922194, -0.4950908894613922, 0.0] },
    Particle { position: [-5.5, 3.4999999999999996], weight: 1.0, value: [0.0, -0.9330127018922195, -0.5339008287946434, 0.0] },
    Particle { position: [-5.5, 4.5], weight: 1.0, value: [0.0, -0.6830127018922195, -0.5679186498571113, 0.0] },
    Particle { position: [-5.5, 5.5], weight: 1.0, value: [0.0, -0.24999999999999994, -0.5973252708684472, 0.0] },
    Particle { position: [-4.5, -5.5], weight: 1.0, value: [0.8660254037844386, 0.18301270189221933, -0.029844762971394195, 0.0] },
    Particle { position: [-4.5, -4.5], weight: 1.0, value: [1.0, 0.5, -0.08912169048252722, 0.0] },
    Particle { position: [-4.5, -3.4999999999999996], weight: 1.0, value: [0.8660254037844386, 0.6830127018922194, -0.14717785626316382, 0.0] },
    Particle { position: [-4.5, -2.5], weight: 1.0, value: [0.49999999999999994, 0.6830127018922194, -0.20325503107266996, 0.0] },
    Particle { position: [-4.5, -1.5], weight: 1.0, value: [1.2246467991473532e-16, 0.5000000000000001, -0.25667443166951565, 0.0] },
    Particle { position: [-4.5, -0.5000000000000002], weight: 1.0, value: [0.0, 0.18301270189221952, -0.3068609427372814, 0.0] },
    Particle { position: [-4.5, 0.49999999999999956], weight: 1.0, value: [0.0, -0.18301270189221905, -0.3533606381057345, 0.0] },
    Particle { position: [-4.5, 1.5], weight: 1.0, value: [0.0, -0.5, -0.39585079340690243, 0.0] },
    Particle { position: [-4.5, 2.5000000000000004], weight: 1.0, value: [0.0, -0.6830127018922194, -0.4341422278755121, 0.0] },
    Particle { position: [-4.5, 3.4999999999999996], weight: 1.0, value: [0.0, -0.6830127018922195, -0.46817443061747965, 0.0] },
    Particle { position: [-4.5, 4.5], weight: 1.0, value: [0.0, -0.5000000000000001, -0.4980044536251682, 0.0] },
    Particle { position: [-4.5, 5.5], weight: 1.0, value: [0.5000000000000008, -0.18301270189221927, -0.5237909429989498, 0.0] },
    Particle { position: [-3.4999999999999996, -5.5], weight: 1.0, value: [1.0, 0.06698729810778066, -0.02467296178217093, 0.0] },
    Particle { position: [-3.4999999999999996, -4.5], weight: 1.0, value: [0.8660254037844386, 0.1830127018922193, -0.07367778612768588, 0.0] },
    Particle { position: [-3.4999999999999996, -3.4999999999999996], weight: 1.0, value: [0.49999999999999994, 0.24999999999999997, -0.1216733946335393, 0.0] },
    Particle { position: [-3.4999999999999996, -2.5], weight: 1.0, value: [1.2246467991473532e-16, 0.24999999999999997, -0.16803295166045273, 0.0] },
    Particle { position: [-3.4999999999999996, -1.5], weight: 1.0, value: [0.0, 0.18301270189221933, -0.21219530036517364, 0.0] },
    Particle { position: [-3.4999999999999996, -0.5000000000000002], weight: 1.0, value: [0.0, 0.06698729810778074, -0.2536849872071274, 0.0] },
    Particle { position: [-3.4999999999999996, 0.49999999999999956], weight: 1.0, value: [0.0, -0.06698729810778056, -0.2921267469157936, 0.0] },
    Particle { position: [-3.4999999999999996, 1.5], weight: 1.0, value: [0.0, -0.1830127018922193, -0.3272537800528656, 0.0] },
    Particle { position: [-3.4999999999999996, 2.5000000000000004], weight: 1.0, value: [0.0, -0.24999999999999997, -0.3589096890019181, 0.0] },
    Particle { position: [-3.4999999999999996, 3.4999999999999996], weight: 1.0, value: [0.0, -0.25, -0.3870444488061918, 0.0] },
    Particle { position: [-3.4999999999999996, 4.5], weight: 1.0, value: [0.4999999999999993, -0.18301270189221935, -0.4117052249140611, 0.0] },
    Particle { position: [-3.4999999999999996, 5.5], weight: 1.0, value: [0.8660254037844388, -0.06698729810778065, -0.4330231716313959, 0.0] },
    Particle { position: [-2.5, -5.5], weight: 1.0, value: [0.8660254037844386, -0.06698729810778069, -0.01851908154506138, 0.0] },
    Particle { position: [-2.5, -4.5], weight: 1.0, value: [0.49999999999999994, -0.18301270189221938, -0.055301221693788566, 0.0] },
    Particle { position: [-2.5, -3.4999999999999996], weight: 1.0, value: [1.2246467991473532e-16, -0.2500000000000001, -0.09132586257687164, 0.0] },
    Particle { position: [-2.5, -2.5], weight: 1.0, value: [0.0, -0.2500000000000001, -0.1261225126326718, 0.0] },
    Particle { position: [-2.5, -1.5], weight: 1.0, value: [0.0, -0.1830127018922194, -0.15926997762307885, 0.0] },
    Particle { position: [-2.5, -0.5000000000000002], weight: 1.0, value: [0.0, -0.06698729810778077, -0.1904113906682052, 0.0] },
    Particle { position: [-2.5, 0.49999999999999956], weight: 1.0, value: [0.0, 0.06698729810778059, -0.21926508440248882, 0.0] },
    Particle { position: [-2.5, 1.5], weight: 1.0, value: [0.0, 0.18301270189221938, -0.24563080396403683, 0.0] },
    Particle { position: [-2.5, 2.5000000000000004], weight: 1.0, value: [0.0, 0.2500000000000001, -0.2693911601136648, 0.0] },
    Particle { position: [-2.5, 3.4999999999999996], weight: 1.0, value: [0.4999999999999993, 0.2500000000000001, -0.2905086050181742, 0.0] },
    Particle { position: [-2.5, 4.5], weight: 1.0, value: [0.8660254037844388, 0.18301270189221944, -0.3090185402151779, 0.0] },
    Particle { position: [-2.5, 5.5], weight: 1.0, value: [1.0, 0.06698729810778067, -0.32501940776877974, 0.0] },
    Particle { position: [-1.5, -5.5], weight: 1.0, value: [0.49999999999999994, -0.1830127018922193, -0.011508386181282028, 0.0] },
    Particle { position: [-1.5, -4.5], weight: 1.0, value: [1.2246467991473532e-16, -0.4999999999999999, -0.03436605719350758, 0.0] },
    Particle { position: [-1.5, -3.4999999999999996], weight: 1.0, value: [0.0, -0.6830127018922193, -0.0567529924373389, 0.0] },
    Particle { position: [-1.5, -2.5], weight: 1.0, value: [0.0, -0.6830127018922193, -0.07837681247845044, 0.0] },
    Particle { position: [-1.5, -1.5], weight: 1.0, value: [0.0, -0.5, -0.09897577291349755, 0.0] },
    Particle { position: [-1.5, -0.5000000000000002], weight: 1.0, value: [0.0, -0.1830127018922195, -0.11832810454409624, 0.0] },
    Particle { position: [-1.5, 0.49999999999999956], weight: 1.0, value: [0.0, 0.18301270189221902, -0.13625876970384473, 0.0] },
    Particle { position: [-1.5, 1.5], weight: 1.0, value: [0.0, 0.4999999999999999, -0.152643323220895, 0.0] },
    Particle { position: [-1.5, 2.5000000000000004], weight: 1.0, value: [0.5000000000000008, 0.6830127018922193, -0.1674088154354719, 0.0] },
    Particle { position: [-1.5, 3.4999999999999996], weight: 1.0, value: [0.8660254037844379, 0.6830127018922194, -0.180531912848899, 0.0] },
    Particle { position: [-1.5, 4.5], weight: 1.0, value: [1.0, 0.5000000000000001, -0.1920346151788874, 0.0] },
    Particle { position: [-1.5, 5.5], weight: 1.0, value: [0.8660254037844383, 0.18301270189221924, -0.20197809766717, 0.0] },
    Particle { position: [-0.5000000000000002, -5.5], weight: 1.0, value: [1.2246467991473532e-16, -0.24999999999999994, -0.0039066779959205855, 0.0] },
    Particle { position: [-0.5000000000000002, -4.5], weight: 1.0, value: [0.0, -0.6830127018922192, -0.011666024873477808, 0.0] },
    Particle { position: [-0.5000000000000002, -3.4999999999999996], weight: 1.0, value: [0.0, -0.9330127018922193, -0.019265574100929266, 0.0] },
    Particle { position: [-0.5000000000000002, -2.5], weight: 1.0, value: [0.0, -0.9330127018922193, -0.026606073508201177, 0.0] },
    Particle { position: [-0.5000000000000002, -1.5], weight: 1.0, value: [0.0, -0.6830127018922193, -0.03359867040257065, 0.0] },
    Particle { position: [-0.5000000000000002, -0.5000000000000002], weight: 1.0, value: [0.0, -0.2500000000000002, -0.04016808221758116, 0.0] },
    Particle { position: [-0.5000000000000002, 0.49999999999999956], weight: 1.0, value: [0.0, 0.24999999999999958, -0.04625489004001434, 0.0] },
    Particle { position: [-0.5000000000000002, 1.5], weight: 1.0, value: [0.4999999999999993, 0.6830127018922192, -0.05181684926607438, 0.0] },
    Particle { position: [-0.5000000000000002, 2.5000000000000004], weight: 1.0, value: [0.8660254037844388, 0.9330127018922193, -0.05682919614294972, 0.0] },
    Particle { position: [-0.5000000000000002, 3.4999999999999996], weight: 1.0, value: [1.0, 0.9330127018922194, -0.061284009797599494, 0.0] },
    Particle { position: [-0.5000000000000002, 4.5], weight: 1.0, value: [0.8660254037844392, 0.6830127018922194, -0.0651887583330005, 0.0] },
    Particle { position: [-0.5000000000000002, 5.5], weight: 1.0, value: [0.4999999999999998, 0.2499999999999999, -0.06856420851583994, 0.0] },
    Particle { position: [0.49999999999999956, -5.5], weight: 1.0, value: [0.0, -0.25, 0.00390667799592058, 0.0] },
    Particle { position: [0.49999999999999956, -4.5], weight: 1.0, value: [0.0, -0.6830127018922194, 0.011666024873477794, 0.0] },
    Particle { position: [0.49999999999999956, -3.4999999999999996], weight: 1.0, value: [0.0, -0.9330127018922195, 0.01926557410092924, 0.0] },
    Particle { position: [0.49999999999999956, -2.5], weight: 1.0, value: [0.0, -0.9330127018922195, 0.026606073508201145, 0.0] },
    Particle { position: [0.49999999999999956, -1.5], weight: 1.0, value: [0.0, -0.6830127018922195, 0.03359867040257061, 0.0] },
    Particle { position: [0.49999999999999956, -0.5000000000000002], weight: 1.0, value: [0.0, -0.2500000000000003, 0.040168082217581114, 0.0] },
    Particle { position: [0.49999999999999956, 0.49999999999999956], weight: 1.0, value: [0.4999999999999993, 0.24999999999999964, 0.04625489004001428, 0.0] },
    Particle { position: [0.49999999999999956, 1.5], weight: 1.0, value: [0.8660254037844379, 0.6830127018922194, 0.05181684926607432, 0.0] },
    Particle { position: [0.49999999999999956, 2.5000000000000004], weight: 1.0, value: [1.0, 0.9330127018922195, 0.05682919614294965, 0.0] },
    Particle { position: [0.49999999999999956, 3.4999999999999996], weight: 1.0, value: [0.8660254037844392, 0.9330127018922196, 0.061284009797599424, 0.0] },
    Particle { position: [0.49999999999999956, 4.5], weight: 1.0, value: [0.5000000000000013, 0.6830127018922195, 0.06518875833300043, 0.0] },
    Particle { position: [0.49999999999999956, 5.5], weight: 1.0, value: [3.6739403974420594e-16, 0.24999999999999997, 0.06856420851583986, 0.0] },
    Particle { position: [1.5, -5.5], weight: 1.0, value: [0.0, -0.18301270189221935, 0.011508386181282028, 0.0] },
    Particle { position: [1.5, -4.5], weight: 1.0, value: [0.0, -0.5000000000000001, 0.03436605719350758, 0.0] },
    Particle { position: [1.5, -3.4999999999999996], weight: 1.0, value: [0.0, -0.6830127018922195, 0.0567529924373389, 0.0] },
    Particle { position: [1.5, -2.5], weight: 1.0, value: [0.0, -0.6830127018922195, 0.07837681247845044, 0.0] },
    Particle { position: [1.5, -1.5], weight: 1.0, value: [0.0, -0.5000000000000001, 0.09897577291349755, 0.0] },
    Particle { position: [1.5, -0.5000000000000002], weight: 1.0, value: [0.4999999999999993, -0.18301270189221955, 0.11832810454409624, 0.0] },
    Particle { position: [1.5, 0.49999999999999956], weight: 1.0, value: [0.8660254037844379, 0.18301270189221908, 0.13625876970384473, 0.0] },
    Particle { position: [1.5, 1.5], weight: 1.0, value: [1.0, 0.5000000000000001, 0.152643323220895, 0.0] },
    Particle { position: [1.5, 2.5000000000000004], weight: 1.0, value: [0.8660254037844383, 0.6830127018922195, 0.1674088154354719, 0.0] },
    Particle { position: [1.5, 3.4999999999999996], weight: 1.0, value: [0.5000000000000013, 0.6830127018922195, 0.180531912848899, 0.0] },
    Particle { position: [1.5, 4.5], weight: 1.0, value: [3.6739403974420594e-16, 0.5000000000000002, 0.1920346151788874, 0.0] },
    Particle { position: [1.5, 5.5], weight: 1.0, value: [0.0, 0.1830127018922193, 0.20197809766717, 0.0] },
    Particle { position: [2.5000000000000004, -5.5], weight: 1.0, value: [0.0, -0.06698729810778063, 0.018519081545061385, 0.0] },
    Particle { position: [2.5000000000000004, -4.5], weight: 1.0, value: [0.0, -0.18301270189221922, 0.05530122169378857, 0.0] },
    Particle { position: [2.5000000000000004, -3.4999999999999996], weight: 1.0, value: [0.0, -0.2499999999999999, 0.09132586257687166, 0.0] },
    Particle { position: [2.5000000000000004, -2.5], weight: 1.0, value: [0.0, -0.2499999999999999, 0.1261225126326718, 0.0] },
    Particle { position: [2.5000000000000004, -1.5], weight: 1.0, value: [0.5000000000000008, -0.18301270189221924, 0.15926997762307887, 0.0] },
    Particle { position: [2.5000000000000004, -0.5000000000000002], weight: 1.0, value: [0.8660254037844388, -0.0669872981077807, 0.19041139066820523, 0.0] },
    Particle { position: [2.5000000000000004, 0.49999999999999956], weight: 1.0, value: [1.0, 0.06698729810778054, 0.21926508440248885, 0.0] },
    Particle { position: [2.5000000000000004, 1.5], weight: 1.0, value: [0.8660254037844383, 0.18301270189221922, 0.24563080396403686, 0.0] },
    Particle { position: [2.5000000000000004, 2.5000000000000004], weight: 1.0, value: [0.4999999999999998, 0.2499999999999999, 0.2693911601136649, 0.0] },
    Particle { position: [2.5000000000000004, 3.4999999999999996], weight: 1.0, value: [3.6739403974420594e-16, 0.24999999999999992, 0.29050860501817427, 0.0] },
    Particle { position: [2.5000000000000004, 4.5], weight: 1.0, value: [0.0, 0.18301270189221927, 0.30901854021517794, 0.0] },
    Particle { position: [2.5000000000000004, 5.5], weight: 1.0, value: [0.0, 0.06698729810778062, 0.3250194077687798, 0.0] },
    Particle { position: [3.4999999999999996, -5.5], weight: 1.0, value: [0.0, 0.06698729810778055, 0.02467296178217093, 0.0] },
    Particle { position: [3.4999999999999996, -4.5], weight: 1.0, value: [0.0, 0.18301270189221897, 0.07367778612768588, 0.0] },
    Particle { position: [3.4999999999999996, -3.4999999999999996], weight: 1.0, value: [0.0, 0.24999999999999956, 0.1216733946335393, 0.0] },
    Particle { position: [3.4999999999999996, -2.5], weight: 1.0, value: [0.4999999999999993, 0.24999999999999956, 0.16803295166045273, 0.0] },
    Particle { position: [3.4999999999999996, -1.5], weight: 1.0, value: [0.8660254037844379, 0.183012701892219, 0.21219530036517364, 0.0] },
    Particle { position: [3.4999999999999996, -0.5000000000000002], weight: 1.0, value: [1.0, 0.06698729810778062, 0.2536849872071274, 0.0] },
    Particle { position: [3.4999999999999996, 0.49999999999999956], weight: 1.0, value: [0.8660254037844392, -0.06698729810778045, 0.2921267469157936, 0.0] },
    Particle { position: [3.4999999999999996, 1.5], weight: 1.0, value: [0.5000000000000013, -0.18301270189221897, 0.3272537800528656, 0.0] },
    Particle { position: [3.4999999999999996, 2.5000000000000004], weight: 1.0, value: [3.6739403974420594e-16, -0.24999999999999956, 0.3589096890019181, 0.0] },
    Particle { position: [3.4999999999999996, 3.4999999999999996], weight: 1.0, value: [0.0, -0.24999999999999958, 0.3870444488061918, 0.0] },
    Particle { position: [3.4999999999999996, 4.5], weight: 1.0, value: [0.0, -0.18301270189221902, 0.4117052249140611, 0.0] },
    Particle { position: [3.4999999999999996, 5.5], weight: 1.0, value: [0.0, -0.06698729810778054, 0.4330231716313959, 0.0] },
    Particle { position: [4.5, -5.5], weight: 1.0, value: [0.0, 0.18301270189221927, 0.029844762971394195, 0.0] },
    Particle { position: [4.5, -4.5], weight: 1.0, value: [0.0, 0.49999999999999983, 0.08912169048252722, 0.0] },
    Particle { position: [4.5, -3.4999999999999996], weight: 1.0, value: [0.4999999999999993, 0.6830127018922192, 0.14717785626316382, 0.0] },
    Particle { position: [4.5, -2.5], weight: 1.0, value: [0.8660254037844388, 0.6830127018922192, 0.20325503107266996, 0.0] },
    Particle { position: [4.5, -1.5], weight: 1.0, value: [1.0, 0.4999999999999999, 0.25667443166951565, 0.0] },
    Particle { position: [4.5, -0.5000000000000002], weight: 1.0, value: [0.8660254037844392, 0.18301270189221946, 0.3068609427372814, 0.0] },
    Particle { position: [4.5, 0.49999999999999956], weight: 1.0, value: [0.5000000000000013, -0.183012701892219, 0.3533606381057345, 0.0] },
    Particle { position: [4.5, 1.5], weight: 1.0, value: [3.6739403974420594e-16, -0.49999999999999983, 0.39585079340690243, 0.0] },
    Particle { position: [4.5, 2.5000000000000004], weight: 1.0, value: [0.0, -0.6830127018922192, 0.4341422278755121, 0.0] },
    Particle { position: [4.5, 3.4999999999999996], weight: 1.0, value: [0.0, -0.6830127018922193, 0.46817443061747965, 0.0] },
    Particle { position: [4.5, 4.5], weight: 1.0, value: [0.0, -0.5, 0.4980044536251682, 0.0] },
    Particle { position: [4.5, 5.5], weight: 1.0, value: [0.0, -0.18301270189221922, 0.5237909429989498, 0.0] },
    Particle { position: [5.5, -5.5], weight: 1.0, value: [0.0, 0.24999999999999997, 0.034034630350468636, 0.0] },
    Particle { position: [5.5, -4.5], weight: 1.0, value: [0.5000000000000008, 0.6830127018922193, 0.10163336846363957, 0.0] },
    Particle { position: [5.5, -3.4999999999999996], weight: 1.0, value: [0.8660254037844388, 0.9330127018922194, 0.16783996369789847, 0.0] },
    Particle { position: [5.5, -2.5], weight: 1.0, value: [1.0, 0.9330127018922194, 0.23178973999766295, 0.0] },
    Particle { position: [5.5, -1.5], weight: 1.0, value: [0.8660254037844383, 0.6830127018922194, 0.2927086206267328, 0.0] },
    Particle { position: [5.5, -0.5000000000000002], weight: 1.0, value: [0.4999999999999998, 0.2500000000000003, 0.34994075057892177, 0.0] },
    Particle { position: [5.5, 0.49999999999999956], weight: 1.0, value: [3.6739403974420594e-16, -0.2499999999999996, 0.40296847758052673, 0.0] },
    Particle { position: [5.5, 1.5], weight: 1.0, value: [0.0, -0.6830127018922193, 0.4514237704101384, 0.0] },
    Particle { position: [5.5, 2.5000000000000004], weight: 1.0, value: [0.0, -0.9330127018922194, 0.49509088946139224, 0.0] },
    Particle { position: [5.5, 3.4999999999999996], weight: 1.0, value: [0.0, -0.9330127018922195, 0.5339008287946435, 0.0] },
    Particle { position: [5.5, 4.5], weight: 1.0, value: [0.0, -0.6830127018922195, 0.5679186498571114, 0.0] },
    Particle { position: [5.5, 5.5], weight: 1.0, value: [0.0, -0.24999999999999994, 0.5973252708684473, 0.0] },
];

/// All memory of a run but the stack.
pub type Memory<S> = LinearStorage<
    S,
    <Sourced<VariableMatrices<S, Coefficients>, Supply> as FirstOrderSystem<S, 2, 4>>::Medium,
    2,
    4,
    PARTICLES,
    CELLS,
>;

/// A run between two steps.
pub type Run<'m, S> =
    Stepper<S, LinearDynamics<S, CutOff, Sourced<VariableMatrices<S, Coefficients>, Supply>, Motion, 2, 4>, HalfLoop, &'m mut Memory<S>, 2>;

/// A run at its start. Error: what the scalar cannot hold.
pub fn start<S: Scalar>(memory: &mut Memory<S>) -> Result<Run<'_, S>, Error> {
    let cloud = memory;
    cloud.clear();
    for particle in &CLOUD {
        cloud.push(particle.rounded())?;
    }
    let width = (CUT_OFF, S::from_f64(1.3));
    let dynamics = LinearDynamics::new(domain(), width, system(), Motion, S::from_f64(0.5));
    let method = RK4;
    Ok(Stepper::new(dynamics, method, HalfLoop, cloud)?.until(S::from_f64(6.625440525126076)))
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
