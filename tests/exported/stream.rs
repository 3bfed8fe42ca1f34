//! Made by `motes export tests/exported/stream.toml`, not by hand.
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
use motes_core::equation::linear::systems::{Transport, Units};
use motes_core::equation::linear::{
    FirstOrderSystem, LinearDynamics, LinearStorage, Particle, Place, VelocityField,
};
use motes_core::error::Error;
use motes_core::integrator::{RK4, Stepper};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = "stream";

/// Number of particles.
pub const PARTICLES: usize = 48;

/// Cells they can take, and one.
pub const CELLS: usize = 321;

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::QuinticSpline;

/// The way between the solver's numbers and those of the scenario.
pub const FRAME: Frame = Frame {
    middle: [2.0, 0.0, 0.0],
    units: Units {
        length: 0.08333333333333333,
        velocity: 0.7995717846477207,
    },
};

/// What carries the quantity: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct Flow;

impl<S: Scalar> VelocityField<S, 1> for Flow {
    fn velocity(&self, place: &Place<S, 1>) -> [S; 1] {
        let [x, _, _, t] = FRAME.point(place);
        [
            FRAME.velocity(0.6 + 0.2 * libm::sin(core::f64::consts::PI * x / 2.0) * libm::cos(3.0 * t)),
        ]
    }
    fn divergence(&self, place: &Place<S, 1>) -> S {
        let [x, _, _, t] = FRAME.point(place);
        FRAME.rate(0.2 * (libm::cos(core::f64::consts::PI * x / 2.0) * 1.5707963267948966) * libm::cos(3.0 * t))
    }
    fn gradient(&self) -> S {
        S::from_f64(0.04092806187415904)
    }
    fn convergence(&self) -> S {
        S::from_f64(0.04092806187415904)
    }
}

/// The equations.
pub fn system<S: Scalar>() -> Transport<S, Flow> {
    let velocity = Flow;
    Transport {
        velocity,
        decay: S::from_f64(0.020844490747018732),
        source: S::from_f64(0.010422245373509366),
    }
}

/// What the particles follow: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct Motion;

impl<S: Scalar> VelocityField<S, 1> for Motion {
    fn velocity(&self, place: &Place<S, 1>) -> [S; 1] {
        let [x, _, _, t] = FRAME.point(place);
        [
            FRAME.velocity(0.6 + 0.2 * libm::sin(core::f64::consts::PI * x / 2.0) * libm::cos(3.0 * t)),
        ]
    }
    fn divergence(&self, place: &Place<S, 1>) -> S {
        let [x, _, _, t] = FRAME.point(place);
        FRAME.rate(0.2 * (libm::cos(core::f64::consts::PI * x / 2.0) * 1.5707963267948966) * libm::cos(3.0 * t))
    }
    fn gradient(&self) -> S {
        S::from_f64(0.04092806187415904)
    }
    fn convergence(&self) -> S {
        S::from_f64(0.04092806187415904)
    }
}

/// The domain, in solver units.
pub fn domain<S: Scalar>() -> Domain<S, 1> {
    Domain {
        axes: [
            Axis {
                lower: S::from_f64(-24.0),
                upper: S::from_f64(24.0),
                sides: [Side::Periodic, Side::Periodic],
            },
        ],
    }
}

/// The particles at the start, in solver units.
#[rustfmt::skip]
pub static CLOUD: [Particle<f64, 1, 1>; PARTICLES] = [
    Particle { position: [-23.5], weight: 1.0, value: [4.738097796288129e-14] },
    Particle { position: [-22.5], weight: 1.0, value: [6.101936677605324e-13] },
    Particle { position: [-21.5], weight: 1.0, value: [7.031960620840752e-12] },
    Particle { position: [-20.5], weight: 1.0, value: [7.251539569325322e-11] },
    Particle { position: [-19.5], weight: 1.0, value: [6.691586091292783e-10] },
    Particle { position: [-18.5], weight: 1.0, value: [5.5255177203667114e-9] },
    Particle { position: [-17.5], weight: 1.0, value: [4.082836041142489e-8] },
    Particle { position: [-16.5], weight: 1.0, value: [2.6995785033630146e-7] },
    Particle { position: [-15.499999999999998], weight: 1.0, value: [1.5972578828343192e-6] },
    Particle { position: [-14.500000000000002], weight: 1.0, value: [8.456665968701077e-6] },
    Particle { position: [-13.5], weight: 1.0, value: [4.006529739295107e-5] },
    Particle { position: [-12.499999999999998], weight: 1.0, value: [0.00016985667656141097] },
    Particle { position: [-11.5], weight: 1.0, value: [0.0006443798205686088] },
    Particle { position: [-10.5], weight: 1.0, value: [0.002187491118182885] },
    Particle { position: [-9.5], weight: 1.0, value: [0.006645011282741393] },
    Particle { position: [-8.5], weight: 1.0, value: [0.01806301341978129] },
    Particle { position: [-7.5], weight: 1.0, value: [0.04393693362340742] },
    Particle { position: [-6.500000000000001], weight: 1.0, value: [0.09563444483253856] },
    Particle { position: [-5.499999999999999], weight: 1.0, value: [0.186270463697701] },
    Particle { position: [-4.5], weight: 1.0, value: [0.32465246735834974] },
    Particle { position: [-3.500000000000001], weight: 1.0, value: [0.5063356166481005] },
    Particle { position: [-2.499999999999999], weight: 1.0, value: [0.7066482778577164] },
    Particle { position: [-1.5], weight: 1.0, value: [0.8824969025845955] },
    Particle { position: [-0.5000000000000009], weight: 1.0, value: [0.9862071167439161] },
    Particle { position: [0.4999999999999982], weight: 1.0, value: [0.9862071167439164] },
    Particle { position: [1.5], weight: 1.0, value: [0.8824969025845955] },
    Particle { position: [2.5000000000000018], weight: 1.0, value: [0.7066482778577159] },
    Particle { position: [3.4999999999999982], weight: 1.0, value: [0.5063356166481009] },
    Particle { position: [4.5], weight: 1.0, value: [0.32465246735834974] },
    Particle { position: [5.500000000000002], weight: 1.0, value: [0.18627046369770067] },
    Particle { position: [6.499999999999998], weight: 1.0, value: [0.09563444483253873] },
    Particle { position: [7.5], weight: 1.0, value: [0.04393693362340742] },
    Particle { position: [8.500000000000002], weight: 1.0, value: [0.018063013419781258] },
    Particle { position: [9.499999999999998], weight: 1.0, value: [0.006645011282741416] },
    Particle { position: [10.5], weight: 1.0, value: [0.002187491118182885] },
    Particle { position: [11.500000000000002], weight: 1.0, value: [0.000644379820568607] },
    Particle { position: [12.499999999999998], weight: 1.0, value: [0.00016985667656141097] },
    Particle { position: [13.5], weight: 1.0, value: [4.006529739295107e-5] },
    Particle { position: [14.500000000000002], weight: 1.0, value: [8.456665968701077e-6] },
    Particle { position: [15.499999999999998], weight: 1.0, value: [1.5972578828343192e-6] },
    Particle { position: [16.5], weight: 1.0, value: [2.6995785033630146e-7] },
    Particle { position: [17.5], weight: 1.0, value: [4.082836041142489e-8] },
    Particle { position: [18.5], weight: 1.0, value: [5.525517720366731e-9] },
    Particle { position: [19.5], weight: 1.0, value: [6.691586091292783e-10] },
    Particle { position: [20.5], weight: 1.0, value: [7.251539569325296e-11] },
    Particle { position: [21.5], weight: 1.0, value: [7.0319606208408024e-12] },
    Particle { position: [22.5], weight: 1.0, value: [6.101936677605324e-13] },
    Particle { position: [23.5], weight: 1.0, value: [4.7380977962880955e-14] },
];

/// All memory of a run but the stack.
pub type Memory<S> = LinearStorage<
    S,
    <Transport<S, Flow> as FirstOrderSystem<S, 1, 1>>::Medium,
    1,
    1,
    PARTICLES,
    CELLS,
>;

/// A run between two steps.
pub type Run<'m, S> =
    Stepper<S, LinearDynamics<S, CutOff, Transport<S, Flow>, Motion, 1, 1>, HalfLoop, &'m mut Memory<S>, 1>;

/// A run at its start. Error: what the scalar cannot hold.
pub fn start<S: Scalar>(memory: &mut Memory<S>) -> Result<Run<'_, S>, Error> {
    let cloud = memory;
    cloud.clear();
    for particle in &CLOUD {
        cloud.push(particle.rounded())?;
    }
    let width = (CUT_OFF, S::from_f64(3.1585776310859814));
    let dynamics = LinearDynamics::new(domain(), width, system(), Motion, S::from_f64(0.5));
    let method = RK4;
    let mut run = Stepper::new(dynamics, method, HalfLoop, cloud)?.until(S::from_f64(9.594861415772648));
    run.step = Some(S::from_f64(0.19189722831545297));
    Ok(run)
}
