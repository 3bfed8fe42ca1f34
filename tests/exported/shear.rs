//! Made by `motes export tests/exported/shear.toml`, not by hand.
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
#![allow(clippy::approx_constant)]

use motes_core::cutoff::Named as CutOff;
use motes_core::domain::{Axis, Domain, Side};
use motes_core::equation::gas::viscosity::{Coefficients, Named as Viscosity, Pairwise};
use motes_core::equation::gas::{
    Diffusion, EnergyForm, GasDynamics, NoSlip, Options, OptionsStorage, Packing, Particle, Plain,
    Weights, Width,
};
use motes_core::error::Error;
use motes_core::integrator::{LeapFrog, Stepper};
use motes_core::material::{IdealGas, Named as Material};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = "shear";

/// Number of particles.
pub const PARTICLES: usize = 144;

/// Cells they can take, and one.
pub const CELLS: usize = 705;

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::WendlandC2;

/// The pseudo-viscosity.
pub fn viscosity<S: Scalar>() -> Viscosity<S> {
    Viscosity::Pairwise(Pairwise(Coefficients {
        alpha: S::from_f64(1.0),
        beta: S::from_f64(2.0),
    }))
}

/// What the gas does beyond the paper's equations.
pub fn physics<S: Scalar>() -> Options<S, 2> {
    Options {
        plain: Plain { weights: Weights::Mass, acceleration: [S::from_f64(0.0), S::from_f64(-0.004058434040301407)], far: [None; 2] },
        energy: EnergyForm::LeapFrog,
        limited: true,
        linear_exact: false,
        switch: None,
        balsara: true,
        conduction: S::from_f64(0.0),
        diffusion: Diffusion { viscosity: S::from_f64(0.06837628254319784), bulk_viscosity: S::from_f64(0.0), heat: S::from_f64(0.0) },
        walls: NoSlip { velocity: [[None, None], [Some([S::from_f64(-0.5698023545266486), S::from_f64(0.0)]), None]] },
        background: S::ZERO,
    }
}

/// The materials, by number.
pub fn materials<S: Scalar>() -> [Material<S>; 1] {
    [Material::IdealGas(IdealGas::new(1.4))]
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
                sides: [Side::Mirror, Side::Mirror],
            },
        ],
    }
}

/// The particles at the start, in solver units.
#[rustfmt::skip]
pub static CLOUD: [Particle<f64, 2>; PARTICLES] = [
    Particle { position: [-5.5, -5.5], velocity: [-0.541398360549144, 0.007373785064787759], mass: 1.025881904510252, energy: 1.5725275238088463, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, -4.5], velocity: [-0.515755606122529, 0.007373785064787759], mass: 1.025881904510252, energy: 1.5527473033835775, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, -3.5000000000000004], velocity: [-0.46906166610269345, 0.007373785064787759], mass: 1.025881904510252, energy: 1.5329670829583093, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, -2.5000000000000004], velocity: [-0.38875437448127564, 0.007373785064787759], mass: 1.025881904510252, energy: 1.513186862533041, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, -1.5], velocity: [-0.2633154442739151, 0.007373785064787759], mass: 1.025881904510252, energy: 1.4934066421077723, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, -0.5000000000000002], velocity: [-0.09409739611195685, 0.007373785064787759], mass: 1.025881904510252, energy: 1.4736264216825037, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, 0.49999999999999956], velocity: [0.09409739611195674, 0.007373785064787759], mass: 1.025881904510252, energy: 1.4538462012572353, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, 1.5], velocity: [0.2633154442739151, 0.007373785064787759], mass: 1.025881904510252, energy: 1.4340659808319667, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, 2.499999999999999], velocity: [0.3887543744812755, 0.007373785064787759], mass: 1.025881904510252, energy: 1.4142857604066983, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, 3.4999999999999996], velocity: [0.46906166610269345, 0.007373785064787759], mass: 1.025881904510252, energy: 1.3945055399814297, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, 4.5], velocity: [0.515755606122529, 0.007373785064787759], mass: 1.025881904510252, energy: 1.3747253195561613, epsilon: 1.3, material: 0 },
    Particle { position: [-5.5, 5.499999999999999], velocity: [0.541398360549144, 0.007373785064787759], mass: 1.025881904510252, energy: 1.3549450991308927, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, -5.5], velocity: [-0.541398360549144, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.5066885611474532, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, -4.5], velocity: [-0.515755606122529, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.4877365037745294, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, -3.5000000000000004], velocity: [-0.46906166610269345, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.4687844464016053, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, -2.5000000000000004], velocity: [-0.38875437448127564, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.4498323890286815, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, -1.5], velocity: [-0.2633154442739151, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.4308803316557575, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, -0.5000000000000002], velocity: [-0.09409739611195685, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.4119282742828336, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, 0.49999999999999956], velocity: [0.09409739611195674, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.3929762169099096, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, 1.5], velocity: [0.2633154442739151, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.3740241595369855, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, 2.499999999999999], velocity: [0.3887543744812755, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.3550721021640617, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, 3.4999999999999996], velocity: [0.46906166610269345, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.3361200447911377, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, 4.5], velocity: [0.515755606122529, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.3171679874182138, epsilon: 1.3, material: 0 },
    Particle { position: [-4.5, 5.499999999999999], velocity: [0.541398360549144, 0.020145555441092727], mass: 1.0707106781186548, energy: 1.2982159300452898, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, -5.5], velocity: [-0.541398360549144, 0.027519340505880487], mass: 1.096592582628907, energy: 1.4711275240913564, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, -4.5], velocity: [-0.515755606122529, 0.027519340505880487], mass: 1.096592582628907, energy: 1.4526227753606473, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, -3.5000000000000004], velocity: [-0.46906166610269345, 0.027519340505880487], mass: 1.096592582628907, energy: 1.4341180266299385, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, -2.5000000000000004], velocity: [-0.38875437448127564, 0.027519340505880487], mass: 1.096592582628907, energy: 1.4156132778992299, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, -1.5], velocity: [-0.2633154442739151, 0.027519340505880487], mass: 1.096592582628907, energy: 1.3971085291685208, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, -0.5000000000000002], velocity: [-0.09409739611195685, 0.027519340505880487], mass: 1.096592582628907, energy: 1.378603780437812, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, 0.49999999999999956], velocity: [0.09409739611195674, 0.027519340505880487], mass: 1.096592582628907, energy: 1.360099031707103, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, 1.5], velocity: [0.2633154442739151, 0.027519340505880487], mass: 1.096592582628907, energy: 1.341594282976394, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, 2.499999999999999], velocity: [0.3887543744812755, 0.027519340505880487], mass: 1.096592582628907, energy: 1.3230895342456854, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, 3.4999999999999996], velocity: [0.46906166610269345, 0.027519340505880487], mass: 1.096592582628907, energy: 1.3045847855149764, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, 4.5], velocity: [0.515755606122529, 0.027519340505880487], mass: 1.096592582628907, energy: 1.2860800367842675, epsilon: 1.3, material: 0 },
    Particle { position: [-3.5000000000000004, 5.499999999999999], velocity: [0.541398360549144, 0.027519340505880487], mass: 1.096592582628907, energy: 1.2675752880535585, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, -5.5], velocity: [-0.541398360549144, 0.027519340505880494], mass: 1.096592582628907, energy: 1.4711275240913564, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, -4.5], velocity: [-0.515755606122529, 0.027519340505880494], mass: 1.096592582628907, energy: 1.4526227753606473, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, -3.5000000000000004], velocity: [-0.46906166610269345, 0.027519340505880494], mass: 1.096592582628907, energy: 1.4341180266299385, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, -2.5000000000000004], velocity: [-0.38875437448127564, 0.027519340505880494], mass: 1.096592582628907, energy: 1.4156132778992299, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, -1.5], velocity: [-0.2633154442739151, 0.027519340505880494], mass: 1.096592582628907, energy: 1.3971085291685208, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, -0.5000000000000002], velocity: [-0.09409739611195685, 0.027519340505880494], mass: 1.096592582628907, energy: 1.378603780437812, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, 0.49999999999999956], velocity: [0.09409739611195674, 0.027519340505880494], mass: 1.096592582628907, energy: 1.360099031707103, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, 1.5], velocity: [0.2633154442739151, 0.027519340505880494], mass: 1.096592582628907, energy: 1.341594282976394, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, 2.499999999999999], velocity: [0.3887543744812755, 0.027519340505880494], mass: 1.096592582628907, energy: 1.3230895342456854, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, 3.4999999999999996], velocity: [0.46906166610269345, 0.027519340505880494], mass: 1.096592582628907, energy: 1.3045847855149764, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, 4.5], velocity: [0.515755606122529, 0.027519340505880494], mass: 1.096592582628907, energy: 1.2860800367842675, epsilon: 1.3, material: 0 },
    Particle { position: [-2.5000000000000004, 5.499999999999999], velocity: [0.541398360549144, 0.027519340505880494], mass: 1.096592582628907, energy: 1.2675752880535585, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, -5.5], velocity: [-0.541398360549144, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.5066885611474532, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, -4.5], velocity: [-0.515755606122529, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.4877365037745294, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, -3.5000000000000004], velocity: [-0.46906166610269345, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.4687844464016053, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, -2.5000000000000004], velocity: [-0.38875437448127564, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.4498323890286815, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, -1.5], velocity: [-0.2633154442739151, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.4308803316557575, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, -0.5000000000000002], velocity: [-0.09409739611195685, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.4119282742828336, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, 0.49999999999999956], velocity: [0.09409739611195674, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.3929762169099096, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, 1.5], velocity: [0.2633154442739151, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.3740241595369855, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, 2.499999999999999], velocity: [0.3887543744812755, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.3550721021640617, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, 3.4999999999999996], velocity: [0.46906166610269345, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.3361200447911377, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, 4.5], velocity: [0.515755606122529, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.3171679874182138, epsilon: 1.3, material: 0 },
    Particle { position: [-1.5, 5.499999999999999], velocity: [0.541398360549144, 0.02014555544109273], mass: 1.0707106781186548, energy: 1.2982159300452898, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, -5.5], velocity: [-0.541398360549144, 0.007373785064787768], mass: 1.025881904510252, energy: 1.5725275238088463, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, -4.5], velocity: [-0.515755606122529, 0.007373785064787768], mass: 1.025881904510252, energy: 1.5527473033835775, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, -3.5000000000000004], velocity: [-0.46906166610269345, 0.007373785064787768], mass: 1.025881904510252, energy: 1.5329670829583093, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, -2.5000000000000004], velocity: [-0.38875437448127564, 0.007373785064787768], mass: 1.025881904510252, energy: 1.513186862533041, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, -1.5], velocity: [-0.2633154442739151, 0.007373785064787768], mass: 1.025881904510252, energy: 1.4934066421077723, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, -0.5000000000000002], velocity: [-0.09409739611195685, 0.007373785064787768], mass: 1.025881904510252, energy: 1.4736264216825037, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, 0.49999999999999956], velocity: [0.09409739611195674, 0.007373785064787768], mass: 1.025881904510252, energy: 1.4538462012572353, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, 1.5], velocity: [0.2633154442739151, 0.007373785064787768], mass: 1.025881904510252, energy: 1.4340659808319667, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, 2.499999999999999], velocity: [0.3887543744812755, 0.007373785064787768], mass: 1.025881904510252, energy: 1.4142857604066983, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, 3.4999999999999996], velocity: [0.46906166610269345, 0.007373785064787768], mass: 1.025881904510252, energy: 1.3945055399814297, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, 4.5], velocity: [0.515755606122529, 0.007373785064787768], mass: 1.025881904510252, energy: 1.3747253195561613, epsilon: 1.3, material: 0 },
    Particle { position: [-0.5000000000000002, 5.499999999999999], velocity: [0.541398360549144, 0.007373785064787768], mass: 1.025881904510252, energy: 1.3549450991308927, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, -5.5], velocity: [-0.541398360549144, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.6560903020785618, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, -4.5], velocity: [-0.515755606122529, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.6352589775241142, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, -3.5000000000000004], velocity: [-0.46906166610269345, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.614427652969667, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, -2.5000000000000004], velocity: [-0.38875437448127564, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.59359632841522, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, -1.5], velocity: [-0.2633154442739151, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.5727650038607726, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, -0.5000000000000002], velocity: [-0.09409739611195685, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.5519336793063252, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, 0.49999999999999956], velocity: [0.09409739611195674, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.5311023547518778, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, 1.5], velocity: [0.2633154442739151, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.5102710301974307, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, 2.499999999999999], velocity: [0.3887543744812755, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.4894397056429831, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, 3.4999999999999996], velocity: [0.46906166610269345, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.468608381088536, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, 4.5], velocity: [0.515755606122529, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.4477770565340886, epsilon: 1.3, material: 0 },
    Particle { position: [0.49999999999999956, 5.499999999999999], velocity: [0.541398360549144, -0.007373785064787749], mass: 0.9741180954897479, energy: 1.426945731979641, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, -5.5], velocity: [-0.541398360549144, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.735979842912466, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, -4.5], velocity: [-0.515755606122529, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.7141436184733154, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, -3.5000000000000004], velocity: [-0.46906166610269345, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.6923073940341649, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, -2.5000000000000004], velocity: [-0.38875437448127564, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.6704711695950145, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, -1.5], velocity: [-0.2633154442739151, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.648634945155864, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, -0.5000000000000002], velocity: [-0.09409739611195685, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.6267987207167134, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, 0.49999999999999956], velocity: [0.09409739611195674, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.6049624962775628, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, 1.5], velocity: [0.2633154442739151, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.5831262718384125, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, 2.499999999999999], velocity: [0.3887543744812755, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.561290047399262, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, 3.4999999999999996], velocity: [0.46906166610269345, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.5394538229601111, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, 4.5], velocity: [0.515755606122529, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.5176175985209608, epsilon: 1.3, material: 0 },
    Particle { position: [1.5, 5.499999999999999], velocity: [0.541398360549144, -0.020145555441092727], mass: 0.9292893218813453, energy: 1.4957813740818102, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, -5.5], velocity: [-0.541398360549144, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.7857142857142863, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, -4.5], velocity: [-0.515755606122529, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.763252470799641, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, -3.5000000000000004], velocity: [-0.46906166610269345, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.740790655884996, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, -2.5000000000000004], velocity: [-0.38875437448127564, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.718328840970351, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, -1.5], velocity: [-0.2633154442739151, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.6958670260557058, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, -0.5000000000000002], velocity: [-0.09409739611195685, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.6734052111410609, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, 0.49999999999999956], velocity: [0.09409739611195674, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.6509433962264155, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, 1.5], velocity: [0.2633154442739151, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.6284815813117706, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, 2.499999999999999], velocity: [0.3887543744812755, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.6060197663971256, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, 3.4999999999999996], velocity: [0.46906166610269345, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.5835579514824802, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, 4.5], velocity: [0.515755606122529, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.5610961365678353, epsilon: 1.3, material: 0 },
    Particle { position: [2.499999999999999, 5.499999999999999], velocity: [0.541398360549144, -0.027519340505880483], mass: 0.9034074173710932, energy: 1.5386343216531901, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, -5.5], velocity: [-0.541398360549144, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.7857142857142865, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, -4.5], velocity: [-0.515755606122529, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.7632524707996413, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, -3.5000000000000004], velocity: [-0.46906166610269345, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.7407906558849964, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, -2.5000000000000004], velocity: [-0.38875437448127564, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.7183288409703512, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, -1.5], velocity: [-0.2633154442739151, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.695867026055706, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, -0.5000000000000002], velocity: [-0.09409739611195685, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.673405211141061, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, 0.49999999999999956], velocity: [0.09409739611195674, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.6509433962264157, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, 1.5], velocity: [0.2633154442739151, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.6284815813117708, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, 2.499999999999999], velocity: [0.3887543744812755, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.6060197663971258, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, 3.4999999999999996], velocity: [0.46906166610269345, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.5835579514824807, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, 4.5], velocity: [0.515755606122529, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.5610961365678355, epsilon: 1.3, material: 0 },
    Particle { position: [3.4999999999999996, 5.499999999999999], velocity: [0.541398360549144, -0.027519340505880494], mass: 0.9034074173710931, energy: 1.5386343216531904, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, -5.5], velocity: [-0.541398360549144, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.735979842912466, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, -4.5], velocity: [-0.515755606122529, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.7141436184733154, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, -3.5000000000000004], velocity: [-0.46906166610269345, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.6923073940341649, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, -2.5000000000000004], velocity: [-0.38875437448127564, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.6704711695950145, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, -1.5], velocity: [-0.2633154442739151, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.648634945155864, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, -0.5000000000000002], velocity: [-0.09409739611195685, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.6267987207167134, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, 0.49999999999999956], velocity: [0.09409739611195674, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.6049624962775628, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, 1.5], velocity: [0.2633154442739151, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.5831262718384125, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, 2.499999999999999], velocity: [0.3887543744812755, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.561290047399262, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, 3.4999999999999996], velocity: [0.46906166610269345, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.5394538229601111, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, 4.5], velocity: [0.515755606122529, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.5176175985209608, epsilon: 1.3, material: 0 },
    Particle { position: [4.5, 5.499999999999999], velocity: [0.541398360549144, -0.02014555544109273], mass: 0.9292893218813453, energy: 1.4957813740818102, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, -5.5], velocity: [-0.541398360549144, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.656090302078562, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, -4.5], velocity: [-0.515755606122529, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.6352589775241146, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, -3.5000000000000004], velocity: [-0.46906166610269345, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.6144276529696675, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, -2.5000000000000004], velocity: [-0.38875437448127564, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.5935963284152201, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, -1.5], velocity: [-0.2633154442739151, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.5727650038607728, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, -0.5000000000000002], velocity: [-0.09409739611195685, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.5519336793063256, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, 0.49999999999999956], velocity: [0.09409739611195674, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.531102354751878, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, 1.5], velocity: [0.2633154442739151, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.5102710301974307, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, 2.499999999999999], velocity: [0.3887543744812755, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.4894397056429836, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, 3.4999999999999996], velocity: [0.46906166610269345, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.468608381088536, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, 4.5], velocity: [0.515755606122529, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.4477770565340888, epsilon: 1.3, material: 0 },
    Particle { position: [5.499999999999999, 5.499999999999999], velocity: [0.541398360549144, -0.0073737850647877835], mass: 0.9741180954897478, energy: 1.4269457319796415, epsilon: 1.3, material: 0 },
];

/// The memory of the particles.
pub type Storage<S> = OptionsStorage<S, 2, PARTICLES, CELLS>;

/// All memory of a run but the stack.
pub struct Memory<S: Scalar> {
    cloud: Storage<S>,
    lists: Option<[Material<S>; 1]>,
}

impl<S: Scalar> Memory<S> {
    /// No particles yet.
    pub const fn new() -> Self {
        Self {
            cloud: Storage::new(),
            lists: None,
        }
    }
}

impl<S: Scalar> Default for Memory<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// A run between two steps.
pub type Run<'m, S> =
    Stepper<S, GasDynamics<'m, S, CutOff, Viscosity<S>, Material<S>, Options<S, 2>, 2>, HalfLoop, &'m mut Storage<S>, 2>;

/// A run at its start. Error: what the scalar cannot hold.
pub fn start<S: Scalar>(memory: &mut Memory<S>) -> Result<Run<'_, S>, Error> {
    let Memory { cloud, lists } = memory;
    cloud.clear();
    for particle in &CLOUD {
        cloud.push(particle.rounded())?;
    }
    let dynamics = GasDynamics {
        domain: domain(),
        cut_off: CUT_OFF,
        width: Width::Adaptive { eta: S::from_f64(1.3), packing: Packing::Cubic },
        viscosity: viscosity(),
        materials: lists.insert(materials()).as_slice(),
        physics: physics(),
        courant: S::from_f64(0.3),
        smallest_omega: S::from_f64(0.03125),
    };
    let method = LeapFrog;
    Ok(Stepper::new(dynamics, method, HalfLoop, cloud)?.until(S::from_f64(2.1059934036195322)))
}
