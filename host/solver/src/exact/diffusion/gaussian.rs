//! A Gaussian that a flow carries and deforms while it spreads:
//! `du/dt + div(a u) - div(b T grad u) = M u` with an a that is linear in x.
//!
//! It stays a Gaussian with a covariance Sigma,
//!
//! - `u = e^(M t) u_0 sqrt(det Sigma_0 / det Sigma) exp(-(x - c).Sigma^-1 (x - c)/2)`
//! - `dc/dt = a(c)`, `dSigma/dt = A Sigma + Sigma A^T + 2 b T`, `A = grad a`
//!
//! H. Risken, The Fokker-Planck
//! Equation, 1989, chapter 6: the Ornstein-Uhlenbeck process. The root keeps the mass.
//! Good to rounding, some 1e-15 of the peak, where b T t is not 1e12 times larger in one
//! direction than in another.

mod covariance;
mod images;
#[cfg(test)]
mod tests;

use super::super::linear::error::{
    SolutionError, check, dimension_up_to, finite, not_negative, positive,
};
use super::super::linear::transport::field::Field;
use super::modulation::Modulation;
use super::reaction::{Reaction, check_reaction};
use super::tensor::{IDENTITY, check_tensor};
use crate::exact::solution::Solution;
use images::Images;

/// `u_0 exp(-|x - center|^2 / width^2)` at t = 0: a variance of `width^2/2` in each direction.
#[derive(Debug, Clone, PartialEq)]
pub struct GaussianProblem {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// a; not [`Field::Wave`], in which it does not stay a Gaussian.
    pub field: Field,
    /// At t = 0; zeros beyond the dimension.
    pub center: [f64; 3],
    /// > 0.
    pub width: f64,
    /// `u_0`, the peak at t = 0: 1 to 8 numbers.
    pub state: Vec<f64>,
    /// b, length^2 / time, >= 0, of all components.
    pub diffusivity: f64,
    /// T, symmetric and without negative eigenvalues, zeros beyond the dimension; none: 1.
    pub tensor: Option<[[f64; 3]; 3]>,
    /// Of b; with T only in a uniform flow, and not in shear or compression.
    pub modulation: Option<Modulation>,
    /// M, `p * p` numbers row by row, 1 / time; none: 0.
    pub reaction: Vec<f64>,
    /// Size of the periodic box in each direction; none in infinite space. The velocity must
    /// have the period too. The Gaussian is then the sum of its images.
    pub periods: [Option<f64>; 3],
}

/// The solution of [`GaussianProblem`].
#[derive(Debug)]
pub struct Gaussian {
    problem: GaussianProblem,
    reaction: Reaction,
}

impl GaussianProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range, a period that the velocity has not, a velocity wave, a modulation
    /// where it has no closed form.
    pub fn solve(self) -> Result<Gaussian, SolutionError> {
        check(&[
            dimension_up_to(self.dimension, 3),
            positive("width", self.width),
            not_negative("diffusivity", self.diffusivity),
        ])?;
        check_reaction(&self.reaction, &self.state)?;
        if let Some(tensor) = &self.tensor {
            check_tensor(tensor, self.dimension)?;
        }
        self.check_field()?;
        self.check_modulation()?;
        self.check_space()?;
        Ok(Gaussian {
            reaction: Reaction::new(self.reaction.clone(), self.state.clone()),
            problem: self,
        })
    }

    fn check_field(&self) -> Result<(), SolutionError> {
        check(&self.field.numbers())?;
        let given = self.dimension as f64;
        match self.field {
            Field::Wave { .. } => Err(SolutionError::Together {
                one: "a velocity wave",
                other: "diffusion",
            }),
            Field::Rotation { .. } | Field::Shear { .. } => {
                let need = "2 or 3 in rotation and shear";
                check(&[("dimension", given, need, self.dimension > 1)])
            }
            Field::Compression { dimension, .. } => {
                let need = "that of the compression";
                check(&[("dimension", given, need, self.dimension == dimension)])
            }
            Field::Still | Field::Uniform { .. } => Ok(()),
        }
    }

    fn check_modulation(&self) -> Result<(), SolutionError> {
        let Some(modulation) = self.modulation else {
            return Ok(());
        };
        check(&modulation.numbers())?;
        let other = match (self.field, self.tensor) {
            (Field::Rotation { .. }, Some(_)) => "a tensor in a rotation",
            (Field::Shear { .. }, _) => "a shear",
            (Field::Compression { .. }, _) => "a compression",
            _ => return Ok(()),
        };
        let one = "a modulation";
        Err(SolutionError::Together { one, other })
    }

    /// The center, the velocity and the periods.
    fn check_space(&self) -> Result<(), SolutionError> {
        let velocity = match self.field {
            Field::Uniform { velocity } => velocity,
            _ => [0.0; 3],
        };
        let names = ["period along x", "period along y", "period along z"];
        let need = "zero beyond the dimension";
        for axis in 0..3 {
            let inside = axis < self.dimension;
            let (center, v) = (self.center[axis], velocity[axis]);
            check(&[
                finite("center", center),
                ("center", center, need, inside || center == 0.0),
                ("velocity", v, need, inside || v == 0.0),
            ])?;
            if let Some(period) = self.periods[axis] {
                let holds = self.field.has_period(axis, period);
                check(&[
                    positive(names[axis], period),
                    (names[axis], period, "none beyond the dimension", inside),
                    (names[axis], period, "a period of the velocity", holds),
                ])?;
            }
        }
        Ok(())
    }

    /// T.
    fn tensor_or_identity(&self) -> [[f64; 3]; 3] {
        self.tensor.unwrap_or(IDENTITY)
    }
}

impl Gaussian {
    /// What spreads, and how.
    pub fn problem(&self) -> &GaussianProblem {
        &self.problem
    }

    /// `sqrt(det Sigma_0 / det Sigma) exp(-(x - c).Sigma^-1 (x - c)/2)`, all images.
    fn shape(&self, position: [f64; 3], time: f64) -> f64 {
        let problem = &self.problem;
        // The flow does not change with time: its way forward is the way back of -t.
        let center = problem.field.foot(problem.center, -time);
        let distance = std::array::from_fn(|axis| position[axis] - center[axis]);
        let images = Images {
            dimension: problem.dimension,
            covariance: problem.covariance(time),
            periods: problem.periods,
        };
        let initial = problem.width * std::f64::consts::FRAC_1_SQRT_2;
        images.sum(distance, initial)
    }
}

impl Solution for Gaussian {
    fn components(&self) -> usize {
        self.reaction.components()
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let shape = self.shape(position, time);
        self.reaction.write(time, shape, state);
    }
}
