//! Sound of small amplitude in a medium at rest: `p_t + rho c^2 div v = 0`,
//! `v_t + grad p / rho = 0`; `u = (p, v_1 .. v_D)`.
//!
//! L. D. Landau and E. M. Lifshitz, Fluid Mechanics, 2nd edition 1987, section 64.

pub mod plane;
pub mod pulse;
pub mod radial;
#[cfg(test)]
mod tests;

use super::error::{Number, positive};
use super::system::System;

/// What sound runs through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Medium {
    /// rho, > 0.
    pub density: f64,
    /// c, > 0.
    pub sound_speed: f64,
}

impl Medium {
    /// `rho c`, the pressure of a plane wave over its velocity.
    pub fn impedance(&self) -> f64 {
        self.density * self.sound_speed
    }

    /// The coefficients in a dimension.
    pub fn system(&self, dimension: usize) -> System {
        let stiffness = self.impedance() * self.sound_speed;
        (0..dimension).fold(System::zero(dimension, dimension + 1), |system, axis| {
            system.flux(axis, [0, 1 + axis], stiffness).flux(
                axis,
                [1 + axis, 0],
                1.0 / self.density,
            )
        })
    }

    fn numbers(&self) -> [Number; 2] {
        [
            positive("density", self.density),
            positive("sound_speed", self.sound_speed),
        ]
    }
}
