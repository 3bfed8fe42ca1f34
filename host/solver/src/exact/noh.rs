//! Noh's implosion: cold gas runs from all sides into a plane, an axis or a point, and a
//! shock of infinite strength runs outwards.
//!
//! W. F. Noh, Journal of Computational Physics 72 (1987), section 4.
//! With `D` the dimension, `v` the speed and `r_s = (gamma - 1)/2 v t`:
//!
//! - `r < r_s`: `rho = rho_0 ((gamma + 1)/(gamma - 1))^D`, `u = 0`, `e = v^2/2`
//! - `r > r_s`: `rho = rho_0 (1 + v t/r)^(D-1)`, `u = -v x/r`
//!
//! Differs from the paper: the inflowing gas may have a small pressure, which the solution
//! neglects: relative error of order `p / (rho_0 v^2)`.

use super::flow::{
    Flow, FlowError, FlowState, check, dimension_number, gamma_number, radial, radius,
};

#[cfg(test)]
mod tests;

/// Gas that runs to the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NohProblem {
    /// 1 planar, 2 cylindrical, 3 spherical.
    pub dimension: usize,
    /// Ratio of the specific heats, > 1.
    pub gamma: f64,
    /// At t = 0, > 0.
    pub density: f64,
    /// Towards the origin, > 0.
    pub speed: f64,
    /// Of the gas that the shock has not reached, >= 0.
    pub pressure: f64,
}

/// The flow of [`NohProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noh {
    problem: NohProblem,
}

impl NohProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<Noh, FlowError> {
        check(&[
            dimension_number(self.dimension),
            gamma_number(self.gamma),
            ("density", self.density, "> 0", self.density > 0.0),
            ("speed", self.speed, "> 0", self.speed > 0.0),
            ("pressure", self.pressure, ">= 0", self.pressure >= 0.0),
        ])?;
        Ok(Noh { problem: self })
    }
}

impl Noh {
    /// `(gamma - 1)/2 v t`.
    pub fn shock_radius(&self, time: f64) -> f64 {
        0.5 * (self.problem.gamma - 1.0) * self.problem.speed * time
    }
}

impl Flow for Noh {
    /// At rest in the origin when t = 0.
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let NohProblem {
            dimension,
            gamma,
            density,
            speed,
            pressure,
        } = self.problem;
        let r = radius(position, dimension);
        if r < self.shock_radius(time) {
            let compression = (gamma + 1.0) / (gamma - 1.0);
            let density = (0..dimension).fold(density, |density, _| density * compression);
            let energy = 0.5 * speed * speed;
            return FlowState {
                density,
                velocity: [0.0; 3],
                pressure: (gamma - 1.0) * density * energy,
                energy,
            };
        }
        // r = 0 comes here at t = 0 only.
        let growth = if r > 0.0 { 1.0 + speed * time / r } else { 1.0 };
        let density = (1..dimension).fold(density, |density, _| density * growth);
        let velocity = radial(position, dimension, -speed);
        FlowState::ideal(density, velocity, pressure, gamma)
    }
}
