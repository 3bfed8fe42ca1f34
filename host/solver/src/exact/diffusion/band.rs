//! A band along x, two smooth fronts that a uniform flow carries while they spread:
//! `du/dt + div(a u) - div(b grad u) = 0`.
//!
//! - `u = A/2 [erf((x - l)/(sqrt(2) s)) - erf((x - r)/(sqrt(2) s))]`, `s^2 = s_0^2 + 2 b t`
//!
//! with the fronts `l, r = center -+ length/2 + a_x t`. Carslaw and Jaeger, section 2.2.
//! Good to some 2e-16 A.

#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use super::super::linear::error::{SolutionError, check, finite, not_negative, positive};
use crate::exact::solution::{Solution, fill};

/// A band of u = A, in zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandProblem {
    /// The middle along x at t = 0.
    pub center: f64,
    /// From front to front, > 0; at most the period.
    pub length: f64,
    /// Of the fronts at t = 0, > 0: `s_0^2 = width^2/2`, so that `u_x` of a front is a Gaussian
    /// `exp(-(x - l)^2/width^2)`.
    pub width: f64,
    /// A.
    pub amplitude: f64,
    /// b, length^2 / time, >= 0.
    pub diffusivity: f64,
    /// a; across x it changes nothing.
    pub velocity: [f64; 3],
    /// Size of the periodic box along x; none in infinite space.
    pub period: Option<f64>,
}

/// The solution of [`BandProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    problem: BandProblem,
}

/// Where erf is 1 and `exp(-x^2)` is nothing: 4e-18.
const REACH: f64 = 6.3;

/// `s/P` from which waves take fewer terms than images, 5 instead of 7.
const WIDE: f64 = 0.35;

impl BandProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<Band, SolutionError> {
        let [x, y, z] = self.velocity;
        check(&[
            finite("center", self.center),
            positive("length", self.length),
            positive("width", self.width),
            finite("amplitude", self.amplitude),
            not_negative("diffusivity", self.diffusivity),
            finite("velocity", x),
            finite("velocity", y),
            finite("velocity", z),
        ])?;
        if let Some(period) = self.period {
            let fits = self.length <= period;
            check(&[
                positive("period along x", period),
                ("length", self.length, "at most the period", fits),
            ])?;
        }
        Ok(Band { problem: self })
    }
}

impl Band {
    /// What spreads, and how.
    pub fn problem(&self) -> &BandProblem {
        &self.problem
    }

    /// u/A of one band, `distance` from its middle.
    fn single(&self, distance: f64, scale: f64) -> f64 {
        let half = 0.5 * self.problem.length;
        // erfc is precise beyond the band, where erf is 1.
        let (near, far) = (distance.abs() - half, distance.abs() + half);
        0.5 * (libm::erfc(near / scale) - libm::erfc(far / scale))
    }

    /// u/A of all images, those within [`REACH`] of a place.
    fn images(&self, distance: f64, scale: f64, period: f64) -> f64 {
        let reach = 0.5 * self.problem.length + REACH * scale;
        let first = libm::ceil((-reach - distance) / period) as i64;
        let last = libm::floor((reach - distance) / period) as i64;
        (first..=last)
            .map(|n| self.single(distance + n as f64 * period, scale))
            .sum()
    }

    /// The same as `length/P + Σ_m 2/(pi m) sin(k length/2) exp(-k^2 s^2/2) cos(k distance)`,
    /// `k = 2 pi m/P`.
    fn waves(&self, distance: f64, scale: f64, period: f64) -> f64 {
        let most = libm::ceil(REACH * period / (PI * scale)) as i32;
        let wave = |m: i32| {
            let k = 2.0 * PI * f64::from(m) / period;
            let part = 0.5 * k * scale;
            let height = 2.0 / (PI * f64::from(m)) * libm::exp(-part * part);
            height * libm::sin(0.5 * k * self.problem.length) * libm::cos(k * distance)
        };
        self.problem.length / period + (1..=most).map(wave).sum::<f64>()
    }
}

impl Solution for Band {
    fn components(&self) -> usize {
        1
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let problem = &self.problem;
        let distance = position[0] - problem.center - problem.velocity[0] * time;
        // sqrt(2) s.
        let square = problem.width * problem.width + 4.0 * problem.diffusivity * time;
        let scale = square.sqrt();
        let part = match problem.period {
            None => self.single(distance, scale),
            Some(period) if scale <= 2.0_f64.sqrt() * WIDE * period => {
                self.images(distance, scale, period)
            }
            Some(period) => self.waves(distance, scale, period),
        };
        fill(state, &[problem.amplitude * part]);
    }
}
