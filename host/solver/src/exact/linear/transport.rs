//! Transport of a scalar by a given velocity, with decay and a source:
//! `du/dt + div(v u) + lambda u = s`, from a Gaussian.
//!
//! Along the characteristic from X to x at time t, whose neighbourhood grows by the Jacobian
//! `J = det dx/dX`, `dJ/dt = J div v`,
//!
//! - `u(x, t) = u_0(X) e^(-lambda t) / J + s ∫_0^t e^(-(lambda + div v)(t - t')) dt'`
//!
//! the integral for a div v that is uniform. R. J. LeVeque, Finite Volume Methods for
//! Hyperbolic Problems, 2002, chapter 9.

pub mod field;
#[cfg(test)]
mod tests;

use super::error::{SolutionError, check, finite, not_negative};
use super::gaussian::{gaussian, gaussian_numbers};
use crate::exact::solution::{Solution, fill};
use field::Field;

/// A Gaussian, `amplitude exp(-|x - center|^2 / width^2)` at t = 0, in a velocity field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransportProblem {
    /// The velocity.
    pub field: Field,
    /// Of the Gaussian; zeros beyond the dimension.
    pub center: [f64; 3],
    /// Of the Gaussian, > 0.
    pub width: f64,
    /// Of the Gaussian.
    pub amplitude: f64,
    /// lambda, 1 / time, >= 0.
    pub decay: f64,
    /// s, u / time; 0 in [`Field::Wave`].
    pub source: f64,
    /// Size of the periodic box in each direction; none in infinite space. The velocity must
    /// have the period too. The Gaussian is then the sum of its images.
    pub periods: [Option<f64>; 3],
}

/// The solution of [`TransportProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transport {
    problem: TransportProblem,
}

impl TransportProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range, a period that the velocity has not, a source in a velocity wave.
    pub fn solve(self) -> Result<Transport, SolutionError> {
        let without_source = !matches!(self.field, Field::Wave { .. });
        let (need, holds) = ("0 in a velocity wave", self.source == 0.0);
        check(&[
            finite("center", self.center[0]),
            finite("center", self.center[1]),
            finite("center", self.center[2]),
            finite("amplitude", self.amplitude),
            not_negative("decay", self.decay),
            ("source", self.source, need, holds || without_source),
        ])?;
        check(&self.field.numbers())?;
        let names = ["period along x", "period along y", "period along z"];
        for axis in 0..3 {
            check(&gaussian_numbers(self.width, self.periods[axis]))?;
            if let Some(period) = self.periods[axis] {
                let holds = self.field.has_period(axis, period);
                check(&[(names[axis], period, "a period of the velocity", holds)])?;
            }
        }
        Ok(Transport { problem: self })
    }

    /// u at t = 0.
    fn initial(&self, position: [f64; 3]) -> f64 {
        (0..3).fold(self.amplitude, |product, axis| {
            let distance = position[axis] - self.center[axis];
            product * gaussian(distance, self.width, self.periods[axis])
        })
    }
}

impl Transport {
    /// What is transported, and how.
    pub fn problem(&self) -> &TransportProblem {
        &self.problem
    }
}

impl Solution for Transport {
    fn components(&self) -> usize {
        1
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let TransportProblem {
            field,
            decay,
            source,
            ..
        } = self.problem;
        let foot = field.foot(position, time);
        let faded = libm::exp(-decay * time) / field.jacobian(position, time);
        let mut u = self.problem.initial(foot) * faded;
        // A product with 0 would turn an overflow of the integral into no number.
        if source != 0.0 {
            let loss = decay + field.divergence(position);
            u += source * decaying_integral(loss, time);
        }
        fill(state, &[u]);
    }
}

/// `∫_0^t e^(-loss t') dt'`.
pub(in crate::exact) fn decaying_integral(loss: f64, time: f64) -> f64 {
    if loss == 0.0 {
        time
    } else {
        -libm::expm1(-loss * time) / loss
    }
}
