//! The Gresho-Chan vortex: a triangular profile of rotation held together by its pressure,
//! in a gas of density 1, at rest or carried along by a uniform flow. It stays as it is.
//!
//! P. M. Gresho and S. T. Chan, International Journal for Numerical Methods in Fluids 11
//! (1990); for gases R. Liska and B. Wendroff, SIAM Journal on Scientific Computing 25 (2003),
//! section 4.6. With r the distance from the centre and `p_0` the pressure there:
//!
//! | r | speed | pressure |
//! |---|---|---|
//! | < 0.2 | 5 r | p_0 + 25/2 r^2 |
//! | < 0.4 | 2 - 5 r | p_0 + 4 + 25/2 r^2 - 20 r + 4 ln(5 r) |
//! | beyond | 0 | p_0 - 2 + 4 ln 2 |
//!
//! Units: the density and the highest speed are 1.

#[cfg(test)]
mod tests;

use super::flow::{Flow, FlowError, FlowState, check, gamma_number};
use super::moving_centre::MovingCentre;

/// A vortex in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GreshoProblem {
    /// Ratio of the specific heats, > 1; 1.4 in the paper.
    pub gamma: f64,
    /// In the centre, > 0; 5 in the paper.
    pub central_pressure: f64,
    /// Where it is and goes.
    pub centre: MovingCentre,
}

/// The flow of [`GreshoProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gresho {
    problem: GreshoProblem,
}

impl GreshoProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<Gresho, FlowError> {
        let p = self.central_pressure;
        check(&[
            gamma_number(self.gamma),
            ("central pressure", p, "> 0", p > 0.0),
        ])?;
        check(&self.centre.numbers())?;
        Ok(Gresho { problem: self })
    }

    /// The pressure in the centre for which the fastest gas, at r = 0.2, has a given Mach
    /// number: `1/(gamma Ma^2) - 1/2`, F. Miczek, F. K. Roepke and P. V. F. Edelmann, Astronomy
    /// and Astrophysics 576 (2015). Positive for `Ma < (2/gamma)^(1/2)`; 5 is Mach 0.360
    /// for gamma 1.4.
    pub fn central_pressure_of_mach(mach: f64, gamma: f64) -> f64 {
        1.0 / (gamma * mach * mach) - 0.5
    }
}

impl Flow for Gresho {
    /// Depends on x and y only.
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let GreshoProblem {
            gamma,
            central_pressure,
            centre,
        } = self.problem;
        let [x, y] = centre.towards(position, time);
        let r = (x * x + y * y).sqrt();
        // Angular velocity, and the pressure above that in the centre.
        let (spin, rise) = if r < 0.2 {
            (5.0, 12.5 * r * r)
        } else if r < 0.4 {
            let rise = 4.0 + 12.5 * r * r - 20.0 * r + 4.0 * libm::log(5.0 * r);
            (2.0 / r - 5.0, rise)
        } else {
            (0.0, 4.0 * std::f64::consts::LN_2 - 2.0)
        };
        let [u, v] = centre.velocity;
        FlowState::ideal(
            1.0,
            [u - spin * y, v + spin * x, 0.0],
            central_pressure + rise,
            gamma,
        )
    }
}
