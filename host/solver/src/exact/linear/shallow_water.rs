//! A wave of shallow water on a rotating plane: `eta_t + H div v = 0`,
//! `v_t + g grad eta + f z x v = 0`; `u = (eta, v_x, v_y)`.
//!
//! The inertia-gravity or Poincare wave, with n = k/|k|, m across it to the left and
//! `phi = k.x - omega t`: A. E. Gill, Atmosphere-Ocean Dynamics, 1982, chapter 8.
//!
//! - `eta = A cos phi`, `v = A/(H |k|) (omega n cos phi + f m sin phi)`
//! - `omega^2 = f^2 + g H k^2`

#[cfg(test)]
mod tests;

use super::error::{SolutionError, check, finite, positive};
use super::plane_wave::PlaneWave;
use super::system::System;
use crate::exact::solution::{Solution, fill};

/// Water and a wave on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShallowWaterProblem {
    /// H, > 0.
    pub depth: f64,
    /// g, > 0.
    pub gravity: f64,
    /// f, 1 / time, twice the rate of rotation; > 0 if counterclockwise.
    pub coriolis: f64,
    /// k in the plane, not zero, and A, the largest elevation.
    pub wave: PlaneWave,
}

/// The solution of [`ShallowWaterProblem`]: eta, v_x and v_y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShallowWater {
    problem: ShallowWaterProblem,
    frequency: f64,
    /// The largest velocities along k and across.
    along: [f64; 2],
    across: [f64; 2],
}

impl ShallowWaterProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<ShallowWater, SolutionError> {
        let Self {
            depth,
            gravity,
            coriolis,
            wave,
        } = self;
        check(&[
            positive("depth", depth),
            positive("gravity", gravity),
            finite("coriolis", coriolis),
            positive("wave number", wave.wave_number()),
        ])?;
        check(&wave.numbers(["wave_vector", "amplitude"], 2))?;
        let k = wave.wave_number();
        let frequency = (coriolis * coriolis + gravity * depth * k * k).sqrt();
        let scale = wave.amplitude / (depth * k);
        let ([a, b, _], [c, d, _]) = (wave.direction(), wave.across());
        Ok(ShallowWater {
            problem: self,
            frequency,
            along: [a, b].map(|n| scale * frequency * n),
            across: [c, d].map(|m| scale * coriolis * m),
        })
    }
}

impl ShallowWater {
    /// omega.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The equations it solves.
    pub fn system(&self) -> System {
        let ShallowWaterProblem {
            depth,
            gravity,
            coriolis,
            ..
        } = self.problem;
        let still = (0..2).fold(System::zero(2, 3), |system, axis| {
            system
                .flux(axis, [0, 1 + axis], depth)
                .flux(axis, [1 + axis, 0], gravity)
        });
        still.reaction([1, 2], -coriolis).reaction([2, 1], coriolis)
    }
}

impl Solution for ShallowWater {
    fn components(&self) -> usize {
        3
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let wave = &self.problem.wave;
        let phase = wave.phase(position, self.frequency, time);
        let (cosine, sine) = (libm::cos(phase), libm::sin(phase));
        let velocity = |i: usize| self.along[i] * cosine + self.across[i] * sine;
        fill(state, &[wave.amplitude * cosine, velocity(0), velocity(1)]);
    }
}
