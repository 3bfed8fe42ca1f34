//! A system whose matrices are formulas of place and time.

use motes_core::cloud::Place;
use motes_core::equation::linear::FirstOrderSystem;
use motes_core::scalar::{Number, Scalar};

use crate::families::strengths::{Frame, Plan, rounded};
use crate::scenario::formula::Formula;
use crate::scenario::linear::System;

/// `∂u/∂t + Σ_i ∂_i(A^i(x,t) u) + A⁰(x,t) u = 0`. What the formulas compute is an `f64`, rounded once to
/// the scalar.
///
/// The energy norm is that of `u` itself: the symmetriser of Remark 1 is a different one at every place.
pub(in crate::families) struct VariableMatrices {
    flux: Vec<Vec<Entry>>,
    decay: Vec<Entry>,
    frame: Frame,
    /// The largest wave speed, in the solver's units.
    speed: f64,
    /// A bound of the `|eigenvalues|` of `A⁰`, in the solver's units.
    damping: f64,
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
    pub(in crate::families) fn variable_matrices(&self) -> Option<VariableMatrices> {
        let System::VariableMatrices {
            components,
            flux,
            decay,
            ..
        } = &self.system
        else {
            return None;
        };
        let waves = self.waves?;
        Some(VariableMatrices {
            flux: flux
                .iter()
                .map(|matrix| entries(matrix, *components))
                .collect(),
            decay: entries(decay, *components),
            frame: self.frame(),
            speed: waves.speed / self.units.velocity,
            damping: waves.damping * self.unit_of_time(),
        })
    }
}

impl<S: Scalar, const D: usize, const P: usize> FirstOrderSystem<S, D, P> for VariableMatrices {
    type Medium = [[[S; P]; P]; D];
    const IS_UNIFORM: bool = false;

    fn medium(&self, place: &Place<S, D>) -> Self::Medium {
        let point = self.frame.point(place);
        let mut medium = [[[S::ZERO; P]; P]; D];
        for (matrix, entries) in medium.iter_mut().zip(&self.flux) {
            for entry in entries {
                let value = entry.value.at(&point) / self.frame.units.velocity;
                matrix[entry.row][entry.column] = rounded(value);
            }
        }
        medium
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(
        &self,
        medium: &[[[N; P]; P]; D],
        n: &[N; D],
        u: &[N; P],
    ) -> [N; P] {
        let mut flux = [N::zero(); P];
        for i in 0..D {
            for row in 0..P {
                let mut along = N::zero();
                for column in 0..P {
                    along += medium[i][row][column] * u[column];
                }
                flux[row] += n[i] * along;
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
            let rate = rounded::<S>(entry.value.at(&point) * self.frame.time());
            rates[entry.row] += rate * u[entry.column];
        }
        rates
    }
    fn speed(&self, _: &Self::Medium) -> S {
        S::from_f64(self.speed)
    }
    fn damping(&self) -> S {
        S::from_f64(self.damping)
    }
}
