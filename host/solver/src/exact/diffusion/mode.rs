//! A standing wave of species that diffuse at their own pace and react:
//! `du_i/dt = b_i div(T grad u_i) + Σ_j M_ij u_j`.
//!
//! - `u = c(t) cos(k.(x - lower))`, `dc/dt = (M - (k.T k) diag(b)) c`
//!
//! by the exponential of a matrix. In a box with k = pi n/length in each direction no flux
//! passes the sides, if T is diagonal. With M of two species this is the mode whose growth
//! makes a pattern: A. M. Turing, Phil. Trans. R. Soc. B 237 (1952), section 7. The values are wrong by
//! some `1e-16 (1 + |M| t + k.T k b t)` of the largest ones in between.

#[cfg(test)]
mod tests;

use super::super::linear::error::{SolutionError, check, check_length, finite, not_negative};
use super::super::linear::plane_wave::dot;
use super::reaction::{Reaction, check_reaction};
use super::tensor::{IDENTITY, check_tensor};
use crate::exact::solution::Solution;

/// A wave vector, and the wave at t = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeProblem {
    /// k, radians / length; zeros beyond the dimension, and zero for a uniform state.
    pub wave_vector: [f64; 3],
    /// A place where the cosine is 1.
    pub lower: [f64; 3],
    /// c at t = 0: 1 to 8 numbers.
    pub state: Vec<f64>,
    /// b, as many, length^2 / time, >= 0.
    pub diffusivities: Vec<f64>,
    /// T, symmetric and without negative eigenvalues; none: 1.
    pub tensor: Option<[[f64; 3]; 3]>,
    /// M, `p * p` numbers row by row, 1 / time; none: 0.
    pub reaction: Vec<f64>,
}

/// The wave of [`ModeProblem`].
#[derive(Debug)]
pub struct Mode {
    problem: ModeProblem,
    coefficients: Reaction,
}

impl ModeProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// Lists of a wrong length, numbers out of range.
    pub fn solve(self) -> Result<Mode, SolutionError> {
        for axis in 0..3 {
            check(&[
                finite("wave_vector", self.wave_vector[axis]),
                finite("lower", self.lower[axis]),
            ])?;
        }
        check_reaction(&self.reaction, &self.state)?;
        check_length("diffusivities", self.diffusivities.len(), self.state.len())?;
        for b in &self.diffusivities {
            check(&[not_negative("diffusivity", *b)])?;
        }
        if let Some(tensor) = &self.tensor {
            check_tensor(tensor, 3)?;
        }
        Ok(Mode {
            coefficients: Reaction::new(self.generator(), self.state.clone()),
            problem: self,
        })
    }

    /// `M - (k.T k) diag(b)`.
    fn generator(&self) -> Vec<f64> {
        let p = self.state.len();
        let mut generator = self.reaction.clone();
        generator.resize(p * p, 0.0);
        let tensor = self.tensor.unwrap_or(IDENTITY);
        let square = dot(
            self.wave_vector,
            tensor.map(|row| dot(row, self.wave_vector)),
        );
        for (i, b) in self.diffusivities.iter().enumerate() {
            generator[i * p + i] -= square * b;
        }
        generator
    }
}

impl Mode {
    /// The species and their wave.
    pub fn problem(&self) -> &ModeProblem {
        &self.problem
    }
}

impl Solution for Mode {
    fn components(&self) -> usize {
        self.coefficients.components()
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let ModeProblem {
            wave_vector, lower, ..
        } = self.problem;
        let place = std::array::from_fn(|axis| position[axis] - lower[axis]);
        let wave = libm::cos(dot(wave_vector, place));
        self.coefficients.write(time, wave, state);
    }
}
