//! Any system with coefficients of place and time.

use super::super::system::FirstOrderSystem;
use crate::cloud::Place;
use crate::scalar::{Number, Scalar};

/// Matrices of place and time: what a [`VariableMatrices`] asks for.
pub trait MatrixField<S: Scalar, const D: usize, const P: usize>: Sync {
    /// `A^i(x,t)`, rows first; velocities.
    fn flux(&self, place: &Place<S, D>) -> [[[S; P]; P]; D];

    /// `A⁰(x,t) u`, 1/time.
    fn decay(&self, place: &Place<S, D>, u: &[S; P]) -> [S; P] {
        let _ = (place, u);
        [S::ZERO; P]
    }
}

/// `∂u/∂t + Σ_i ∂_i(A^i(x,t) u) + A⁰(x,t) u = 0` with matrices as they come.
///
/// The energy norm is that of `u` itself: the symmetriser of Remark 1 is a different one at every place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VariableMatrices<S, M> {
    /// The matrices.
    pub matrices: M,
    /// The largest `|eigenvalue|` of `Σ_i n_i A^i`, `|n| = 1`, anywhere and at any time.
    pub speed: S,
    /// A bound of the `|eigenvalues|` of `A⁰`.
    pub damping: S,
}

impl<S, M, const D: usize, const P: usize> FirstOrderSystem<S, D, P> for VariableMatrices<S, M>
where
    S: Scalar,
    M: MatrixField<S, D, P>,
{
    type Medium = [[[S; P]; P]; D];
    const IS_UNIFORM: bool = false;

    fn medium(&self, place: &Place<S, D>) -> Self::Medium {
        self.matrices.flux(place)
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
        self.matrices.decay(place, u)
    }
    fn speed(&self, _: &Self::Medium) -> S {
        self.speed
    }
    fn damping(&self) -> S {
        self.damping
    }
}
