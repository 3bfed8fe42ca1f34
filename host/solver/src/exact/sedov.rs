//! The blast wave of an energy set free in a point, a line or a plane of a uniform cold gas.
//!
//! L. I. Sedov, Similarity and Dimensional Methods in Mechanics, 1959, chapter IV section 11;
//! J. R. Kamm and F. X. Timmes, Los Alamos report LA-UR-07-2849 (2007). With `D` the
//! dimension, the shock is at `R = (E t^2 / (alpha rho_0))^(1/(D+2))`, its speed is
//! `R' = 2 R / ((D+2) t)`, and all fields behind it are functions of `r/R`.
//!
//! `E` is the energy of all of space: of both sides in 1D, per length in 2D.
//! The solution neglects the pressure outside: relative error of order `p / (rho_0 R'^2)`.

mod profile;
#[cfg(test)]
mod tests;

use super::flow::{
    Flow, FlowError, FlowState, check, dimension_number, gamma_number, radial, radius,
};
use profile::Profile;

/// A uniform gas at rest with an energy in the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SedovProblem {
    /// 1 planar, 2 cylindrical, 3 spherical.
    pub dimension: usize,
    /// Ratio of the specific heats, > 1 and < 7. From 7 on, in 3D, the centre is empty.
    pub gamma: f64,
    /// Outside, > 0.
    pub density: f64,
    /// Of all of space, > 0: mass velocity^2 in 3D, per length in 2D, per area in 1D.
    pub energy: f64,
    /// Outside, >= 0.
    pub pressure: f64,
}

/// The flow of [`SedovProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sedov {
    problem: SedovProblem,
    profile: Profile,
    alpha: f64,
}

impl SedovProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<Sedov, FlowError> {
        check(&[
            dimension_number(self.dimension),
            gamma_number(self.gamma),
            ("gamma", self.gamma, "< 7", self.gamma < 7.0),
            ("density", self.density, "> 0", self.density > 0.0),
            ("energy", self.energy, "> 0", self.energy > 0.0),
            ("pressure", self.pressure, ">= 0", self.pressure >= 0.0),
        ])?;
        let profile = Profile::new(self.dimension, self.gamma);
        Ok(Sedov {
            problem: self,
            alpha: profile.energy(),
            profile,
        })
    }
}

impl Sedov {
    /// `E t^2 / (rho_0 R^(D+2))`, to some 1e-12.
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// `(E t^2 / (alpha rho_0))^(1/(D+2))`.
    pub fn shock_radius(&self, time: f64) -> f64 {
        let SedovProblem {
            dimension,
            density,
            energy,
            ..
        } = self.problem;
        let power = 1.0 / (dimension as f64 + 2.0);
        libm::pow(energy * time * time / (self.alpha * density), power)
    }

    /// The time at which the shock is at a radius, >= 0: the inverse of `shock_radius`.
    pub fn shock_time(&self, radius: f64) -> f64 {
        let SedovProblem {
            dimension,
            density,
            energy,
            ..
        } = self.problem;
        let power = dimension as f64 + 2.0;
        (libm::pow(radius, power) * self.alpha * density / energy).sqrt()
    }
}

impl Flow for Sedov {
    /// The gas outside when t = 0, the origin included. Where the density is below some
    /// 1e-200 of that outside, density and energy stay what they are there: in the centre
    /// they are 0 and infinite.
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let SedovProblem {
            dimension,
            gamma,
            density,
            pressure,
            ..
        } = self.problem;
        let shock = self.shock_radius(time);
        let r = radius(position, dimension);
        if !(r < shock) {
            return FlowState::ideal(density, [0.0; 3], pressure, gamma);
        }
        let speed = 2.0 * shock / ((dimension as f64 + 2.0) * time);
        let inside = self.profile.at(r / shock);
        FlowState {
            density: density * inside.density,
            velocity: radial(position, dimension, speed * inside.velocity),
            pressure: density * speed * speed * inside.pressure,
            energy: speed * speed * inside.energy,
        }
    }
}
