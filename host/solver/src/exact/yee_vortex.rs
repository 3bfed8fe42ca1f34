//! An isentropic vortex, at rest or carried along by a uniform flow: smooth everywhere.
//!
//! H. C. Yee, M. Vinokur and M. J. Djomehri, Journal of Computational Physics 162 (2000),
//! section 4. With r the distance from the centre and `(x, y)` the vector from it:
//!
//! - `(u, v) = (U, V) + beta/(2 pi) e^((1-r^2)/2) (-y, x)`
//! - `T = p/rho = 1 - (gamma-1) beta^2 / (8 gamma pi^2) e^(1-r^2)`
//! - `rho = T^(1/(gamma-1))`, `p = T^(gamma/(gamma-1))`
//!
//! Units: the radius where it turns fastest, the density far off and `(p/rho)^(1/2)` far off
//! are 1. In a periodic box it is exact but for the tail beyond half the box, relative
//! size `beta e^((1-r^2)/2)`: 6e-6 beta for a box of 10, 2e-21 beta for one of 20.

#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use super::flow::{Flow, FlowError, FlowState, check, gamma_number};
use super::moving_centre::MovingCentre;

/// A vortex in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YeeVortexProblem {
    /// Ratio of the specific heats, > 1; 1.4 in the paper.
    pub gamma: f64,
    /// Beta, counterclockwise if > 0; 5 in the paper. Vacuum in the centre from
    /// `beta^2 = 8 gamma pi^2 / (e (gamma-1))` on, 10.08 for gamma = 1.4.
    pub strength: f64,
    /// Where it is and goes.
    pub centre: MovingCentre,
}

/// The flow of [`YeeVortexProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YeeVortex {
    problem: YeeVortexProblem,
}

impl YeeVortexProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<YeeVortex, FlowError> {
        let Self {
            gamma, strength, ..
        } = self;
        let need = "such that the temperature in the centre is > 0";
        let holds = self.cooling() * libm::exp(1.0) < 1.0;
        check(&[gamma_number(gamma), ("strength", strength, need, holds)])?;
        check(&self.centre.numbers())?;
        Ok(YeeVortex { problem: self })
    }

    /// `(gamma-1) beta^2 / (8 gamma pi^2)`.
    fn cooling(&self) -> f64 {
        (self.gamma - 1.0) * self.strength * self.strength / (8.0 * self.gamma * PI * PI)
    }
}

impl Flow for YeeVortex {
    /// Depends on x and y only.
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let YeeVortexProblem {
            gamma,
            strength,
            centre,
        } = self.problem;
        let [x, y] = centre.towards(position, time);
        let turn = libm::exp(0.5 * (1.0 - (x * x + y * y)));
        let spin = strength / (2.0 * PI) * turn;
        let [u, v] = centre.velocity;
        // ln T, which keeps the tail exact: T - 1 is far below the rounding of T there.
        let ln = libm::log1p(-self.problem.cooling() * turn * turn);
        let density = libm::exp(ln / (gamma - 1.0));
        let pressure = libm::exp(ln * (gamma / (gamma - 1.0)));
        FlowState::ideal(density, [u - spin * y, v + spin * x, 0.0], pressure, gamma)
    }
}
