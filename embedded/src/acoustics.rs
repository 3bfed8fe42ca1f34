//! Made by `motes export acoustics1d -n 64`, not by hand.
//!
//! Before a device runs it in a scalar, `motes run` tells whether the scalar can hold it.

use motes_core::cutoff::Named as CutOff;
use motes_core::domain::Side;
use motes_core::equation::linear::systems::{Acoustics, Units};
use motes_core::equation::linear::{Line, Particle, Wave};
use motes_core::integrator::{RK4, RungeKutta};
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = "acoustics1d";

/// Number of particles.
pub const PARTICLES: usize = 64;

/// Cells they can take, and one.
pub const CELLS: usize = 385;

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::QuinticSpline;

/// The time integrator.
pub const METHOD: RungeKutta = RK4;

/// The equations: from the scenario's numbers and units to the solver's.
pub fn system<S: Scalar>() -> Acoustics<S> {
    let units = Units {
        length: 0.015625,
        velocity: 1.0,
    };
    Acoustics::new(1.0, 1.0, units)
}

/// What the particles follow.
pub fn motion<S: Scalar>() -> Wave<S> {
    Wave {
        amplitude: S::from_f64(0.2),
        length: S::from_f64(64.0),
        phase: S::from_f64(0.5),
    }
}

/// The line, in solver units.
#[rustfmt::skip]
pub const LINE: Line<'static, 2> = Line {
    half_length: 32.0,
    sides: [Side::Periodic, Side::Periodic],
    cloud: &[
        Particle { position: [-31.5], weight: 1.0, value: [1.0502914261008667, 0.0] },
        Particle { position: [-30.5], weight: 1.0, value: [1.1580417991170497, 0.0] },
        Particle { position: [-29.5], weight: 1.0, value: [1.2750433523854292, 0.0] },
        Particle { position: [-28.5], weight: 1.0, value: [1.4005847855790434, 0.0] },
        Particle { position: [-27.5], weight: 1.0, value: [1.5335036633182917, 0.0] },
        Particle { position: [-26.5], weight: 1.0, value: [1.6721374934282827, 0.0] },
        Particle { position: [-25.5], weight: 1.0, value: [1.8142992490585785, 0.0] },
        Particle { position: [-24.5], weight: 1.0, value: [1.9572862643444577, 0.0] },
        Particle { position: [-23.5], weight: 1.0, value: [2.097929960238163, 0.0] },
        Particle { position: [-22.5], weight: 1.0, value: [2.2326908818021876, 0.0] },
        Particle { position: [-21.5], weight: 1.0, value: [2.3577991255496302, 0.0] },
        Particle { position: [-20.5], weight: 1.0, value: [2.46943478661352, 0.0] },
        Particle { position: [-19.5], weight: 1.0, value: [2.5639372497513415, 0.0] },
        Particle { position: [-18.5], weight: 1.0, value: [2.6380269048338727, 0.0] },
        Particle { position: [-17.5], weight: 1.0, value: [2.689019179839687, 0.0] },
        Particle { position: [-16.5], weight: 1.0, value: [2.715009510170984, 0.0] },
        Particle { position: [-15.5], weight: 1.0, value: [2.715009510170984, 0.0] },
        Particle { position: [-14.5], weight: 1.0, value: [2.689019179839687, 0.0] },
        Particle { position: [-13.5], weight: 1.0, value: [2.6380269048338727, 0.0] },
        Particle { position: [-12.5], weight: 1.0, value: [2.5639372497513415, 0.0] },
        Particle { position: [-11.5], weight: 1.0, value: [2.4694347866135202, 0.0] },
        Particle { position: [-10.5], weight: 1.0, value: [2.3577991255496302, 0.0] },
        Particle { position: [-9.5], weight: 1.0, value: [2.232690881802188, 0.0] },
        Particle { position: [-8.5], weight: 1.0, value: [2.0979299602381625, 0.0] },
        Particle { position: [-7.5], weight: 1.0, value: [1.9572862643444582, 0.0] },
        Particle { position: [-6.5], weight: 1.0, value: [1.8142992490585788, 0.0] },
        Particle { position: [-5.5], weight: 1.0, value: [1.6721374934282829, 0.0] },
        Particle { position: [-4.5], weight: 1.0, value: [1.5335036633182917, 0.0] },
        Particle { position: [-3.5], weight: 1.0, value: [1.4005847855790439, 0.0] },
        Particle { position: [-2.5], weight: 1.0, value: [1.2750433523854294, 0.0] },
        Particle { position: [-1.5], weight: 1.0, value: [1.15804179911705, 0.0] },
        Particle { position: [-0.5], weight: 1.0, value: [1.0502914261008667, 0.0] },
        Particle { position: [0.5], weight: 1.0, value: [0.95211669366133, 0.0] },
        Particle { position: [1.5], weight: 1.0, value: [0.8635266885551551, 0.0] },
        Particle { position: [2.5], weight: 1.0, value: [0.7842870582628729, 0.0] },
        Particle { position: [3.5], weight: 1.0, value: [0.7139874788705278, 0.0] },
        Particle { position: [4.5], weight: 1.0, value: [0.6521014744993419, 0.0] },
        Particle { position: [5.5], weight: 1.0, value: [0.5980369460825619, 0.0] },
        Particle { position: [6.5], weight: 1.0, value: [0.5511769905206597, 0.0] },
        Particle { position: [7.5], weight: 1.0, value: [0.5109114687089085, 0.0] },
        Particle { position: [8.5], weight: 1.0, value: [0.4766603361184076, 0.0] },
        Particle { position: [9.5], weight: 1.0, value: [0.44789003625652735, 0.0] },
        Particle { position: [10.5], weight: 1.0, value: [0.42412434085829454, 0.0] },
        Particle { position: [11.5], weight: 1.0, value: [0.40495096506328826, 0.0] },
        Particle { position: [12.5], weight: 1.0, value: [0.3900251459340447, 0.0] },
        Particle { position: [13.5], weight: 1.0, value: [0.3790711907325957, 0.0] },
        Particle { position: [14.5], weight: 1.0, value: [0.3718828067487483, 0.0] },
        Particle { position: [15.5], weight: 1.0, value: [0.3683228350596174, 0.0] },
        Particle { position: [16.5], weight: 1.0, value: [0.3683228350596174, 0.0] },
        Particle { position: [17.5], weight: 1.0, value: [0.3718828067487483, 0.0] },
        Particle { position: [18.5], weight: 1.0, value: [0.3790711907325957, 0.0] },
        Particle { position: [19.5], weight: 1.0, value: [0.39002514593404464, 0.0] },
        Particle { position: [20.5], weight: 1.0, value: [0.4049509650632882, 0.0] },
        Particle { position: [21.5], weight: 1.0, value: [0.4241243408582944, 0.0] },
        Particle { position: [22.5], weight: 1.0, value: [0.44789003625652724, 0.0] },
        Particle { position: [23.5], weight: 1.0, value: [0.4766603361184075, 0.0] },
        Particle { position: [24.5], weight: 1.0, value: [0.5109114687089084, 0.0] },
        Particle { position: [25.5], weight: 1.0, value: [0.5511769905206597, 0.0] },
        Particle { position: [26.5], weight: 1.0, value: [0.5980369460825617, 0.0] },
        Particle { position: [27.5], weight: 1.0, value: [0.6521014744993414, 0.0] },
        Particle { position: [28.5], weight: 1.0, value: [0.7139874788705278, 0.0] },
        Particle { position: [29.5], weight: 1.0, value: [0.7842870582628727, 0.0] },
        Particle { position: [30.5], weight: 1.0, value: [0.8635266885551544, 0.0] },
        Particle { position: [31.5], weight: 1.0, value: [0.9521166936613297, 0.0] },
    ],
    epsilon: 1.9798989873223327,
    courant: 0.5,
    step: None,
    end: 16.0,
};
