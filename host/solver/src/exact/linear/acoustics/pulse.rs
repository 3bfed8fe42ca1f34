//! A pressure of any shape released at rest in one dimension. d'Alembert 1747:
//!
//! - `p = (f(x - c t) + f(x + c t)) / 2`
//! - `v = (f(x - c t) - f(x + c t)) / (2 rho c)`

use std::f64::consts::PI;

use super::super::error::{Number, SolutionError, check, finite, positive};
use super::super::gaussian::{gaussian, gaussian_numbers};
use super::super::system::System;
use super::Medium;
use crate::exact::solution::{Solution, fill};

/// f, the pressure at t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pulse {
    /// `exp(sin(2 pi (x - lower) / length))`: periodic, and with all its Fourier modes.
    ExpSine {
        /// The period, > 0.
        length: f64,
        /// Where the sine starts.
        lower: f64,
    },
    /// `amplitude exp(-(x - center)^2 / width^2)`, with its images in a periodic line.
    Gaussian {
        /// Where it is largest.
        center: f64,
        /// Distance at which it has fallen to 1/e, > 0.
        width: f64,
        /// The largest pressure.
        amplitude: f64,
        /// Of the line, > 0; none if infinite.
        period: Option<f64>,
    },
}

/// A pulse in a medium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AcousticPulseProblem {
    /// What it runs through.
    pub medium: Medium,
    /// The pressure at t = 0.
    pub pulse: Pulse,
}

/// The solution of [`AcousticPulseProblem`]: p and v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AcousticPulse {
    problem: AcousticPulseProblem,
}

impl Pulse {
    /// f at a place.
    pub fn at(&self, x: f64) -> f64 {
        match *self {
            Self::ExpSine { length, lower } => {
                let phase = (x - lower) / length;
                // Whole lengths off first: they are exact, multiples of 2 pi are not.
                libm::exp(libm::sin(2.0 * PI * (phase - libm::floor(phase))))
            }
            Self::Gaussian {
                center,
                width,
                amplitude,
                period,
            } => amplitude * gaussian(x - center, width, period),
        }
    }

    fn numbers(&self) -> Vec<Number> {
        match *self {
            Self::ExpSine { length, lower } => {
                vec![positive("length", length), finite("lower", lower)]
            }
            Self::Gaussian {
                center,
                width,
                amplitude,
                period,
            } => {
                let own = [finite("center", center), finite("amplitude", amplitude)];
                [own.as_slice(), &gaussian_numbers(width, period)].concat()
            }
        }
    }
}

impl AcousticPulseProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<AcousticPulse, SolutionError> {
        check(&self.medium.numbers())?;
        check(&self.pulse.numbers())?;
        Ok(AcousticPulse { problem: self })
    }
}

impl AcousticPulse {
    /// The equations it solves.
    pub fn system(&self) -> System {
        self.problem.medium.system(1)
    }
}

impl Solution for AcousticPulse {
    fn components(&self) -> usize {
        2
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let AcousticPulseProblem { medium, pulse } = self.problem;
        let way = medium.sound_speed * time;
        let (right, left) = (pulse.at(position[0] - way), pulse.at(position[0] + way));
        let velocity = 0.5 * (right - left) / medium.impedance();
        fill(state, &[0.5 * (right + left), velocity]);
    }
}
