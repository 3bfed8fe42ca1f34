//! Light in a cavity, transverse electric in the plane: `eps E_t = (d_y H, -d_x H)`,
//! `mu H_t = d_y E_x - d_x E_y`; `u = (E_x, E_y, H_z)`.
//!
//! The standing wave of a periodic box, `k_x = 2 pi m / L_x`, `k_y = 2 pi n / L_y`:
//! J. D. Jackson, Classical Electrodynamics, 3rd edition 1999, chapter 8.
//!
//! - `H_z = A cos(k_x x) cos(k_y y) cos(omega t)`
//! - `E_x = -A k_y/(eps omega) cos(k_x x) sin(k_y y) sin(omega t)`
//! - `E_y = A k_x/(eps omega) sin(k_x x) cos(k_y y) sin(omega t)`
//! - `omega^2 = (k_x^2 + k_y^2) / (eps mu)`
//!
//! The lines where a sine is 0 may be perfect conductors: the tangential E is 0 there.

#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use super::error::{SolutionError, check, finite, positive};
use super::system::System;
use crate::exact::solution::{Solution, fill};

/// A medium, a box and a wave in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaxwellProblem {
    /// eps, > 0.
    pub permittivity: f64,
    /// mu, > 0.
    pub permeability: f64,
    /// L_x and L_y, > 0.
    pub lengths: [f64; 2],
    /// m and n, how many waves fit into the box; not both 0.
    pub modes: [u32; 2],
    /// A, the largest H.
    pub amplitude: f64,
}

/// The solution of [`MaxwellProblem`]: E_x, E_y and H_z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Maxwell {
    problem: MaxwellProblem,
    wave_vector: [f64; 2],
    frequency: f64,
}

impl MaxwellProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<Maxwell, SolutionError> {
        let [m, n] = self.modes.map(f64::from);
        check(&[
            positive("permittivity", self.permittivity),
            positive("permeability", self.permeability),
            positive("length along x", self.lengths[0]),
            positive("length along y", self.lengths[1]),
            positive("sum of modes", m + n),
            finite("amplitude", self.amplitude),
        ])?;
        let [x, y] = [m / self.lengths[0], n / self.lengths[1]].map(|waves| 2.0 * PI * waves);
        let slowness = self.permittivity * self.permeability;
        Ok(Maxwell {
            problem: self,
            wave_vector: [x, y],
            frequency: ((x * x + y * y) / slowness).sqrt(),
        })
    }
}

impl Maxwell {
    /// omega.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The equations it solves.
    pub fn system(&self) -> System {
        let a = 1.0 / self.problem.permittivity;
        let b = 1.0 / self.problem.permeability;
        System::zero(2, 3)
            .flux(0, [1, 2], a)
            .flux(0, [2, 1], b)
            .flux(1, [0, 2], -a)
            .flux(1, [2, 0], -b)
    }
}

impl Solution for Maxwell {
    fn components(&self) -> usize {
        3
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let MaxwellProblem {
            permittivity,
            amplitude,
            ..
        } = self.problem;
        let [kx, ky] = self.wave_vector;
        let (x, y, turn) = (kx * position[0], ky * position[1], self.frequency * time);
        let electric = amplitude / (permittivity * self.frequency) * libm::sin(turn);
        let magnetic = amplitude * libm::cos(turn);
        let [cos_x, cos_y] = [x, y].map(libm::cos);
        let [sin_x, sin_y] = [x, y].map(libm::sin);
        let field = [
            -ky * electric * cos_x * sin_y,
            kx * electric * sin_x * cos_y,
            magnetic * cos_x * cos_y,
        ];
        fill(state, &field);
    }
}
