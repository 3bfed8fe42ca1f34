//! Made by `motes export tests/exported/block.toml`, not by hand.
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
use motes_core::equation::diffusion::{
    Condition, Conductor, DiffusionDynamics, DiffusionProblem, DiffusionStorage, Drive,
    DrivenCondition, Form, LargestDiffusivity, Lists, Mean, Modulation, NamedProblem, Reaction,
};
use motes_core::equation::linear::systems::Units;
use motes_core::equation::linear::{Particle, Place, Still};
use motes_core::error::Error;
use motes_core::integrator::{DiffusionMethod, RK4, Scheme, Stepper};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = "block";

/// Number of particles.
pub const PARTICLES: usize = 216;

/// Cells they can take, and one.
pub const CELLS: usize = 993;

/// Points of the series at all walls.
pub const POINTS: usize = 3;

/// Layers of the conductor.
pub const LAYERS: usize = 0;

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::WendlandC2;

/// Diffusivities, reaction and walls, in solver units.
#[rustfmt::skip]
pub const PROBLEM: NamedProblem<'static, f64, 3, 1> = NamedProblem {
    diffusivity: [0.5],
    conductor: Conductor::Uniform,
    modulation: Modulation { amplitude: 0.0, frequency: 0.0 },
    tensor: None,
    reaction: Reaction::None,
    walls: [[
        [DrivenCondition::Value(Drive::Series(&[
            (0.0, 0.0),
            (0.216, 1.0),
            (1.0799999999999998, 0.5),
        ]))],
        [DrivenCondition::NoFlux],
    ], [
        [DrivenCondition::NoFlux],
        [DrivenCondition::NoFlux],
    ], [
        [DrivenCondition::NoFlux],
        [DrivenCondition::NoFlux],
    ]],
};

/// The way between the solver's numbers and those of the scenario.
pub const FRAME: Frame = Frame {
    middle: [0.5, 0.5, 0.5],
    units: Units {
        length: 0.16666666666666669,
        velocity: 0.9,
    },
};

/// The largest diffusivity of the domain, in the scenario's units.
const PEAKS: LargestDiffusivity<'static> = LargestDiffusivity {
    values: &[0.15000000000000002, 0.11872892787909722, 0.09723665527410147, 0.08246524673583497, 0.07231301601484298, 0.06533549668449284, 0.06053992245618644, 0.05724397570342515, 0.0549787068367864],
    duration: 3.0,
    margin: 1.25,
};

/// The problem: what formulas say, and the rest.
#[derive(Clone, Copy, Debug)]
pub struct Problem<'m, S> {
    /// The rest.
    pub named: NamedProblem<'m, S, 3, 1>,
}

impl<S: Scalar> DiffusionProblem<S, 3, 1> for Problem<'_, S> {
    fn diffusivity(&self, place: &Place<S, 3>) -> [S; 1] {
        let [x, _, _, t] = FRAME.point(place);
        [
            FRAME.diffusivity(0.05 + 0.1 * elementary::power(x, 2.0) * libm::exp(-t)),
        ]
    }
    fn between(&self, ends: [S; 2], time: S) -> Option<[S; 1]> {
        DiffusionProblem::<S, 3, 1>::between(&self.named, ends, time)
    }
    fn headroom(&self, time: S) -> S {
        S::from_f64(PEAKS.headroom(FRAME.seconds(time)))
    }
    fn tensor(&self) -> Option<[[S; 3]; 3]> {
        self.named.tensor
    }
    fn reaction(&self, _: &Place<S, 3>, u: &[S; 1]) -> [S; 1] {
        self.named.reaction.rate(u)
    }
    fn reaction_rate(&self) -> S {
        self.named.reaction.bound()
    }
    fn largest_reaction(&self, u: f64) -> f64 {
        self.named.reaction.largest(u)
    }
    fn wall(&self, axis: usize, end: usize, time: S) -> [Condition<S>; 1] {
        self.named.wall(axis, end, time)
    }
}

/// The domain, in solver units.
pub fn domain<S: Scalar>() -> Domain<S, 3> {
    Domain {
        axes: [
            Axis {
                lower: S::from_f64(-3.0),
                upper: S::from_f64(3.0),
                sides: [Side::Mirror, Side::Mirror],
            },
            Axis {
                lower: S::from_f64(-3.0),
                upper: S::from_f64(3.0),
                sides: [Side::Mirror, Side::Mirror],
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
pub static CLOUD: [Particle<f64, 3, 1>; PARTICLES] = [
    Particle { position: [-2.5, -2.5, -2.5], weight: 1.0, value: [0.9330127018922194] },
    Particle { position: [-2.5, -2.5, -1.5], weight: 1.0, value: [0.9330127018922194] },
    Particle { position: [-2.5, -2.5, -0.4999999999999999], weight: 1.0, value: [0.9330127018922194] },
    Particle { position: [-2.5, -2.5, 0.5000000000000002], weight: 1.0, value: [0.9330127018922194] },
    Particle { position: [-2.5, -2.5, 1.5], weight: 1.0, value: [0.9330127018922194] },
    Particle { position: [-2.5, -2.5, 2.5], weight: 1.0, value: [0.9330127018922194] },
    Particle { position: [-2.5, -1.5, -2.5], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-2.5, -1.5, -1.5], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-2.5, -1.5, -0.4999999999999999], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-2.5, -1.5, 0.5000000000000002], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-2.5, -1.5, 1.5], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-2.5, -1.5, 2.5], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-2.5, -0.4999999999999999, -2.5], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-2.5, -0.4999999999999999, -1.5], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-2.5, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-2.5, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-2.5, -0.4999999999999999, 1.5], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-2.5, -0.4999999999999999, 2.5], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-2.5, 0.5000000000000002, -2.5], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [-2.5, 0.5000000000000002, -1.5], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [-2.5, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [-2.5, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [-2.5, 0.5000000000000002, 1.5], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [-2.5, 0.5000000000000002, 2.5], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [-2.5, 1.5, -2.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-2.5, 1.5, -1.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-2.5, 1.5, -0.4999999999999999], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-2.5, 1.5, 0.5000000000000002], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-2.5, 1.5, 1.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-2.5, 1.5, 2.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-2.5, 2.5, -2.5], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [-2.5, 2.5, -1.5], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [-2.5, 2.5, -0.4999999999999999], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [-2.5, 2.5, 0.5000000000000002], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [-2.5, 2.5, 1.5], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [-2.5, 2.5, 2.5], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [-1.5, -2.5, -2.5], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-1.5, -2.5, -1.5], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-1.5, -2.5, -0.4999999999999999], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-1.5, -2.5, 0.5000000000000002], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-1.5, -2.5, 1.5], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-1.5, -2.5, 2.5], weight: 1.0, value: [0.6830127018922194] },
    Particle { position: [-1.5, -1.5, -2.5], weight: 1.0, value: [0.5000000000000001] },
    Particle { position: [-1.5, -1.5, -1.5], weight: 1.0, value: [0.5000000000000001] },
    Particle { position: [-1.5, -1.5, -0.4999999999999999], weight: 1.0, value: [0.5000000000000001] },
    Particle { position: [-1.5, -1.5, 0.5000000000000002], weight: 1.0, value: [0.5000000000000001] },
    Particle { position: [-1.5, -1.5, 1.5], weight: 1.0, value: [0.5000000000000001] },
    Particle { position: [-1.5, -1.5, 2.5], weight: 1.0, value: [0.5000000000000001] },
    Particle { position: [-1.5, -0.4999999999999999, -2.5], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-1.5, -0.4999999999999999, -1.5], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-1.5, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-1.5, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-1.5, -0.4999999999999999, 1.5], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-1.5, -0.4999999999999999, 2.5], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-1.5, 0.5000000000000002, -2.5], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [-1.5, 0.5000000000000002, -1.5], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [-1.5, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [-1.5, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [-1.5, 0.5000000000000002, 1.5], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [-1.5, 0.5000000000000002, 2.5], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [-1.5, 1.5, -2.5], weight: 1.0, value: [-0.5] },
    Particle { position: [-1.5, 1.5, -1.5], weight: 1.0, value: [-0.5] },
    Particle { position: [-1.5, 1.5, -0.4999999999999999], weight: 1.0, value: [-0.5] },
    Particle { position: [-1.5, 1.5, 0.5000000000000002], weight: 1.0, value: [-0.5] },
    Particle { position: [-1.5, 1.5, 1.5], weight: 1.0, value: [-0.5] },
    Particle { position: [-1.5, 1.5, 2.5], weight: 1.0, value: [-0.5] },
    Particle { position: [-1.5, 2.5, -2.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-1.5, 2.5, -1.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-1.5, 2.5, -0.4999999999999999], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-1.5, 2.5, 0.5000000000000002], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-1.5, 2.5, 1.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-1.5, 2.5, 2.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [-0.4999999999999999, -2.5, -2.5], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-0.4999999999999999, -2.5, -1.5], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-0.4999999999999999, -2.5, -0.4999999999999999], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-0.4999999999999999, -2.5, 0.5000000000000002], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-0.4999999999999999, -2.5, 1.5], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-0.4999999999999999, -2.5, 2.5], weight: 1.0, value: [0.24999999999999997] },
    Particle { position: [-0.4999999999999999, -1.5, -2.5], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-0.4999999999999999, -1.5, -1.5], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-0.4999999999999999, -1.5, -0.4999999999999999], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-0.4999999999999999, -1.5, 0.5000000000000002], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-0.4999999999999999, -1.5, 1.5], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-0.4999999999999999, -1.5, 2.5], weight: 1.0, value: [0.18301270189221933] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, -2.5], weight: 1.0, value: [0.06698729810778066] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, -1.5], weight: 1.0, value: [0.06698729810778066] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [0.06698729810778066] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [0.06698729810778066] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, 1.5], weight: 1.0, value: [0.06698729810778066] },
    Particle { position: [-0.4999999999999999, -0.4999999999999999, 2.5], weight: 1.0, value: [0.06698729810778066] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, -2.5], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, -1.5], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, 1.5], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [-0.4999999999999999, 0.5000000000000002, 2.5], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [-0.4999999999999999, 1.5, -2.5], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [-0.4999999999999999, 1.5, -1.5], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [-0.4999999999999999, 1.5, -0.4999999999999999], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [-0.4999999999999999, 1.5, 0.5000000000000002], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [-0.4999999999999999, 1.5, 1.5], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [-0.4999999999999999, 1.5, 2.5], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [-0.4999999999999999, 2.5, -2.5], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [-0.4999999999999999, 2.5, -1.5], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [-0.4999999999999999, 2.5, -0.4999999999999999], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [-0.4999999999999999, 2.5, 0.5000000000000002], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [-0.4999999999999999, 2.5, 1.5], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [-0.4999999999999999, 2.5, 2.5], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [0.5000000000000002, -2.5, -2.5], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [0.5000000000000002, -2.5, -1.5], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [0.5000000000000002, -2.5, -0.4999999999999999], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [0.5000000000000002, -2.5, 0.5000000000000002], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [0.5000000000000002, -2.5, 1.5], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [0.5000000000000002, -2.5, 2.5], weight: 1.0, value: [-0.2500000000000001] },
    Particle { position: [0.5000000000000002, -1.5, -2.5], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [0.5000000000000002, -1.5, -1.5], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [0.5000000000000002, -1.5, -0.4999999999999999], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [0.5000000000000002, -1.5, 0.5000000000000002], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [0.5000000000000002, -1.5, 1.5], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [0.5000000000000002, -1.5, 2.5], weight: 1.0, value: [-0.1830127018922194] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, -2.5], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, -1.5], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, 1.5], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [0.5000000000000002, -0.4999999999999999, 2.5], weight: 1.0, value: [-0.06698729810778069] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, -2.5], weight: 1.0, value: [0.06698729810778072] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, -1.5], weight: 1.0, value: [0.06698729810778072] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [0.06698729810778072] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [0.06698729810778072] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, 1.5], weight: 1.0, value: [0.06698729810778072] },
    Particle { position: [0.5000000000000002, 0.5000000000000002, 2.5], weight: 1.0, value: [0.06698729810778072] },
    Particle { position: [0.5000000000000002, 1.5, -2.5], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [0.5000000000000002, 1.5, -1.5], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [0.5000000000000002, 1.5, -0.4999999999999999], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [0.5000000000000002, 1.5, 0.5000000000000002], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [0.5000000000000002, 1.5, 1.5], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [0.5000000000000002, 1.5, 2.5], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [0.5000000000000002, 2.5, -2.5], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [0.5000000000000002, 2.5, -1.5], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [0.5000000000000002, 2.5, -0.4999999999999999], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [0.5000000000000002, 2.5, 0.5000000000000002], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [0.5000000000000002, 2.5, 1.5], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [0.5000000000000002, 2.5, 2.5], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [1.5, -2.5, -2.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [1.5, -2.5, -1.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [1.5, -2.5, -0.4999999999999999], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [1.5, -2.5, 0.5000000000000002], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [1.5, -2.5, 1.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [1.5, -2.5, 2.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [1.5, -1.5, -2.5], weight: 1.0, value: [-0.5] },
    Particle { position: [1.5, -1.5, -1.5], weight: 1.0, value: [-0.5] },
    Particle { position: [1.5, -1.5, -0.4999999999999999], weight: 1.0, value: [-0.5] },
    Particle { position: [1.5, -1.5, 0.5000000000000002], weight: 1.0, value: [-0.5] },
    Particle { position: [1.5, -1.5, 1.5], weight: 1.0, value: [-0.5] },
    Particle { position: [1.5, -1.5, 2.5], weight: 1.0, value: [-0.5] },
    Particle { position: [1.5, -0.4999999999999999, -2.5], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [1.5, -0.4999999999999999, -1.5], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [1.5, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [1.5, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [1.5, -0.4999999999999999, 1.5], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [1.5, -0.4999999999999999, 2.5], weight: 1.0, value: [-0.1830127018922193] },
    Particle { position: [1.5, 0.5000000000000002, -2.5], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [1.5, 0.5000000000000002, -1.5], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [1.5, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [1.5, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [1.5, 0.5000000000000002, 1.5], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [1.5, 0.5000000000000002, 2.5], weight: 1.0, value: [0.18301270189221938] },
    Particle { position: [1.5, 1.5, -2.5], weight: 1.0, value: [0.4999999999999999] },
    Particle { position: [1.5, 1.5, -1.5], weight: 1.0, value: [0.4999999999999999] },
    Particle { position: [1.5, 1.5, -0.4999999999999999], weight: 1.0, value: [0.4999999999999999] },
    Particle { position: [1.5, 1.5, 0.5000000000000002], weight: 1.0, value: [0.4999999999999999] },
    Particle { position: [1.5, 1.5, 1.5], weight: 1.0, value: [0.4999999999999999] },
    Particle { position: [1.5, 1.5, 2.5], weight: 1.0, value: [0.4999999999999999] },
    Particle { position: [1.5, 2.5, -2.5], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [1.5, 2.5, -1.5], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [1.5, 2.5, -0.4999999999999999], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [1.5, 2.5, 0.5000000000000002], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [1.5, 2.5, 1.5], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [1.5, 2.5, 2.5], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [2.5, -2.5, -2.5], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [2.5, -2.5, -1.5], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [2.5, -2.5, -0.4999999999999999], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [2.5, -2.5, 0.5000000000000002], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [2.5, -2.5, 1.5], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [2.5, -2.5, 2.5], weight: 1.0, value: [-0.9330127018922193] },
    Particle { position: [2.5, -1.5, -2.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [2.5, -1.5, -1.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [2.5, -1.5, -0.4999999999999999], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [2.5, -1.5, 0.5000000000000002], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [2.5, -1.5, 1.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [2.5, -1.5, 2.5], weight: 1.0, value: [-0.6830127018922193] },
    Particle { position: [2.5, -0.4999999999999999, -2.5], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [2.5, -0.4999999999999999, -1.5], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [2.5, -0.4999999999999999, -0.4999999999999999], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [2.5, -0.4999999999999999, 0.5000000000000002], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [2.5, -0.4999999999999999, 1.5], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [2.5, -0.4999999999999999, 2.5], weight: 1.0, value: [-0.24999999999999994] },
    Particle { position: [2.5, 0.5000000000000002, -2.5], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [2.5, 0.5000000000000002, -1.5], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [2.5, 0.5000000000000002, -0.4999999999999999], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [2.5, 0.5000000000000002, 0.5000000000000002], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [2.5, 0.5000000000000002, 1.5], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [2.5, 0.5000000000000002, 2.5], weight: 1.0, value: [0.25000000000000006] },
    Particle { position: [2.5, 1.5, -2.5], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [2.5, 1.5, -1.5], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [2.5, 1.5, -0.4999999999999999], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [2.5, 1.5, 0.5000000000000002], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [2.5, 1.5, 1.5], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [2.5, 1.5, 2.5], weight: 1.0, value: [0.6830127018922192] },
    Particle { position: [2.5, 2.5, -2.5], weight: 1.0, value: [0.9330127018922192] },
    Particle { position: [2.5, 2.5, -1.5], weight: 1.0, value: [0.9330127018922192] },
    Particle { position: [2.5, 2.5, -0.4999999999999999], weight: 1.0, value: [0.9330127018922192] },
    Particle { position: [2.5, 2.5, 0.5000000000000002], weight: 1.0, value: [0.9330127018922192] },
    Particle { position: [2.5, 2.5, 1.5], weight: 1.0, value: [0.9330127018922192] },
    Particle { position: [2.5, 2.5, 2.5], weight: 1.0, value: [0.9330127018922192] },
];

/// The memory of the particles.
pub type Storage<S> = DiffusionStorage<S, 3, 1, PARTICLES, CELLS>;

/// All memory of a run but the stack.
pub struct Memory<S: Scalar> {
    cloud: Storage<S>,
    lists: Lists<S, POINTS, LAYERS>,
}

impl<S: Scalar> Memory<S> {
    /// No particles yet.
    pub const fn new() -> Self {
        Self {
            cloud: Storage::new(),
            lists: Lists::new(),
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
    Stepper<S, DiffusionDynamics<S, CutOff, Problem<'m, S>, Still, 3, 1>, HalfLoop, &'m mut Storage<S>, 3>;

/// A run at its start. Error: what the scalar cannot hold.
pub fn start<S: Scalar>(memory: &mut Memory<S>) -> Result<Run<'_, S>, Error> {
    let Memory { cloud, lists } = memory;
    cloud.clear();
    for particle in &CLOUD {
        cloud.push(particle.rounded())?;
    }
    let dynamics = DiffusionDynamics {
        domain: domain(),
        cut_off: CUT_OFF,
        epsilon: S::from_f64(0.9),
        problem: Problem {
            named: PROBLEM.rounded(lists)?,
        },
        field: Still,
        form: Form::Mixed,
        mean: Mean::Arithmetic,
        courant: S::from_f64(0.5),
    };
    let method = DiffusionMethod {
        scheme: Scheme::RungeKutta(RK4),
        longest: S::from_f64(0.253125),
    };
    Ok(Stepper::new(dynamics, method, HalfLoop, cloud)?.until(S::from_f64(16.2)))
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
