//! Made by `motes export tests/exported/reactor.toml`, not by hand.
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
    Condition, Conductor, Corners, DiffusionDynamics, DiffusionProblem, DirectStorage, Drive,
    DrivenCondition, Form, LargestDiffusivity, Lists, Mean, Modulation, NamedProblem, Reaction,
    ReactionPoint,
};
use motes_core::equation::linear::systems::Units;
use motes_core::equation::linear::{Particle, Place, VelocityField};
use motes_core::error::Error;
use motes_core::integrator::{DiffusionMethod, Scheme, Stepper};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = "reactor";

/// Number of particles.
pub const PARTICLES: usize = 162;

/// Cells they can take, and one.
pub const CELLS: usize = 777;

/// Points of the series at all walls.
pub const POINTS: usize = 0;

/// Layers of the conductor.
pub const LAYERS: usize = 0;

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::WendlandC2;

/// Diffusivities, reaction and walls, in solver units.
#[rustfmt::skip]
pub const PROBLEM: NamedProblem<'static, f64, 2, 4> = NamedProblem {
    diffusivity: [0.8049844718999243, 0.5031152949374527, 0.20124611797498107, 0.0],
    conductor: Conductor::Uniform,
    modulation: Modulation { amplitude: 0.0, frequency: 0.0 },
    tensor: None,
    reaction: Reaction::None,
    walls: [[
        [DrivenCondition::Value(Drive::Constant(0.0)), DrivenCondition::NoFlux, DrivenCondition::NoFlux, DrivenCondition::NoFlux],
        [DrivenCondition::NoFlux, DrivenCondition::Flux(Drive::Constant(0.0)), DrivenCondition::Exchange { rate: 1.3416407864998736, outside: Drive::Constant(0.0) }, DrivenCondition::NoFlux],
    ], [
        [DrivenCondition::NoFlux, DrivenCondition::NoFlux, DrivenCondition::NoFlux, DrivenCondition::NoFlux],
        [DrivenCondition::NoFlux, DrivenCondition::NoFlux, DrivenCondition::NoFlux, DrivenCondition::NoFlux],
    ]],
};

/// The way between the solver's numbers and those of the scenario.
pub const FRAME: Frame = Frame {
    middle: [1.0, 0.5, 0.0],
    units: Units {
        length: 0.1111111111111111,
        velocity: 0.223606797749979,
    },
};

/// The largest diffusivity of the domain, in the scenario's units.
const PEAKS: LargestDiffusivity<'static> = LargestDiffusivity {
    values: &[0.02, 0.021986693307950615, 0.023894183423086503, 0.025646424733950353, 0.027173560908995226, 0.028414709848078968, 0.029320390859672262, 0.029854497299884604, 0.02999573603041505],
    duration: 0.4,
    margin: 1.25,
};

/// The rates of the reaction at a place, a time and unknowns, in the scenario's units.
fn rates(&[_, _, _, t, u0, u1, u2, _]: &ReactionPoint) -> [f64; 3] {
    [
        -2.0 * u0 * u1 + 0.1 * libm::sin(t),
        -2.0 * u0 * u1,
        2.0 * u0 * u1 - 0.5 * u2,
    ]
}

/// Where they are looked at for the largest.
const CORNERS: Corners = Corners {
    dimension: 2,
    species: 3,
    middle: [1.0, 0.5, 0.0],
    half: [1.0, 0.5, 0.0],
    duration: 0.4,
};

/// The problem: what formulas say, and the rest.
#[derive(Clone, Copy, Debug)]
pub struct Problem<'m, S> {
    /// The rest.
    pub named: NamedProblem<'m, S, 2, 4>,
}

impl<S: Scalar> DiffusionProblem<S, 2, 4> for Problem<'_, S> {
    fn diffusivity(&self, place: &Place<S, 2>) -> [S; 4] {
        let [x, y, _, t] = FRAME.point(place);
        [
            FRAME.diffusivity(0.02 * (1.0 + 0.5 * libm::sin(4.0 * t) * libm::exp(-x))),
            FRAME.diffusivity(0.01 + 0.01 * elementary::power(y, 2.0)),
            FRAME.diffusivity(0.005),
            S::ZERO,
        ]
    }
    fn between(&self, ends: [S; 2], time: S) -> Option<[S; 4]> {
        DiffusionProblem::<S, 2, 4>::between(&self.named, ends, time)
    }
    fn headroom(&self, time: S) -> S {
        S::from_f64(PEAKS.headroom(FRAME.seconds(time)))
    }
    fn tensor(&self) -> Option<[[S; 2]; 2]> {
        self.named.tensor
    }
    fn reaction(&self, place: &Place<S, 2>, u: &[S; 4]) -> [S; 4] {
        let [x, y, z, t] = FRAME.point(place);
        let mut point = [x, y, z, t, 0.0, 0.0, 0.0, 0.0];
        for (slot, u) in point.iter_mut().skip(4).zip(u) {
            *slot = u.to_f64();
        }
        let rates = rates(&point);
        [
            FRAME.rate(rates[0]),
            FRAME.rate(rates[1]),
            FRAME.rate(rates[2]),
            S::ZERO,
        ]
    }
    fn reaction_rate(&self) -> S {
        FRAME.rate(10.625)
    }
    fn largest_reaction(&self, u: f64) -> f64 {
        let mut largest = 0.0;
        CORNERS.each(u, |point| {
            for rate in rates(point) {
                largest = f64::max(largest, libm::fabs(rate));
            }
        });
        1.25 * largest * FRAME.units.time()
    }
    fn wall(&self, axis: usize, end: usize, time: S) -> [Condition<S>; 4] {
        let mut conditions = self.named.wall(axis, end, time);
        let t = FRAME.seconds(time);
        if (axis, end) == (0, 0) {
            conditions[0] = conditions[0].with(FRAME.number(1.0 + 0.5 * libm::sin(6.0 * t)));
        }
        if (axis, end) == (0, 1) {
            conditions[1] = conditions[1].with(FRAME.velocity(-0.05 * t));
        }
        if (axis, end) == (0, 1) {
            conditions[2] = conditions[2].with(FRAME.number(libm::exp(-t)));
        }
        conditions
    }
}

/// What the particles follow: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct Motion;

impl<S: Scalar> VelocityField<S, 2> for Motion {
    fn velocity(&self, place: &Place<S, 2>) -> [S; 2] {
        let [x, _, _, t] = FRAME.point(place);
        [
            FRAME.velocity(0.1 * libm::sin(core::f64::consts::PI * x) * libm::cos(t)),
            FRAME.velocity(0.2),
        ]
    }
    fn divergence(&self, place: &Place<S, 2>) -> S {
        let [x, _, _, t] = FRAME.point(place);
        FRAME.rate((0.1 * (libm::cos(core::f64::consts::PI * x) * core::f64::consts::PI) * libm::cos(t)) + 0.0)
    }
    fn gradient(&self) -> S {
        S::from_f64(0.19513374252890903)
    }
    fn convergence(&self) -> S {
        S::from_f64(0.19513374252890903)
    }
}

/// The domain, in solver units.
pub fn domain<S: Scalar>() -> Domain<S, 2> {
    Domain {
        axes: [
            Axis {
                lower: S::from_f64(-9.0),
                upper: S::from_f64(9.0),
                sides: [Side::Mirror, Side::Mirror],
            },
            Axis {
                lower: S::from_f64(-4.5),
                upper: S::from_f64(4.5),
                sides: [Side::Periodic, Side::Periodic],
            },
        ],
    }
}

/// The particles at the start, in solver units.
#[rustfmt::skip]
pub static CLOUD: [Particle<f64, 2, 4>; PARTICLES] = [
    Particle { position: [-8.5, -4.0], weight: 1.0, value: [0.9459594689067654, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [-8.5, -3.0000000000000004], weight: 1.0, value: [0.9459594689067654, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [-8.5, -2.0], weight: 1.0, value: [0.9459594689067654, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [-8.5, -1.0], weight: 1.0, value: [0.9459594689067654, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [-8.5, 0.0], weight: 1.0, value: [0.9459594689067654, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [-8.5, 1.0000000000000004], weight: 1.0, value: [0.9459594689067654, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [-8.5, 2.0], weight: 1.0, value: [0.9459594689067654, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [-8.5, 3.0000000000000004], weight: 1.0, value: [0.9459594689067654, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [-8.5, 4.0], weight: 1.0, value: [0.9459594689067654, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [-7.5, -4.0], weight: 1.0, value: [0.846481724890614, 0.6732050807568878, 0.0, 0.0] },
    Particle { position: [-7.5, -3.0000000000000004], weight: 1.0, value: [0.846481724890614, 0.6732050807568878, 0.0, 0.0] },
    Particle { position: [-7.5, -2.0], weight: 1.0, value: [0.846481724890614, 0.6732050807568878, 0.0, 0.0] },
    Particle { position: [-7.5, -1.0], weight: 1.0, value: [0.846481724890614, 0.6732050807568878, 0.0, 0.0] },
    Particle { position: [-7.5, 0.0], weight: 1.0, value: [0.846481724890614, 0.6732050807568878, 0.0, 0.0] },
    Particle { position: [-7.5, 1.0000000000000004], weight: 1.0, value: [0.846481724890614, 0.6732050807568878, 0.0, 0.0] },
    Particle { position: [-7.5, 2.0], weight: 1.0, value: [0.846481724890614, 0.6732050807568878, 0.0, 0.0] },
    Particle { position: [-7.5, 3.0000000000000004], weight: 1.0, value: [0.846481724890614, 0.6732050807568878, 0.0, 0.0] },
    Particle { position: [-7.5, 4.0], weight: 1.0, value: [0.846481724890614, 0.6732050807568878, 0.0, 0.0] },
    Particle { position: [-6.5, -4.0], weight: 1.0, value: [0.7574651283969664, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [-6.5, -3.0000000000000004], weight: 1.0, value: [0.7574651283969664, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [-6.5, -2.0], weight: 1.0, value: [0.7574651283969664, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [-6.5, -1.0], weight: 1.0, value: [0.7574651283969664, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [-6.5, 0.0], weight: 1.0, value: [0.7574651283969664, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [-6.5, 1.0000000000000004], weight: 1.0, value: [0.7574651283969664, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [-6.5, 2.0], weight: 1.0, value: [0.7574651283969664, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [-6.5, 3.0000000000000004], weight: 1.0, value: [0.7574651283969664, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [-6.5, 4.0], weight: 1.0, value: [0.7574651283969664, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [-5.5, -4.0], weight: 1.0, value: [0.6778095780054503, 0.5684040286651337, 0.0, 0.0] },
    Particle { position: [-5.5, -3.0000000000000004], weight: 1.0, value: [0.6778095780054503, 0.5684040286651337, 0.0, 0.0] },
    Particle { position: [-5.5, -2.0], weight: 1.0, value: [0.6778095780054503, 0.5684040286651337, 0.0, 0.0] },
    Particle { position: [-5.5, -1.0], weight: 1.0, value: [0.6778095780054503, 0.5684040286651337, 0.0, 0.0] },
    Particle { position: [-5.5, 0.0], weight: 1.0, value: [0.6778095780054503, 0.5684040286651337, 0.0, 0.0] },
    Particle { position: [-5.5, 1.0000000000000004], weight: 1.0, value: [0.6778095780054503, 0.5684040286651337, 0.0, 0.0] },
    Particle { position: [-5.5, 2.0], weight: 1.0, value: [0.6778095780054503, 0.5684040286651337, 0.0, 0.0] },
    Particle { position: [-5.5, 3.0000000000000004], weight: 1.0, value: [0.6778095780054503, 0.5684040286651337, 0.0, 0.0] },
    Particle { position: [-5.5, 4.0], weight: 1.0, value: [0.6778095780054503, 0.5684040286651337, 0.0, 0.0] },
    Particle { position: [-4.5, -4.0], weight: 1.0, value: [0.6065306597126334, 0.5, 0.0, 0.0] },
    Particle { position: [-4.5, -3.0000000000000004], weight: 1.0, value: [0.6065306597126334, 0.5, 0.0, 0.0] },
    Particle { position: [-4.5, -2.0], weight: 1.0, value: [0.6065306597126334, 0.5, 0.0, 0.0] },
    Particle { position: [-4.5, -1.0], weight: 1.0, value: [0.6065306597126334, 0.5, 0.0, 0.0] },
    Particle { position: [-4.5, 0.0], weight: 1.0, value: [0.6065306597126334, 0.5, 0.0, 0.0] },
    Particle { position: [-4.5, 1.0000000000000004], weight: 1.0, value: [0.6065306597126334, 0.5, 0.0, 0.0] },
    Particle { position: [-4.5, 2.0], weight: 1.0, value: [0.6065306597126334, 0.5, 0.0, 0.0] },
    Particle { position: [-4.5, 3.0000000000000004], weight: 1.0, value: [0.6065306597126334, 0.5, 0.0, 0.0] },
    Particle { position: [-4.5, 4.0], weight: 1.0, value: [0.6065306597126334, 0.5, 0.0, 0.0] },
    Particle { position: [-3.4999999999999996, -4.0], weight: 1.0, value: [0.5427474811642219, 0.43159597133486627, 0.0, 0.0] },
    Particle { position: [-3.4999999999999996, -3.0000000000000004], weight: 1.0, value: [0.5427474811642219, 0.43159597133486627, 0.0, 0.0] },
    Particle { position: [-3.4999999999999996, -2.0], weight: 1.0, value: [0.5427474811642219, 0.43159597133486627, 0.0, 0.0] },
    Particle { position: [-3.4999999999999996, -1.0], weight: 1.0, value: [0.5427474811642219, 0.43159597133486627, 0.0, 0.0] },
    Particle { position: [-3.4999999999999996, 0.0], weight: 1.0, value: [0.5427474811642219, 0.43159597133486627, 0.0, 0.0] },
    Particle { position: [-3.4999999999999996, 1.0000000000000004], weight: 1.0, value: [0.5427474811642219, 0.43159597133486627, 0.0, 0.0] },
    Particle { position: [-3.4999999999999996, 2.0], weight: 1.0, value: [0.5427474811642219, 0.43159597133486627, 0.0, 0.0] },
    Particle { position: [-3.4999999999999996, 3.0000000000000004], weight: 1.0, value: [0.5427474811642219, 0.43159597133486627, 0.0, 0.0] },
    Particle { position: [-3.4999999999999996, 4.0], weight: 1.0, value: [0.5427474811642219, 0.43159597133486627, 0.0, 0.0] },
    Particle { position: [-2.5, -4.0], weight: 1.0, value: [0.4856717852477124, 0.37144247806269215, 0.0, 0.0] },
    Particle { position: [-2.5, -3.0000000000000004], weight: 1.0, value: [0.4856717852477124, 0.37144247806269215, 0.0, 0.0] },
    Particle { position: [-2.5, -2.0], weight: 1.0, value: [0.4856717852477124, 0.37144247806269215, 0.0, 0.0] },
    Particle { position: [-2.5, -1.0], weight: 1.0, value: [0.4856717852477124, 0.37144247806269215, 0.0, 0.0] },
    Particle { position: [-2.5, 0.0], weight: 1.0, value: [0.4856717852477124, 0.37144247806269215, 0.0, 0.0] },
    Particle { position: [-2.5, 1.0000000000000004], weight: 1.0, value: [0.4856717852477124, 0.37144247806269215, 0.0, 0.0] },
    Particle { position: [-2.5, 2.0], weight: 1.0, value: [0.4856717852477124, 0.37144247806269215, 0.0, 0.0] },
    Particle { position: [-2.5, 3.0000000000000004], weight: 1.0, value: [0.4856717852477124, 0.37144247806269215, 0.0, 0.0] },
    Particle { position: [-2.5, 4.0], weight: 1.0, value: [0.4856717852477124, 0.37144247806269215, 0.0, 0.0] },
    Particle { position: [-1.4999999999999996, -4.0], weight: 1.0, value: [0.4345982085070782, 0.3267949192431122, 0.0, 0.0] },
    Particle { position: [-1.4999999999999996, -3.0000000000000004], weight: 1.0, value: [0.4345982085070782, 0.3267949192431122, 0.0, 0.0] },
    Particle { position: [-1.4999999999999996, -2.0], weight: 1.0, value: [0.4345982085070782, 0.3267949192431122, 0.0, 0.0] },
    Particle { position: [-1.4999999999999996, -1.0], weight: 1.0, value: [0.4345982085070782, 0.3267949192431122, 0.0, 0.0] },
    Particle { position: [-1.4999999999999996, 0.0], weight: 1.0, value: [0.4345982085070782, 0.3267949192431122, 0.0, 0.0] },
    Particle { position: [-1.4999999999999996, 1.0000000000000004], weight: 1.0, value: [0.4345982085070782, 0.3267949192431122, 0.0, 0.0] },
    Particle { position: [-1.4999999999999996, 2.0], weight: 1.0, value: [0.4345982085070782, 0.3267949192431122, 0.0, 0.0] },
    Particle { position: [-1.4999999999999996, 3.0000000000000004], weight: 1.0, value: [0.4345982085070782, 0.3267949192431122, 0.0, 0.0] },
    Particle { position: [-1.4999999999999996, 4.0], weight: 1.0, value: [0.4345982085070782, 0.3267949192431122, 0.0, 0.0] },
    Particle { position: [-0.5000000000000002, -4.0], weight: 1.0, value: [0.3888955639892229, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [-0.5000000000000002, -3.0000000000000004], weight: 1.0, value: [0.3888955639892229, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [-0.5000000000000002, -2.0], weight: 1.0, value: [0.3888955639892229, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [-0.5000000000000002, -1.0], weight: 1.0, value: [0.3888955639892229, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [-0.5000000000000002, 0.0], weight: 1.0, value: [0.3888955639892229, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [-0.5000000000000002, 1.0000000000000004], weight: 1.0, value: [0.3888955639892229, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [-0.5000000000000002, 2.0], weight: 1.0, value: [0.3888955639892229, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [-0.5000000000000002, 3.0000000000000004], weight: 1.0, value: [0.3888955639892229, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [-0.5000000000000002, 4.0], weight: 1.0, value: [0.3888955639892229, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [0.5000000000000002, -4.0], weight: 1.0, value: [0.34799904079225524, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [0.5000000000000002, -3.0000000000000004], weight: 1.0, value: [0.34799904079225524, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [0.5000000000000002, -2.0], weight: 1.0, value: [0.34799904079225524, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [0.5000000000000002, -1.0], weight: 1.0, value: [0.34799904079225524, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [0.5000000000000002, 0.0], weight: 1.0, value: [0.34799904079225524, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [0.5000000000000002, 1.0000000000000004], weight: 1.0, value: [0.34799904079225524, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [0.5000000000000002, 2.0], weight: 1.0, value: [0.34799904079225524, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [0.5000000000000002, 3.0000000000000004], weight: 1.0, value: [0.34799904079225524, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [0.5000000000000002, 4.0], weight: 1.0, value: [0.34799904079225524, 0.3030384493975584, 0.0, 0.0] },
    Particle { position: [1.5000000000000007, -4.0], weight: 1.0, value: [0.3114032239145977, 0.32679491924311227, 0.0, 0.0] },
    Particle { position: [1.5000000000000007, -3.0000000000000004], weight: 1.0, value: [0.3114032239145977, 0.32679491924311227, 0.0, 0.0] },
    Particle { position: [1.5000000000000007, -2.0], weight: 1.0, value: [0.3114032239145977, 0.32679491924311227, 0.0, 0.0] },
    Particle { position: [1.5000000000000007, -1.0], weight: 1.0, value: [0.3114032239145977, 0.32679491924311227, 0.0, 0.0] },
    Particle { position: [1.5000000000000007, 0.0], weight: 1.0, value: [0.3114032239145977, 0.32679491924311227, 0.0, 0.0] },
    Particle { position: [1.5000000000000007, 1.0000000000000004], weight: 1.0, value: [0.3114032239145977, 0.32679491924311227, 0.0, 0.0] },
    Particle { position: [1.5000000000000007, 2.0], weight: 1.0, value: [0.3114032239145977, 0.32679491924311227, 0.0, 0.0] },
    Particle { position: [1.5000000000000007, 3.0000000000000004], weight: 1.0, value: [0.3114032239145977, 0.32679491924311227, 0.0, 0.0] },
    Particle { position: [1.5000000000000007, 4.0], weight: 1.0, value: [0.3114032239145977, 0.32679491924311227, 0.0, 0.0] },
    Particle { position: [2.499999999999999, -4.0], weight: 1.0, value: [0.2786558481415308, 0.3714424780626921, 0.0, 0.0] },
    Particle { position: [2.499999999999999, -3.0000000000000004], weight: 1.0, value: [0.2786558481415308, 0.3714424780626921, 0.0, 0.0] },
    Particle { position: [2.499999999999999, -2.0], weight: 1.0, value: [0.2786558481415308, 0.3714424780626921, 0.0, 0.0] },
    Particle { position: [2.499999999999999, -1.0], weight: 1.0, value: [0.2786558481415308, 0.3714424780626921, 0.0, 0.0] },
    Particle { position: [2.499999999999999, 0.0], weight: 1.0, value: [0.2786558481415308, 0.3714424780626921, 0.0, 0.0] },
    Particle { position: [2.499999999999999, 1.0000000000000004], weight: 1.0, value: [0.2786558481415308, 0.3714424780626921, 0.0, 0.0] },
    Particle { position: [2.499999999999999, 2.0], weight: 1.0, value: [0.2786558481415308, 0.3714424780626921, 0.0, 0.0] },
    Particle { position: [2.499999999999999, 3.0000000000000004], weight: 1.0, value: [0.2786558481415308, 0.3714424780626921, 0.0, 0.0] },
    Particle { position: [2.499999999999999, 4.0], weight: 1.0, value: [0.2786558481415308, 0.3714424780626921, 0.0, 0.0] },
    Particle { position: [3.4999999999999996, -4.0], weight: 1.0, value: [0.24935220877729622, 0.4315959713348661, 0.0, 0.0] },
    Particle { position: [3.4999999999999996, -3.0000000000000004], weight: 1.0, value: [0.24935220877729622, 0.4315959713348661, 0.0, 0.0] },
    Particle { position: [3.4999999999999996, -2.0], weight: 1.0, value: [0.24935220877729622, 0.4315959713348661, 0.0, 0.0] },
    Particle { position: [3.4999999999999996, -1.0], weight: 1.0, value: [0.24935220877729622, 0.4315959713348661, 0.0, 0.0] },
    Particle { position: [3.4999999999999996, 0.0], weight: 1.0, value: [0.24935220877729622, 0.4315959713348661, 0.0, 0.0] },
    Particle { position: [3.4999999999999996, 1.0000000000000004], weight: 1.0, value: [0.24935220877729622, 0.4315959713348661, 0.0, 0.0] },
    Particle { position: [3.4999999999999996, 2.0], weight: 1.0, value: [0.24935220877729622, 0.4315959713348661, 0.0, 0.0] },
    Particle { position: [3.4999999999999996, 3.0000000000000004], weight: 1.0, value: [0.24935220877729622, 0.4315959713348661, 0.0, 0.0] },
    Particle { position: [3.4999999999999996, 4.0], weight: 1.0, value: [0.24935220877729622, 0.4315959713348661, 0.0, 0.0] },
    Particle { position: [4.5, -4.0], weight: 1.0, value: [0.22313016014842982, 0.49999999999999994, 0.0, 0.0] },
    Particle { position: [4.5, -3.0000000000000004], weight: 1.0, value: [0.22313016014842982, 0.49999999999999994, 0.0, 0.0] },
    Particle { position: [4.5, -2.0], weight: 1.0, value: [0.22313016014842982, 0.49999999999999994, 0.0, 0.0] },
    Particle { position: [4.5, -1.0], weight: 1.0, value: [0.22313016014842982, 0.49999999999999994, 0.0, 0.0] },
    Particle { position: [4.5, 0.0], weight: 1.0, value: [0.22313016014842982, 0.49999999999999994, 0.0, 0.0] },
    Particle { position: [4.5, 1.0000000000000004], weight: 1.0, value: [0.22313016014842982, 0.49999999999999994, 0.0, 0.0] },
    Particle { position: [4.5, 2.0], weight: 1.0, value: [0.22313016014842982, 0.49999999999999994, 0.0, 0.0] },
    Particle { position: [4.5, 3.0000000000000004], weight: 1.0, value: [0.22313016014842982, 0.49999999999999994, 0.0, 0.0] },
    Particle { position: [4.5, 4.0], weight: 1.0, value: [0.22313016014842982, 0.49999999999999994, 0.0, 0.0] },
    Particle { position: [5.5, -4.0], weight: 1.0, value: [0.19966564006790186, 0.5684040286651338, 0.0, 0.0] },
    Particle { position: [5.5, -3.0000000000000004], weight: 1.0, value: [0.19966564006790186, 0.5684040286651338, 0.0, 0.0] },
    Particle { position: [5.5, -2.0], weight: 1.0, value: [0.19966564006790186, 0.5684040286651338, 0.0, 0.0] },
    Particle { position: [5.5, -1.0], weight: 1.0, value: [0.19966564006790186, 0.5684040286651338, 0.0, 0.0] },
    Particle { position: [5.5, 0.0], weight: 1.0, value: [0.19966564006790186, 0.5684040286651338, 0.0, 0.0] },
    Particle { position: [5.5, 1.0000000000000004], weight: 1.0, value: [0.19966564006790186, 0.5684040286651338, 0.0, 0.0] },
    Particle { position: [5.5, 2.0], weight: 1.0, value: [0.19966564006790186, 0.5684040286651338, 0.0, 0.0] },
    Particle { position: [5.5, 3.0000000000000004], weight: 1.0, value: [0.19966564006790186, 0.5684040286651338, 0.0, 0.0] },
    Particle { position: [5.5, 4.0], weight: 1.0, value: [0.19966564006790186, 0.5684040286651338, 0.0, 0.0] },
    Particle { position: [6.500000000000001, -4.0], weight: 1.0, value: [0.17866866494966516, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [6.500000000000001, -3.0000000000000004], weight: 1.0, value: [0.17866866494966516, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [6.500000000000001, -2.0], weight: 1.0, value: [0.17866866494966516, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [6.500000000000001, -1.0], weight: 1.0, value: [0.17866866494966516, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [6.500000000000001, 0.0], weight: 1.0, value: [0.17866866494966516, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [6.500000000000001, 1.0000000000000004], weight: 1.0, value: [0.17866866494966516, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [6.500000000000001, 2.0], weight: 1.0, value: [0.17866866494966516, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [6.500000000000001, 3.0000000000000004], weight: 1.0, value: [0.17866866494966516, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [6.500000000000001, 4.0], weight: 1.0, value: [0.17866866494966516, 0.6285575219373079, 0.0, 0.0] },
    Particle { position: [7.499999999999999, -4.0], weight: 1.0, value: [0.1598797460796939, 0.6732050807568877, 0.0, 0.0] },
    Particle { position: [7.499999999999999, -3.0000000000000004], weight: 1.0, value: [0.1598797460796939, 0.6732050807568877, 0.0, 0.0] },
    Particle { position: [7.499999999999999, -2.0], weight: 1.0, value: [0.1598797460796939, 0.6732050807568877, 0.0, 0.0] },
    Particle { position: [7.499999999999999, -1.0], weight: 1.0, value: [0.1598797460796939, 0.6732050807568877, 0.0, 0.0] },
    Particle { position: [7.499999999999999, 0.0], weight: 1.0, value: [0.1598797460796939, 0.6732050807568877, 0.0, 0.0] },
    Particle { position: [7.499999999999999, 1.0000000000000004], weight: 1.0, value: [0.1598797460796939, 0.6732050807568877, 0.0, 0.0] },
    Particle { position: [7.499999999999999, 2.0], weight: 1.0, value: [0.1598797460796939, 0.6732050807568877, 0.0, 0.0] },
    Particle { position: [7.499999999999999, 3.0000000000000004], weight: 1.0, value: [0.1598797460796939, 0.6732050807568877, 0.0, 0.0] },
    Particle { position: [7.499999999999999, 4.0], weight: 1.0, value: [0.1598797460796939, 0.6732050807568877, 0.0, 0.0] },
    Particle { position: [8.5, -4.0], weight: 1.0, value: [0.1430666827544082, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [8.5, -3.0000000000000004], weight: 1.0, value: [0.1430666827544082, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [8.5, -2.0], weight: 1.0, value: [0.1430666827544082, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [8.5, -1.0], weight: 1.0, value: [0.1430666827544082, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [8.5, 0.0], weight: 1.0, value: [0.1430666827544082, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [8.5, 1.0000000000000004], weight: 1.0, value: [0.1430666827544082, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [8.5, 2.0], weight: 1.0, value: [0.1430666827544082, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [8.5, 3.0000000000000004], weight: 1.0, value: [0.1430666827544082, 0.6969615506024416, 0.0, 0.0] },
    Particle { position: [8.5, 4.0], weight: 1.0, value: [0.1430666827544082, 0.6969615506024416, 0.0, 0.0] },
];

/// The memory of the particles.
pub type Storage<S> = DirectStorage<S, 2, 4, PARTICLES, CELLS>;

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
    Stepper<S, DiffusionDynamics<S, CutOff, Problem<'m, S>, Motion, 2, 4>, HalfLoop, &'m mut Storage<S>, 2>;

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
        epsilon: S::from_f64(1.2),
        problem: Problem {
            named: PROBLEM.rounded(lists)?,
        },
        field: Motion,
        form: Form::Direct,
        mean: Mean::Arithmetic,
        courant: S::from_f64(0.5),
    };
    let method = DiffusionMethod {
        scheme: Scheme::Stabilised(9),
        longest: S::from_f64(0.01257788237343632),
    };
    Ok(Stepper::new(dynamics, method, HalfLoop, cloud)?.until(S::from_f64(0.8049844718999245)))
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
