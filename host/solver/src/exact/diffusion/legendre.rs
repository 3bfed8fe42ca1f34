//! A Legendre polynomial that fades where the diffusivity ends:
//! `du/dt = d_x(b d_x u)`, `b = b_0 (1 - xi^2) m(t)`, `xi = (x - center)/radius`.
//!
//! - `u = A P_n(xi) exp(-n (n + 1) b_0 tau(t)/radius^2)`
//!
//! by Legendre's equation, `d_xi((1 - xi^2) d_xi P_n) = -n (n + 1) P_n`: NIST Handbook, 14.2.1. No
//! flux passes the ends xi = -1 and 1, where b is 0. Good to some n roundings of A.

#[cfg(test)]
mod tests;

use super::super::linear::error::{SolutionError, check, finite, not_negative, positive};
use super::modulation::{Modulation, elapsed};
use crate::exact::solution::{Solution, fill};

/// A polynomial on an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegendreProblem {
    /// The middle of the interval along x.
    pub center: f64,
    /// Half its length, > 0.
    pub radius: f64,
    /// n, 0 to 32.
    pub degree: u32,
    /// A, u at xi = 1 and t = 0.
    pub amplitude: f64,
    /// `b_0`, that in the middle, length^2 / time, >= 0.
    pub diffusivity: f64,
    /// m; none: 1.
    pub modulation: Option<Modulation>,
}

/// The solution of [`LegendreProblem`]. Beyond the interval b < 0: it means nothing there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Legendre {
    problem: LegendreProblem,
}

/// Of a polynomial: those of a higher degree need finer particles than any study has.
const HIGHEST: u32 = 32;

impl LegendreProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<Legendre, SolutionError> {
        let holds = self.degree <= HIGHEST;
        check(&[
            finite("center", self.center),
            positive("radius", self.radius),
            ("degree", f64::from(self.degree), "0 to 32", holds),
            finite("amplitude", self.amplitude),
            not_negative("diffusivity", self.diffusivity),
        ])?;
        if let Some(modulation) = self.modulation {
            check(&modulation.numbers())?;
        }
        Ok(Legendre { problem: self })
    }

    /// b at a place along x and a time.
    pub fn diffusivity(&self, x: f64, time: f64) -> f64 {
        let xi = (x - self.center) / self.radius;
        let swing = self.modulation.map_or(1.0, |m| m.factor(time));
        self.diffusivity * (1.0 - xi) * (1.0 + xi) * swing
    }
}

impl Legendre {
    /// What fades, and how.
    pub fn problem(&self) -> &LegendreProblem {
        &self.problem
    }
}

/// `P_n(x)` by `(m + 1) P_(m+1) = (2 m + 1) x P_m - m P_(m-1)`: NIST Handbook, 18.9.1.
fn legendre(degree: u32, x: f64) -> f64 {
    let (mut before, mut here) = (0.0, 1.0);
    for m in 0..degree {
        let m = f64::from(m);
        let next = ((2.0 * m + 1.0) * x * here - m * before) / (m + 1.0);
        (before, here) = (here, next);
    }
    here
}

impl Solution for Legendre {
    fn components(&self) -> usize {
        1
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let problem = &self.problem;
        let xi = (position[0] - problem.center) / problem.radius;
        let n = f64::from(problem.degree);
        let square = problem.radius * problem.radius;
        let rate = n * (n + 1.0) * problem.diffusivity / square;
        let fade = libm::exp(-rate * elapsed(problem.modulation, time));
        fill(
            state,
            &[problem.amplitude * fade * legendre(problem.degree, xi)],
        );
    }
}
