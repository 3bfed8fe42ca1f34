//! A plane sound wave: `p = A sin(k.x - omega t)`, `v = k/|k| p / (rho c)`, `omega = c |k|`.

use super::super::error::{SolutionError, check, dimension_up_to};
use super::super::plane_wave::PlaneWave;
use super::super::system::System;
use super::Medium;
use crate::exact::solution::{Solution, fill};

/// A wave in a medium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AcousticWaveProblem {
    /// What it runs through.
    pub medium: Medium,
    /// D, 1 to 3.
    pub dimension: usize,
    /// k, and A, a pressure.
    pub wave: PlaneWave,
}

/// The solution of [`AcousticWaveProblem`]: p and the D components of v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AcousticWave {
    problem: AcousticWaveProblem,
    frequency: f64,
    direction: [f64; 3],
}

impl AcousticWaveProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<AcousticWave, SolutionError> {
        check(&self.medium.numbers())?;
        check(&[dimension_up_to(self.dimension, 3)])?;
        let names = ["wave_vector", "amplitude"];
        check(&self.wave.numbers(names, self.dimension))?;
        Ok(AcousticWave {
            problem: self,
            frequency: self.medium.sound_speed * self.wave.wave_number(),
            direction: self.wave.direction(),
        })
    }
}

impl AcousticWave {
    /// omega.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The equations it solves.
    pub fn system(&self) -> System {
        self.problem.medium.system(self.problem.dimension)
    }
}

impl Solution for AcousticWave {
    fn components(&self) -> usize {
        1 + self.problem.dimension
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let AcousticWaveProblem { medium, wave, .. } = self.problem;
        let phase = wave.phase(position, self.frequency, time);
        let pressure = wave.amplitude * libm::sin(phase);
        let [x, y, z] = self.direction.map(|n| n * pressure / medium.impedance());
        fill(state, &[pressure, x, y, z]);
    }
}
