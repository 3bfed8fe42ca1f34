//! What a linear first-order system has to say.

use crate::cloud::Place;
use crate::domain::Wall;
use crate::pairs::Fields;
use crate::scalar::{Number, Scalar};

/// A system `∂u/∂t + Σ_i ∂_i(A^i u) + A⁰ u = f` of `P` components in `D` dimensions, with
///
/// `A^i(x,t) = v^i(x,t) I + C^i(x,t)`:
///
/// a velocity `v` that carries all components alike, and a coupling `C^i` between them. On
/// particles that follow `a` this gives the `B^i = (v^i - a^i) I + C^i` of (1.4).
///
/// The matrices need not be symmetric: there is a symmetric positive definite `P`, the
/// *symmetriser* of Remark 1, with `P A^i` symmetric. It makes the energy norm
/// `‖u‖² = ∫ u·Pu dx`, in which the solution grows no faster than
/// [`FirstOrderSystem::growth`] says.
pub trait FirstOrderSystem<S: Scalar, const D: usize, const P: usize>: Sync {
    /// What `C^i` needs to know of a place; [`Nothing`](crate::pairs::Nothing) where it is constant.
    type Medium: Fields<S>;
    /// Whether `C^i` is the same everywhere: then a pair applies it once, to `u_k + u_l`.
    const IS_UNIFORM: bool;
    /// Whether there is a coupling at all; without one, particles that follow `v` need no
    /// partners.
    const IS_COUPLED: bool = true;

    /// `v(x,t)`.
    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        let _ = place;
        [S::ZERO; D]
    }

    /// What `C^i` needs to know of a place.
    fn medium(&self, place: &Place<S, D>) -> Self::Medium;

    /// `Σ_i n_i C^i u`. Must be odd in `n` to the bit: products and sums of its components
    /// are, a constant added to them is not.
    fn flux<N: Number<Scalar = S>>(
        &self,
        medium: &<Self::Medium as Fields<S>>::Of<N>,
        n: &[N; D],
        u: &[N; P],
    ) -> [N; P];

    /// `A⁰ u`.
    fn decay(&self, place: &Place<S, D>, u: &[S; P]) -> [S; P] {
        let _ = (place, u);
        [S::ZERO; P]
    }

    /// `f(x,t)`.
    fn source(&self, place: &Place<S, D>) -> [S; P] {
        let _ = place;
        [S::ZERO; P]
    }

    /// The largest `|eigenvalue|` of `Σ_i n_i C^i` over unit vectors `n`: the wave speed.
    fn speed(&self, medium: &Self::Medium) -> S;

    /// A bound of the `|eigenvalues|` of `A⁰`.
    fn damping(&self) -> S {
        S::ZERO
    }

    /// `P u`.
    fn symmetrised(&self, medium: &Self::Medium, u: &[S; P]) -> [S; P] {
        let _ = medium;
        *u
    }

    /// `λ` with `d‖u‖/dt <= λ ‖u‖ + ‖f‖` in the energy norm: the largest eigenvalue of the
    /// symmetric part of `-½ Σ_i ∂_i A^i - A⁰` (with `P` constant, in its scalar product).
    fn growth(&self) -> S {
        S::ZERO
    }

    /// The mirror image of a state in a wall across direction `axis`: a parity, 1 or -1, per
    /// component. It must make the image of a solution a solution, of `A⁰` too; where that
    /// couples components of unlike parity, [`FirstOrderSystem::behind`] has to make up for it.
    fn reflected(&self, u: &[S; P], axis: usize) -> [S; P] {
        let _ = axis;
        *u
    }

    /// What lies behind a wall, from the mirror image that parity makes: the same, unless `A⁰`
    /// couples components of unlike parity.
    ///
    /// At the wall the odd components are 0 at all times. Their equations then say how steep the
    /// even ones are there, `C^n ∂_n u = f - A⁰ u`; a mirror image is flat. The image is to lie on
    /// that straight line, as [`Condition::Flux`](crate::equation::diffusion::Condition) has it:
    /// with a flat one the odd components have an error of order 1 next to the wall.
    fn behind(&self, medium: &Self::Medium, image: &[S; P], wall: &Wall<S>) -> [S; P] {
        let _ = (medium, wall);
        *image
    }

    /// The mirror image of a medium.
    fn reflected_medium(&self, medium: &Self::Medium, axis: usize) -> Self::Medium {
        let _ = axis;
        *medium
    }
}

/// A vector mirrored across direction `axis`, its components in `u` from `first` on.
pub(super) fn mirrored<S: Scalar, const P: usize>(u: &[S; P], first: usize, axis: usize) -> [S; P] {
    let mut image = *u;
    if let Some(component) = image.get_mut(first + axis) {
        *component = -*component;
    }
    image
}
