//! A system whose matrices are formulas of place and time.

use motes_core::cloud::{Frame, Place};
use motes_core::equation::linear::systems::{MatrixField, VariableMatrices};
use motes_core::scalar::Scalar;

use crate::families::strengths::Plan;
use crate::scenario::formula::Formula;
use crate::scenario::linear::System;

/// `A^i(x,t)` and `A⁰(x,t)`. What the formulas compute is an `f64`, rounded once to the scalar.
pub(in crate::families) struct MatrixFormulas {
    flux: Vec<Vec<Entry>>,
    decay: Vec<Entry>,
    frame: Frame,
}

/// An entry of a matrix that is not 0 everywhere.
struct Entry {
    row: usize,
    column: usize,
    value: Formula,
}

/// The entries of a matrix, row by row.
fn entries(matrix: &[Formula], size: usize) -> Vec<Entry> {
    let all = matrix.iter().enumerate();
    let entry = |(place, value): (usize, &Formula)| Entry {
        row: place / size,
        column: place % size,
        value: value.clone(),
    };
    let is_there = |entry: &Entry| entry.value.value() != Some(0.0);
    all.map(entry).filter(is_there).collect()
}

impl Plan {
    /// A system whose matrices are formulas; `None` for another one.
    pub(in crate::families) fn variable_matrices<S: Scalar>(
        &self,
    ) -> Option<VariableMatrices<S, MatrixFormulas>> {
        let System::VariableMatrices {
            components,
            flux,
            decay,
            ..
        } = &self.system
        else {
            return None;
        };
        let (speed, damping) = self.wave_bounds()?;
        let flux = flux.iter().map(|matrix| entries(matrix, *components));
        Some(VariableMatrices {
            matrices: MatrixFormulas {
                flux: flux.collect(),
                decay: entries(decay, *components),
                frame: self.frame(),
            },
            speed: S::from_f64(speed),
            damping: S::from_f64(damping),
        })
    }

    /// Of matrices that are formulas, in solver units: the largest wave speed, and a bound of the
    /// `|eigenvalues|` of `A⁰`; `None` for another system.
    pub fn wave_bounds(&self) -> Option<(f64, f64)> {
        let waves = self.waves?;
        let speed = waves.speed / self.units.velocity;
        Some((speed, waves.damping * self.unit_of_time()))
    }
}

impl<S: Scalar, const D: usize, const P: usize> MatrixField<S, D, P> for MatrixFormulas {
    fn flux(&self, place: &Place<S, D>) -> [[[S; P]; P]; D] {
        let point = self.frame.point(place);
        let mut flux = [[[S::ZERO; P]; P]; D];
        for (matrix, entries) in flux.iter_mut().zip(&self.flux) {
            for entry in entries {
                matrix[entry.row][entry.column] = self.frame.velocity(entry.value.at(&point));
            }
        }
        flux
    }
    fn decay(&self, place: &Place<S, D>, u: &[S; P]) -> [S; P] {
        let mut rates = [S::ZERO; P];
        if self.decay.is_empty() {
            return rates;
        }
        let point = self.frame.point(place);
        for entry in &self.decay {
            let rate = self.frame.rate::<S>(entry.value.at(&point));
            rates[entry.row] += rate * u[entry.column];
        }
        rates
    }
}
