//! The constant coefficients of a linear system without source.

use super::error::{SolutionError, check, check_length, dimension_up_to, finite};

/// `du/dt + Σ_i d_i(A^i u) + A^0 u = 0`.
#[derive(Debug, Clone, PartialEq)]
pub struct System {
    /// p, the length of u; 1 to 8.
    pub components: usize,
    /// `A^i`, one a direction, row by row: `p * p` numbers each.
    pub fluxes: Vec<Vec<f64>>,
    /// `A^0`, row by row: `p * p` numbers.
    pub reaction: Vec<f64>,
}

/// The most components a system may have.
const MOST_COMPONENTS: usize = 8;

impl System {
    /// All coefficients 0.
    pub fn zero(dimension: usize, components: usize) -> Self {
        let matrix = vec![0.0; components * components];
        Self {
            components,
            fluxes: vec![matrix.clone(); dimension],
            reaction: matrix,
        }
    }

    /// How many directions have a flux.
    pub fn dimension(&self) -> usize {
        self.fluxes.len()
    }

    /// One coefficient of `A^i`, i = `axis` counted from 0, more.
    pub(super) fn flux(mut self, axis: usize, [row, column]: [usize; 2], value: f64) -> Self {
        self.fluxes[axis][row * self.components + column] = value;
        self
    }

    /// One coefficient of `A^0` more.
    pub(super) fn reaction(mut self, [row, column]: [usize; 2], value: f64) -> Self {
        self.reaction[row * self.components + column] = value;
        self
    }

    /// That all matrices have `p * p` finite numbers.
    pub(super) fn check(&self) -> Result<(), SolutionError> {
        let p = self.components;
        let holds = (1..=MOST_COMPONENTS).contains(&p);
        check(&[
            ("components", p as f64, "1 to 8", holds),
            dimension_up_to(self.dimension(), 3),
        ])?;
        for (quantity, matrix) in self.named() {
            check_length(quantity, matrix.len(), p * p)?;
            for value in matrix {
                check(&[finite(quantity, *value)])?;
            }
        }
        Ok(())
    }

    fn named(&self) -> impl Iterator<Item = (&'static str, &Vec<f64>)> {
        let fluxes = ["A^1", "A^2", "A^3"].into_iter().zip(&self.fluxes);
        fluxes.chain([("A^0", &self.reaction)])
    }
}
