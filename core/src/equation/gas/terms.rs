//! What a gas may do beyond the paper's equations, as the sums over pairs see it.

use crate::neighbours::Image;
use crate::pairs::Fields;
use crate::pairs::Nothing;
use crate::scalar::{Number, Scalar};

use super::node::GasNode;
use super::options::Plain;
use super::viscosity::{Pair, Viscosity};
use super::walls::Reversal;

/// Two particles of gas as the terms of a pair see them.
pub struct Between<N, const D: usize> {
    /// `r = x_k - x_l`.
    pub r: [N; D],
    /// `u_k - u_l`.
    pub u: [N; D],
    /// `|r|²`.
    pub distance_squared: N,
    /// `|r|`.
    pub distance: N,
    /// `|r|`, at least a distance below any that matters.
    pub floored: N,
    /// `(u_k - u_l)·r`.
    pub approach: N,
    /// The same over `floored`.
    pub speed: N,
}

/// What the viscous stresses of a pair act on.
pub struct Sheared<'a, N, const D: usize> {
    /// `u_k - u_l` as they see it.
    pub u: [N; D],
    /// `μ_k μ_l` times the factors of the gradients of `k` and of `l`.
    pub factors: [N; 2],
    /// How `l` is seen where it is an image in a wall that the gas sticks to.
    pub seen: Option<&'a Reversal<N, D>>,
}

/// The node of a gas with these terms.
pub type NodeOf<S, T, const D: usize> = GasNode<S, <T as Terms<S, D>>::Shown, D>;
/// The same over any number.
pub type NodeOver<N, S, T, const D: usize> =
    GasNode<N, <<T as Terms<S, D>>::Shown as Fields<S>>::Of<N>, D>;

/// The terms of a pair beyond pressure: pseudo-viscosity at the least.
///
/// A term that is off must leave every sum as it is, to the last bit.
pub trait Terms<S: Scalar, const D: usize>: Copy + Sync {
    /// What they need to know of a particle; [`Nothing`] where the paper's equations suffice.
    type Shown: Fields<S>;

    /// Π of a pair.
    fn stress<N: Number<Scalar = S>, V: Viscosity<S>>(
        &self,
        viscosity: &V,
        k: &NodeOver<N, S, Self, D>,
        l: &NodeOver<N, S, Self, D>,
        between: &Between<N, D>,
    ) -> N;

    /// The heat that `k` receives and `l` gives in a unit of time; `coupling` is `m_k m_l g`.
    #[inline(always)]
    fn heat<N: Number<Scalar = S>>(
        &self,
        k: &NodeOver<N, S, Self, D>,
        l: &NodeOver<N, S, Self, D>,
        between: &Between<N, D>,
        coupling: N,
    ) -> N {
        let _ = (k, l, between, coupling);
        N::zero()
    }

    /// What the viscous stresses of `k` and of `l` exert between the two: `k` receives minus the sum of
    /// both as force, and each turns its own times `u_k - u_l` into heat. `None` without such a stress.
    #[inline(always)]
    fn drag<N: Number<Scalar = S>>(
        &self,
        k: &NodeOver<N, S, Self, D>,
        l: &NodeOver<N, S, Self, D>,
        r: &[N; D],
        sheared: &Sheared<'_, N, D>,
    ) -> Option<[[N; D]; 2]> {
        let _ = (k, l, r, sheared);
        None
    }

    /// How the viscous stress sees an image otherwise than a mirror shows it; `None` where it does not.
    #[inline(always)]
    fn seen<N: Number<Scalar = S>>(&self, image: &Image<D>) -> Option<Reversal<N, D>> {
        let _ = image;
        None
    }

    /// What the gradients of `k` and of `l` point along, `B_k r` and `B_l r`; `None` where both are r.
    #[inline(always)]
    fn directions<N: Number<Scalar = S>>(
        &self,
        k: &NodeOver<N, S, Self, D>,
        l: &NodeOver<N, S, Self, D>,
        r: &[N; D],
    ) -> Option<[[N; D]; 2]> {
        let _ = (k, l, r);
        None
    }

    /// Whether pressure and pseudo-viscosity are all that a pair exchanges, as far as a proof by their
    /// bounds can tell; else each pair is proven by itself.
    fn is_bounded(&self) -> bool {
        true
    }

    /// What is shown behind a wall across direction `axis`.
    fn reflected(shown: &Self::Shown, axis: usize) -> Self::Shown {
        let _ = axis;
        *shown
    }
}

impl<S: Scalar, const D: usize> Terms<S, D> for Plain<S, D> {
    type Shown = Nothing;

    #[inline(always)]
    fn stress<N: Number<Scalar = S>, V: Viscosity<S>>(
        &self,
        viscosity: &V,
        k: &NodeOver<N, S, Self, D>,
        l: &NodeOver<N, S, Self, D>,
        between: &Between<N, D>,
    ) -> N {
        viscosity.pair(&Pair {
            approach: between.approach,
            distance_squared: between.distance_squared,
            speed: between.speed,
            sound_speeds: k.sound_speed + l.sound_speed,
            densities: k.density + l.density,
            epsilons: k.epsilon + l.epsilon,
            linear: N::literal(1.0),
            factor: N::literal(1.0),
        })
    }
}
