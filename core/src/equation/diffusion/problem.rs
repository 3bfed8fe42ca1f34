//! What a convection-diffusion problem has to say.

use super::wall::Condition;
use crate::cloud::Place;
use crate::scalar::Scalar;

/// `∂u/∂t + div(a u) - div(b ∇u) = f(x, t, u)`, for each of `P` species; what is common to them is
/// `a`, which the particles follow.
pub trait DiffusionProblem<S: Scalar, const D: usize, const P: usize>: Sync {
    /// `b(x,t)` of each species, >= 0, length²/time.
    fn diffusivity(&self, place: &Place<S, D>) -> [S; P];

    /// `b` of each species on the way between two coordinates along x: `1/b` averaged along it, which
    /// is that of resistances in a row, where `b` jumps from layer to layer across x. `None` where `b`
    /// is smooth. The same bits whichever end is named first.
    ///
    /// Asked for with [`Mean::Harmonic`](super::Mean::Harmonic).
    fn between(&self, ends: [S; 2], time: S) -> Option<[S; P]> {
        let _ = (ends, time);
        None
    }

    /// By what factor `b` may yet exceed what it is at that time: a step is bounded by the largest.
    fn headroom(&self, time: S) -> S {
        let _ = time;
        S::ONE
    }

    /// A symmetric tensor `T`, eigenvalues >= 0, that makes diffusion `div(b T ∇u)`; `None` for 1.
    ///
    /// Differs from the paper: an extension, see [`Direct`](super::Direct).
    fn tensor(&self) -> Option<[[S; D]; D]> {
        None
    }

    /// `f(x,t,u)`: sources, decay, reactions.
    fn reaction(&self, place: &Place<S, D>, u: &[S; P]) -> [S; P] {
        let _ = (place, u);
        [S::ZERO; P]
    }

    /// A bound of the `|eigenvalues|` of `∂f/∂u`: it limits the step.
    fn reaction_rate(&self) -> S {
        S::ZERO
    }

    /// A bound of all that [`DiffusionProblem::reaction`] makes on its way for values up to `u` in
    /// magnitude: what a proof that a format holds it goes by. Without it a problem with a
    /// [`DiffusionProblem::reaction_rate`] is refused in a format that wraps.
    fn largest_reaction(&self, u: f64) -> f64 {
        let _ = u;
        match self.reaction_rate() > S::ZERO {
            true => f64::INFINITY,
            false => 0.0,
        }
    }

    /// What holds at the lower (`end` = 0) or upper (1) wall across direction `axis`.
    fn wall(&self, axis: usize, end: usize, time: S) -> [Condition<S>; P] {
        let _ = (axis, end, time);
        [Condition::NoFlux; P]
    }
}

/// Heat with the same conductivity everywhere, between walls that let nothing through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heat<S> {
    /// `b`.
    pub diffusivity: S,
}

impl<S: Scalar, const D: usize> DiffusionProblem<S, D, 1> for Heat<S> {
    fn diffusivity(&self, _: &Place<S, D>) -> [S; 1] {
        [self.diffusivity]
    }
}
