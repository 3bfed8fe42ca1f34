//! What stands for the diffusivity between two particles.

use crate::scalar::{Number, Scalar};

/// What the direct form takes for `b` between two particles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mean {
    /// `(b_k + b_l)/2`, as (4.6) has it: second order where `b` is smooth.
    #[default]
    Arithmetic,
    /// `2 b_k b_l/(b_k + b_l)`, two resistances in a row: for jumps of `b` (Cleary & Monaghan, J.
    /// Comput. Phys. 148, 1999, 227). One division a pair. Where layers lie between two particles,
    /// [`between`](super::DiffusionProblem::between) says, all of their resistances.
    Harmonic,
}

impl Mean {
    /// Twice the mean: the same bits from either side.
    #[inline(always)]
    pub(super) fn twice<N: Number>(self, k: N, l: N) -> N {
        let sum = k + l;
        match self {
            Self::Arithmetic => sum,
            Self::Harmonic => {
                // At most 1, also where it is bounded for all `k` and `l` at once.
                let part = k.max(l) / sum.max(N::splat(N::Scalar::TINIEST));
                let part = part.min(N::literal(1.0));
                let product = k.min(l) * part;
                (product + product) + (product + product)
            }
        }
    }
}
