//! Taylor and Green's vortices in the plane: they turn against their neighbours and decay by viscosity.
//!
//! G. I. Taylor and A. E. Green, Proceedings of the Royal Society of London A 158 (1937) 499. In a
//! periodic rectangle, with x and y from its lower corner, `k = 2 pi / length` along each direction,
//! `a = k_x/k_y` and `F = e^(-nu (k_x^2 + k_y^2) t)`:
//!
//! - `u = U sin(k_x x) cos(k_y y) F`, `v = -a U cos(k_x x) sin(k_y y) F`
//! - `p = p_0 + (gamma-1) rho q + rho U^2/4 (cos(2 k_x x) + a^2 cos(2 k_y y)) F^2`
//! - `q = U^2/8 (1 + a^2) (1 - F^2)`, the kinetic energy per mass that has become heat
//!
//! The density is the same everywhere. Exact for an incompressible gas; of a gas it is the limit of small
//! Mach numbers, with errors of their square.

#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use super::flow::{Flow, FlowError, FlowState, check, gamma_number};

/// Vortices that fill a periodic rectangle, a pair along each direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TaylorGreenProblem {
    /// Ratio of the specific heats, > 1.
    pub gamma: f64,
    /// Everywhere, > 0.
    pub density: f64,
    /// U, > 0.
    pub speed: f64,
    /// `p_0`, the mean at the start; above what the vortices take from it.
    pub pressure: f64,
    /// Kinematic shear viscosity nu, >= 0.
    pub viscosity: f64,
    /// The lower corner of the rectangle.
    pub corner: [f64; 2],
    /// Its sides, > 0.
    pub lengths: [f64; 2],
}

/// The flow of [`TaylorGreenProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TaylorGreen {
    problem: TaylorGreenProblem,
    waves: [f64; 2],
}

impl TaylorGreenProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<TaylorGreen, FlowError> {
        let [width, height] = self.lengths;
        let flow = TaylorGreen {
            problem: self,
            waves: self.lengths.map(|length| 2.0 * PI / length),
        };
        let taken = 0.25 * self.density * self.speed * self.speed * (1.0 + flow.ratio_squared());
        let need = "above density speed^2/4 (1 + (height/width)^2), which the vortices take";
        check(&[
            gamma_number(self.gamma),
            ("density", self.density, "> 0", self.density > 0.0),
            ("speed", self.speed, "> 0", self.speed > 0.0),
            ("viscosity", self.viscosity, ">= 0", self.viscosity >= 0.0),
            ("width", width, "> 0", width > 0.0),
            ("height", height, "> 0", height > 0.0),
            ("pressure", self.pressure, need, self.pressure > taken),
        ])?;
        Ok(flow)
    }
}

impl TaylorGreen {
    /// The rate at which the kinetic energy falls, `2 nu (k_x^2 + k_y^2)`.
    pub fn decay_rate(&self) -> f64 {
        let [x, y] = self.waves;
        2.0 * self.problem.viscosity * (x * x + y * y)
    }

    /// `a^2`.
    fn ratio_squared(&self) -> f64 {
        let [x, y] = self.waves;
        (x / y) * (x / y)
    }
}

impl Flow for TaylorGreen {
    /// Depends on x and y only.
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let TaylorGreenProblem {
            gamma,
            density,
            speed,
            pressure,
            corner,
            ..
        } = self.problem;
        let [x, y] = [0, 1].map(|i| self.waves[i] * (position[i] - corner[i]));
        let left = libm::exp(-self.decay_rate() * time);
        let (fast, squares) = (speed * left.sqrt(), speed * speed);
        let ratio_squared = self.ratio_squared();
        let heat = 0.125 * squares * (1.0 + ratio_squared) * (1.0 - left);
        let swing = libm::cos(2.0 * x) + ratio_squared * libm::cos(2.0 * y);
        let u = fast * libm::sin(x) * libm::cos(y);
        let v = -fast * ratio_squared.sqrt() * libm::cos(x) * libm::sin(y);
        let rise = density * ((gamma - 1.0) * heat + 0.25 * squares * swing * left);
        FlowState::ideal(density, [u, v, 0.0], pressure + rise, gamma)
    }
}
