//! A standing wave on a line with losses: `L I_t + V_x + R I = 0`, `C V_t + I_x + G V = 0`;
//! `u = (V, I)`. O. Heaviside, Philosophical Magazine 2 (1876).
//!
//! `V = A a(t) cos(k x)`, `I = A b(t) sin(k x)` with a(0) = 1, b(0) = 0 leaves
//! `a' = -(G/C) a - (k/C) b`, `b' = (k/L) a - (R/L) b`, hence
//!
//! - `a = e^(-m t) (cos(w t) + d sin(w t)/w)`, `b = e^(-m t) (k/L) sin(w t)/w`
//! - `m = (R/L + G/C)/2`, `d = (R/L - G/C)/2`, `w^2 = k^2/(L C) - d^2`
//!
//! With `w^2 < 0`, overdamped, cosh and sinh of `|w|`; with w = 0, critical, 1 and t.

#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use super::error::{SolutionError, check, finite, not_negative, positive};
use super::system::System;
use crate::exact::solution::{Solution, fill};

/// A line, all quantities per length, and a wave on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TelegraphProblem {
    /// L, > 0.
    pub inductance: f64,
    /// C, > 0.
    pub capacitance: f64,
    /// R, >= 0.
    pub resistance: f64,
    /// G, >= 0.
    pub conductance: f64,
    /// `2 pi / k`, > 0; the line repeats after it, hence after any multiple.
    pub wavelength: f64,
    /// A, the largest voltage at t = 0.
    pub amplitude: f64,
}

/// The solution of [`TelegraphProblem`]: V and I.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Telegraph {
    problem: TelegraphProblem,
    /// k.
    wave_number: f64,
    /// m, d and w^2.
    mean: f64,
    difference: f64,
    square: f64,
}

impl TelegraphProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<Telegraph, SolutionError> {
        check(&[
            positive("inductance", self.inductance),
            positive("capacitance", self.capacitance),
            not_negative("resistance", self.resistance),
            not_negative("conductance", self.conductance),
            positive("wavelength", self.wavelength),
            finite("amplitude", self.amplitude),
        ])?;
        let [r, g] = self.rates();
        let wave_number = 2.0 * PI / self.wavelength;
        let difference = 0.5 * (r - g);
        let bare = wave_number * wave_number / (self.inductance * self.capacitance);
        Ok(Telegraph {
            problem: self,
            wave_number,
            mean: 0.5 * (r + g),
            difference,
            square: bare - difference * difference,
        })
    }

    /// R/L and G/C.
    fn rates(&self) -> [f64; 2] {
        [
            self.resistance / self.inductance,
            self.conductance / self.capacitance,
        ]
    }
}

impl Telegraph {
    /// w^2: > 0 if the wave oscillates, < 0 if it is overdamped.
    pub fn squared_frequency(&self) -> f64 {
        self.square
    }

    /// The equations it solves.
    pub fn system(&self) -> System {
        let [r, g] = self.problem.rates();
        System::zero(1, 2)
            .flux(0, [0, 1], 1.0 / self.problem.capacitance)
            .flux(0, [1, 0], 1.0 / self.problem.inductance)
            .reaction([0, 0], g)
            .reaction([1, 1], r)
    }

    /// `e^(-m t) cos(w t)` and `e^(-m t) sin(w t)/w`, or what stands for them.
    fn damped(&self, time: f64) -> [f64; 2] {
        let w = self.square.abs().sqrt();
        if self.square > 0.0 {
            let fade = libm::exp(-self.mean * time);
            return [fade * libm::cos(w * time), fade * libm::sin(w * time) / w];
        }
        // m - |w| without the loss of a difference: m^2 - |w|^2 = (R/L) (G/C) + k^2/(L C).
        let [r, g] = self.problem.rates();
        let bare = self.square + self.difference * self.difference;
        let slow = libm::exp(-(r * g + bare) / (self.mean + w) * time);
        let ratio = libm::expm1(-2.0 * w * time);
        let sine = if w > 0.0 { -ratio / (2.0 * w) } else { time };
        [slow * (1.0 + 0.5 * ratio), slow * sine]
    }
}

impl Solution for Telegraph {
    fn components(&self) -> usize {
        2
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let TelegraphProblem {
            inductance,
            wavelength,
            amplitude,
            ..
        } = self.problem;
        let phase = position[0] / wavelength;
        // Whole wavelengths off first: they are exact, multiples of 2 pi are not.
        let phase = 2.0 * PI * (phase - libm::floor(phase));
        let [cosine, sine] = self.damped(time);
        let a = cosine + self.difference * sine;
        let b = self.wave_number / inductance * sine;
        let [voltage, current] = [a * libm::cos(phase), b * libm::sin(phase)];
        fill(state, &[amplitude * voltage, amplitude * current]);
    }
}
