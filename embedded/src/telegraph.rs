//! Made by `motes export telegraph -n 64`, not by hand.
//!
//! Before a device runs it in a scalar, `motes run` tells whether the scalar can hold it.

use motes_core::cutoff::Named as CutOff;
use motes_core::domain::Side;
use motes_core::equation::linear::systems::{Telegraph, Units};
use motes_core::equation::linear::{Line, Particle, Wave};
use motes_core::integrator::{RK4, RungeKutta};
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = "telegraph";

/// Number of particles.
pub const PARTICLES: usize = 64;

/// Cells they can take, and one.
pub const CELLS: usize = 385;

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::QuinticSpline;

/// The time integrator.
pub const METHOD: RungeKutta = RK4;

/// The equations: from the scenario's numbers and units to the solver's.
pub fn system<S: Scalar>() -> Telegraph<S> {
    let units = Units {
        length: 0.015625,
        velocity: 1.0,
    };
    let (capacitance, inductance) = (1.0, 1.0);
    let (conductance, resistance) = (0.25, 1.0);
    Telegraph::new([capacitance, inductance], [conductance, resistance], units)
}

/// What the particles follow.
pub fn motion<S: Scalar>() -> Wave<S> {
    Wave {
        amplitude: S::from_f64(0.1),
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
        Particle { position: [-31.5], weight: 1.0, value: [0.9987954562051724, 0.0] },
        Particle { position: [-30.5], weight: 1.0, value: [0.989176509964781, 0.0] },
        Particle { position: [-29.5], weight: 1.0, value: [0.970031253194544, 0.0] },
        Particle { position: [-28.5], weight: 1.0, value: [0.9415440651830208, 0.0] },
        Particle { position: [-27.5], weight: 1.0, value: [0.9039892931234433, 0.0] },
        Particle { position: [-26.5], weight: 1.0, value: [0.8577286100002721, 0.0] },
        Particle { position: [-25.5], weight: 1.0, value: [0.8032075314806449, 0.0] },
        Particle { position: [-24.5], weight: 1.0, value: [0.7409511253549592, 0.0] },
        Particle { position: [-23.5], weight: 1.0, value: [0.6715589548470184, 0.0] },
        Particle { position: [-22.5], weight: 1.0, value: [0.5956993044924335, 0.0] },
        Particle { position: [-21.5], weight: 1.0, value: [0.5141027441932217, 0.0] },
        Particle { position: [-20.5], weight: 1.0, value: [0.4275550934302822, 0.0] },
        Particle { position: [-19.5], weight: 1.0, value: [0.33688985339222005, 0.0] },
        Particle { position: [-18.5], weight: 1.0, value: [0.24298017990326398, 0.0] },
        Particle { position: [-17.5], weight: 1.0, value: [0.14673047445536175, 0.0] },
        Particle { position: [-16.5], weight: 1.0, value: [0.049067674327418126, 0.0] },
        Particle { position: [-15.5], weight: 1.0, value: [-0.04906767432741801, 0.0] },
        Particle { position: [-14.5], weight: 1.0, value: [-0.14673047445536164, 0.0] },
        Particle { position: [-13.5], weight: 1.0, value: [-0.24298017990326387, 0.0] },
        Particle { position: [-12.5], weight: 1.0, value: [-0.33688985339221994, 0.0] },
        Particle { position: [-11.5], weight: 1.0, value: [-0.42755509343028186, 0.0] },
        Particle { position: [-10.5], weight: 1.0, value: [-0.5141027441932217, 0.0] },
        Particle { position: [-9.5], weight: 1.0, value: [-0.5956993044924334, 0.0] },
        Particle { position: [-8.5], weight: 1.0, value: [-0.6715589548470184, 0.0] },
        Particle { position: [-7.5], weight: 1.0, value: [-0.7409511253549589, 0.0] },
        Particle { position: [-6.5], weight: 1.0, value: [-0.8032075314806448, 0.0] },
        Particle { position: [-5.5], weight: 1.0, value: [-0.857728610000272, 0.0] },
        Particle { position: [-4.5], weight: 1.0, value: [-0.9039892931234433, 0.0] },
        Particle { position: [-3.5], weight: 1.0, value: [-0.9415440651830207, 0.0] },
        Particle { position: [-2.5], weight: 1.0, value: [-0.970031253194544, 0.0] },
        Particle { position: [-1.5], weight: 1.0, value: [-0.989176509964781, 0.0] },
        Particle { position: [-0.5], weight: 1.0, value: [-0.9987954562051724, 0.0] },
        Particle { position: [0.5], weight: 1.0, value: [-0.9987954562051724, -0.0] },
        Particle { position: [1.5], weight: 1.0, value: [-0.989176509964781, -0.0] },
        Particle { position: [2.5], weight: 1.0, value: [-0.970031253194544, -0.0] },
        Particle { position: [3.5], weight: 1.0, value: [-0.9415440651830208, -0.0] },
        Particle { position: [4.5], weight: 1.0, value: [-0.9039892931234434, -0.0] },
        Particle { position: [5.5], weight: 1.0, value: [-0.8577286100002721, -0.0] },
        Particle { position: [6.5], weight: 1.0, value: [-0.8032075314806449, -0.0] },
        Particle { position: [7.5], weight: 1.0, value: [-0.7409511253549591, -0.0] },
        Particle { position: [8.5], weight: 1.0, value: [-0.6715589548470187, -0.0] },
        Particle { position: [9.5], weight: 1.0, value: [-0.5956993044924331, -0.0] },
        Particle { position: [10.5], weight: 1.0, value: [-0.5141027441932218, -0.0] },
        Particle { position: [11.5], weight: 1.0, value: [-0.4275550934302825, -0.0] },
        Particle { position: [12.5], weight: 1.0, value: [-0.33688985339221994, -0.0] },
        Particle { position: [13.5], weight: 1.0, value: [-0.24298017990326412, -0.0] },
        Particle { position: [14.5], weight: 1.0, value: [-0.1467304744553623, -0.0] },
        Particle { position: [15.5], weight: 1.0, value: [-0.04906767432741803, -0.0] },
        Particle { position: [16.5], weight: 1.0, value: [0.04906767432741766, -0.0] },
        Particle { position: [17.5], weight: 1.0, value: [0.14673047445536194, -0.0] },
        Particle { position: [18.5], weight: 1.0, value: [0.24298017990326376, -0.0] },
        Particle { position: [19.5], weight: 1.0, value: [0.3368898533922196, -0.0] },
        Particle { position: [20.5], weight: 1.0, value: [0.42755509343028214, -0.0] },
        Particle { position: [21.5], weight: 1.0, value: [0.5141027441932216, -0.0] },
        Particle { position: [22.5], weight: 1.0, value: [0.5956993044924328, -0.0] },
        Particle { position: [23.5], weight: 1.0, value: [0.6715589548470183, -0.0] },
        Particle { position: [24.5], weight: 1.0, value: [0.7409511253549589, -0.0] },
        Particle { position: [25.5], weight: 1.0, value: [0.803207531480645, -0.0] },
        Particle { position: [26.5], weight: 1.0, value: [0.857728610000272, -0.0] },
        Particle { position: [27.5], weight: 1.0, value: [0.9039892931234431, -0.0] },
        Particle { position: [28.5], weight: 1.0, value: [0.9415440651830208, -0.0] },
        Particle { position: [29.5], weight: 1.0, value: [0.970031253194544, -0.0] },
        Particle { position: [30.5], weight: 1.0, value: [0.9891765099647809, -0.0] },
        Particle { position: [31.5], weight: 1.0, value: [0.9987954562051724, -0.0] },
    ],
    epsilon: 1.9798989873223327,
    courant: 0.5,
    step: None,
    end: 57.6,
};
