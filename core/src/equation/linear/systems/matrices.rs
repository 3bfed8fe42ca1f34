//! Any system with constant coefficients.

use super::super::system::FirstOrderSystem;
use crate::cloud::Place;
use crate::pairs::Nothing;
use crate::scalar::{Number, Scalar};

/// `∂u/∂t + Σ_i A^i ∂_i u + A⁰ u = 0` with matrices as they come, rows first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrices<S, const D: usize, const P: usize> {
    /// `A^i`.
    pub flux: [[[S; P]; P]; D],
    /// `A⁰`.
    pub decay: [[S; P]; P],
    /// Symmetric, positive definite, and `P A^i` symmetric.
    pub symmetriser: [[S; P]; P],
    /// The largest `|eigenvalue|` of `Σ_i n_i A^i`, `|n| = 1`.
    pub speed: S,
    /// A bound of the `|eigenvalues|` of `A⁰`.
    pub damping: S,
    /// See [`FirstOrderSystem::growth`].
    pub growth: S,
}

impl<const D: usize, const P: usize> Matrices<f64, D, P> {
    /// The same in another scalar: every number rounded once.
    pub fn rounded<S: Scalar>(&self) -> Matrices<S, D, P> {
        let number = S::from_f64;
        let square = |matrix: [[f64; P]; P]| matrix.map(|row| row.map(number));
        Matrices {
            flux: self.flux.map(square),
            decay: square(self.decay),
            symmetriser: square(self.symmetriser),
            speed: number(self.speed),
            damping: number(self.damping),
            growth: number(self.growth),
        }
    }
}

/// `M u`.
#[inline(always)]
fn product<S: Scalar, N: Number<Scalar = S>, const P: usize>(
    matrix: &[[S; P]; P],
    u: &[N; P],
) -> [N; P] {
    let mut result = [N::zero(); P];
    for i in 0..P {
        for j in 0..P {
            result[i] += N::splat(matrix[i][j]) * u[j];
        }
    }
    result
}

impl<S: Scalar, const D: usize, const P: usize> FirstOrderSystem<S, D, P> for Matrices<S, D, P> {
    type Medium = Nothing;
    const IS_UNIFORM: bool = true;

    fn medium(&self, _: &Place<S, D>) -> Nothing {
        Nothing
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(&self, _: &Nothing, n: &[N; D], u: &[N; P]) -> [N; P] {
        let mut flux = [N::zero(); P];
        for i in 0..D {
            let along = product(&self.flux[i], u);
            for j in 0..P {
                flux[j] += n[i] * along[j];
            }
        }
        flux
    }
    fn decay(&self, _: &Place<S, D>, u: &[S; P]) -> [S; P] {
        product(&self.decay, u)
    }
    fn speed(&self, _: &Nothing) -> S {
        self.speed
    }
    fn damping(&self) -> S {
        self.damping
    }
    fn symmetrised(&self, _: &Nothing, u: &[S; P]) -> [S; P] {
        product(&self.symmetriser, u)
    }
    fn growth(&self) -> S {
        self.growth
    }
}
