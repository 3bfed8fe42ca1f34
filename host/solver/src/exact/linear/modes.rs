//! A plane wave of any linear system with constant coefficients.
//!
//! `u(x, t) = Re[exp(-(i Σ_j k_j A^j + A^0) t) û e^(i k.x)]`. With `û = a - i b` this is
//! `u = a(t) cos(k.x) + b(t) sin(k.x)`, where
//!
//! - `da/dt = -A^0 a - K b`, `db/dt = K a - A^0 b`, `K = Σ_j k_j A^j`
//!
//! a real system of 2p numbers, solved by the exponential of its matrix. The values are wrong by
//! some `1e-16 (1 + |K| t + |A^0| t)` of the largest ones in between.

pub(crate) mod exponential;
#[cfg(test)]
pub(super) mod tests;

use std::sync::{Mutex, PoisonError};

use super::error::{SolutionError, check, check_length, finite};
use super::plane_wave::dot;
use super::system::System;
use crate::exact::solution::Solution;
use exponential::{exponential, product};

/// A system, a wave vector, and the wave at t = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeProblem {
    /// The coefficients. That it is hyperbolic is not checked: if not, the wave may grow.
    pub system: System,
    /// k, radians / length; zeros beyond the dimension, and zero for a uniform state.
    pub wave_vector: [f64; 3],
    /// a at t = 0, p numbers.
    pub cosine: Vec<f64>,
    /// b at t = 0, p numbers.
    pub sine: Vec<f64>,
}

/// The wave of [`ModeProblem`].
#[derive(Debug)]
pub struct Mode {
    problem: ModeProblem,
    /// Of `d(a, b)/dt = generator (a, b)`, row by row.
    generator: Vec<f64>,
    latest: Mutex<Coefficients>,
}

/// (a, b) at the last time asked for: points are asked for at the same time by the thousand.
#[derive(Debug)]
struct Coefficients {
    time: f64,
    values: Vec<f64>,
}

impl ModeProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// Lists of a wrong length, numbers that are not finite.
    pub fn solve(self) -> Result<Mode, SolutionError> {
        self.system.check()?;
        let p = self.system.components;
        let beyond = self.wave_vector.iter().skip(self.system.dimension());
        for k in self.wave_vector {
            check(&[finite("wave_vector", k)])?;
        }
        for k in beyond {
            let need = "zero beyond the dimension";
            check(&[("wave_vector", *k, need, *k == 0.0)])?;
        }
        for (name, values) in [("cosine", &self.cosine), ("sine", &self.sine)] {
            check_length(name, values.len(), p)?;
            for value in values {
                check(&[finite(name, *value)])?;
            }
        }
        Ok(Mode {
            generator: self.generator(),
            latest: Mutex::new(Coefficients {
                time: 0.0,
                values: self.initial(),
            }),
            problem: self,
        })
    }

    fn initial(&self) -> Vec<f64> {
        [self.cosine.as_slice(), &self.sine].concat()
    }

    /// `[[-A^0, -K], [K, -A^0]]`.
    fn generator(&self) -> Vec<f64> {
        let p = self.system.components;
        let mut generator = vec![0.0; 4 * p * p];
        for row in 0..p {
            for column in 0..p {
                let entry = row * p + column;
                let fluxes = self.system.fluxes.iter().zip(self.wave_vector);
                let k = fluxes.map(|(a, k)| k * a[entry]).sum::<f64>();
                let reaction = -self.system.reaction[entry];
                let (upper, lower) = (row * 2 * p, (row + p) * 2 * p);
                generator[upper + column] = reaction;
                generator[upper + p + column] = -k;
                generator[lower + column] = k;
                generator[lower + p + column] = reaction;
            }
        }
        generator
    }
}

impl Mode {
    /// The system and its wave.
    pub fn problem(&self) -> &ModeProblem {
        &self.problem
    }

    /// (a, b) at a time.
    fn coefficients(&self, time: f64) -> Vec<f64> {
        let exponent: Vec<f64> = self.generator.iter().map(|entry| entry * time).collect();
        let n = 2 * self.components();
        product(&exponential(&exponent, n), &self.problem.initial(), n)
    }
}

impl Solution for Mode {
    fn components(&self) -> usize {
        self.problem.system.components
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let phase = dot(self.problem.wave_vector, position);
        let (cosine, sine) = (libm::cos(phase), libm::sin(phase));
        // A thread that panicked leaves values of one time or of the other, never of both.
        let mut latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner);
        if latest.time != time {
            *latest = Coefficients {
                time,
                values: self.coefficients(time),
            };
        }
        let (a, b) = latest.values.split_at(self.components());
        for (slot, (a, b)) in state.iter_mut().zip(a.iter().zip(b)) {
            *slot = a * cosine + b * sine;
        }
    }
}
