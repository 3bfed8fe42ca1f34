//! A travelling sound wave of finite amplitude, exact until it breaks.
//!
//! The initial state is a sine in the density, isentropic, running to larger x:
//!
//! - `rho = rho_0 (1 + A sin(2 pi x / L))`
//! - `p = p_0 (rho/rho_0)^gamma`, `c = c_0 (rho/rho_0)^((gamma-1)/2)`, `c_0^2 = gamma p_0/rho_0`
//! - `u = 2 (c - c_0) / (gamma - 1)`
//!
//! The last makes the Riemann invariant `u - 2c/(gamma-1)` uniform, so that all fields are
//! constant on the straight characteristics `x = xi + (u + c)(xi) t`: a simple wave, B. Riemann
//! 1860; Landau and Lifshitz, Fluid Mechanics, 2nd edition 1987, section 101. It is exact to all
//! orders of A. To first order it is the linear wave `rho_0 (1 + A sin(k(x - c_0 t)))`,
//! `u = A c_0 sin`, `p = p_0 (1 + gamma A sin)`.

#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use super::flow::{Flow, FlowError, FlowState, check, gamma_number};

/// A wave along x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoundWaveProblem {
    /// Ratio of the specific heats, > 1.
    pub gamma: f64,
    /// Of the gas at rest, > 0.
    pub density: f64,
    /// Of the gas at rest, > 0.
    pub pressure: f64,
    /// Relative amplitude A of the density, |A| < 1.
    pub amplitude: f64,
    /// Of the wave, > 0.
    pub wavelength: f64,
}

/// The flow of [`SoundWaveProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoundWave {
    problem: SoundWaveProblem,
    sound_speed: f64,
}

impl SoundWaveProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<SoundWave, FlowError> {
        let small = self.amplitude.abs() < 1.0;
        check(&[
            gamma_number(self.gamma),
            ("density", self.density, "> 0", self.density > 0.0),
            ("pressure", self.pressure, "> 0", self.pressure > 0.0),
            ("amplitude", self.amplitude, "> -1 and < 1", small),
            ("wavelength", self.wavelength, "> 0", self.wavelength > 0.0),
        ])?;
        Ok(SoundWave {
            problem: self,
            sound_speed: (self.gamma * self.pressure / self.density).sqrt(),
        })
    }
}

impl SoundWave {
    /// Of the gas at rest.
    pub fn sound_speed(&self) -> f64 {
        self.sound_speed
    }

    /// When the first characteristics meet; infinite for amplitude 0. From then on the
    /// true flow has a shock, and this solution is none.
    ///
    /// `t = 1 / max(-d(u + c)/dxi)`, `d(u+c)/dxi = (gamma+1)/2 c_0 k A cos (1 + A sin)^m`,
    /// `m = (gamma-3)/2`, largest where `A (1+m) sin^2 + sin - m A = 0`.
    pub fn breaking_time(&self) -> f64 {
        let SoundWaveProblem {
            gamma, wavelength, ..
        } = self.problem;
        let a = self.problem.amplitude.abs();
        let m = 0.5 * (gamma - 3.0);
        let root = (1.0 + 4.0 * a * a * m * (1.0 + m)).sqrt();
        let sine = 2.0 * m * a / (1.0 + root);
        let cosine = (1.0 - sine * sine).sqrt();
        let steepest = a * cosine * libm::pow(1.0 + a * sine, m);
        wavelength / (PI * (gamma + 1.0) * self.sound_speed * steepest)
    }

    /// ln(rho/rho_0), u and the speed u + c of the characteristic from xi.
    fn characteristic(&self, xi: f64) -> (f64, f64, f64) {
        let SoundWaveProblem {
            gamma,
            amplitude,
            wavelength,
            ..
        } = self.problem;
        let phase = xi / wavelength;
        // Whole wavelengths off first: they are exact, multiples of 2 pi are not.
        let sine = libm::sin(2.0 * PI * (phase - libm::floor(phase)));
        let ln = libm::log1p(amplitude * sine);
        // c/c_0 - 1 without the loss of a difference.
        let rise = libm::expm1(0.5 * (gamma - 1.0) * ln);
        let velocity = 2.0 / (gamma - 1.0) * self.sound_speed * rise;
        let speed = velocity + self.sound_speed * (1.0 + rise);
        (ln, velocity, speed)
    }

    /// The foot xi of the characteristic through x at a time: bisection, which needs no
    /// more than that `xi + (u + c) t` increases.
    fn foot(&self, x: f64, time: f64) -> f64 {
        if time == 0.0 {
            return x;
        }
        let (gamma, a) = (self.problem.gamma, self.problem.amplitude.abs());
        let extreme = |density: f64| {
            let rise = libm::pow(density, 0.5 * (gamma - 1.0)) - 1.0;
            self.sound_speed * (1.0 + (gamma + 1.0) / (gamma - 1.0) * rise)
        };
        let mut lower = x - extreme(1.0 + a) * time;
        let mut upper = x - extreme(1.0 - a) * time;
        // Halves of an interval of some wavelengths: 60 reach the rounding.
        for _ in 0..100 {
            let middle = 0.5 * (lower + upper);
            if !(lower < middle && middle < upper) {
                break;
            }
            let (_, _, speed) = self.characteristic(middle);
            if middle + speed * time > x {
                upper = middle;
            } else {
                lower = middle;
            }
        }
        0.5 * (lower + upper)
    }
}

impl Flow for SoundWave {
    /// Depends on x only. After [`SoundWave::breaking_time`] meaningless, but finite.
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let SoundWaveProblem {
            gamma,
            density,
            pressure,
            ..
        } = self.problem;
        let (ln, velocity, _) = self.characteristic(self.foot(position[0], time));
        let density = density * libm::exp(ln);
        let pressure = pressure * libm::exp(gamma * ln);
        FlowState::ideal(density, [velocity, 0.0, 0.0], pressure, gamma)
    }
}
