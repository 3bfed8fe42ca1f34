//! The mixed form (4.3): the flux of each particle, then its divergence.

use crate::cutoff::{CutOff, Needs, Parts, Widths};
use crate::domain::Wall;
use crate::error::{Error, Quantity};
use crate::numbered::numbered;
use crate::pairs::{Ground, Law, Separation, by_intervals};
use crate::record;
use crate::scalar::{Number, Scalar};

use super::direct::{imaged, prove_walls};
use super::node::{DiffusionNode, DiffusionSums};
use super::wall::{Condition, Walls, end_of};

record! {
    /// What a particle shows in the second pass: also its flux.
    pub struct MixedNode<N, const D: usize, const P: usize> {
        /// As in the first pass.
        pub node: DiffusionNode<N, D, P>,
        /// `ε p = -ε b ∇u` of each species.
        pub flux: [[N; D]; P],
    }
}

record! {
    /// `Σ_l w_l (u_l - u_k) ε ∇ζ_kl`, and partners.
    pub struct FluxSums<N, const D: usize, const P: usize> {
        /// Of each species.
        pub slope: [[N; D]; P],
        /// Particles within the support, itself among them.
        pub partners: N,
    }
}

/// The first pass of (4.3): `p_k = -b_k Σ_l w_l (u_l - u_k) ∇ζ_kl`.
#[derive(Clone, Copy, Debug)]
pub struct Flux<S, C, const D: usize, const P: usize> {
    /// ζ.
    pub cut_off: C,
    /// `1/ε`.
    pub inverse_epsilon: S,
    /// What turns `|r|` into the argument of the cut-off.
    pub scale: S,
    /// `σ ε^-D`.
    pub height: S,
    /// What holds at the walls, by direction and end.
    pub walls: Walls<S, D, P>,
}

/// The second pass: `dq_k/dt = -Σ_l w_k w_l (p_k + p_l)·∇ζ_kl`, and a share of the direct form.
///
/// Differs from the paper: beside a wall that holds a value, the odd image of a source, or of the
/// flux of another wall, jumps from one side to the other. That jump has waves of two spacings in
/// it, which the mixed form feeds and does not damp: they would grow as long as the source lasts.
/// A share γ of (4.6) damps them, `γ direct + (1 - γ) mixed`, both of which are consistent. The
/// fluxes are `1 - γ` times theirs.
#[derive(Clone, Copy, Debug)]
pub struct Divergence<S, C, const D: usize, const P: usize> {
    /// The first pass.
    pub first: Flux<S, C, D, P>,
    /// `γ`; 0 for (4.3) as it is.
    pub share: S,
}

/// γ where a wall holds a value: waves of two spacings then fall as a fourth of what the direct form
/// makes of them.
const SHARE: f64 = 0.25;

impl<S: Scalar, C: CutOff, const D: usize, const P: usize> Flux<S, C, D, P> {
    /// γ under these walls.
    pub(super) fn share(&self) -> S {
        let mut conditions = self.walls.iter().flatten().flatten();
        match conditions.any(|condition| matches!(condition, Condition::Value(_))) {
            true => S::from_f64(SHARE),
            false => S::ZERO,
        }
    }
}

impl<S: Scalar, C: CutOff, const D: usize, const P: usize> Flux<S, C, D, P> {
    /// The factor of `n = r/ε` in `ε ∇ζ_kl`.
    ///
    /// Laws multiply all scalars before they turn to vectors: the order in which the compiler works on
    /// all lanes at once (three times as fast).
    #[inline(always)]
    pub(super) fn factor<N: Number<Scalar = S>>(&self, apart: &Separation<N, D>) -> N {
        N::splat(self.height) * apart.zeta.k.gradient
    }
}

impl<S: Scalar, C: CutOff, const D: usize, const P: usize> Law<S, D> for Flux<S, C, D, P> {
    type Node = DiffusionNode<S, D, P>;
    type Sums = FluxSums<S, D, P>;
    type CutOff = C;
    const NEEDS: Needs = Needs {
        parts: Parts::Gradient,
        widths: Widths::Equal,
        distance: false,
    };
    const MAKES: Quantity = Quantity::Rate;

    fn cut_off(&self) -> C {
        self.cut_off
    }
    #[inline(always)]
    fn scale<N: Number<Scalar = S>>(&self, _: &DiffusionNode<N, D, P>) -> N {
        N::splat(self.scale)
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &DiffusionNode<N, D, P>,
        l: &DiffusionNode<N, D, P>,
        apart: &Separation<N, D>,
        to_k: &mut FluxSums<N, D, P>,
        to_l: &mut FluxSums<N, D, P>,
    ) {
        let (factor, near) = (self.factor(apart), apart.zeta.k.within);
        let r = &apart.r;
        for j in 0..P {
            let difference = factor * (l.value[j] - k.value[j]);
            let (term_k, term_l) = (l.weight * difference, k.weight * difference);
            for i in 0..D {
                let n = r[i] * N::splat(self.inverse_epsilon);
                // Both signs change from the other side: the slope is the same.
                to_k.slope[j][i] += term_k * n;
                to_l.slope[j][i] += term_l * n;
            }
        }
        to_k.partners += near;
        to_l.partners += near;
    }

    fn proof(&self, ground: &Ground<'_, '_, S, D>, nodes: &[Self::Node]) -> Result<(), Error> {
        prove_walls(&self.walls, ground, nodes)?;
        by_intervals(self, ground, nodes)
    }

    fn reflected(&self, node: &DiffusionNode<S, D, P>, wall: &Wall<S>) -> DiffusionNode<S, D, P> {
        imaged(node, wall, &self.walls)
    }
}

impl<S: Scalar, C: CutOff, const D: usize, const P: usize> Law<S, D> for Divergence<S, C, D, P> {
    type Node = MixedNode<S, D, P>;
    type Sums = DiffusionSums<S, P>;
    type CutOff = C;
    const NEEDS: Needs = Needs {
        parts: Parts::Gradient,
        widths: Widths::Equal,
        distance: false,
    };
    const MAKES: Quantity = Quantity::Rate;

    fn cut_off(&self) -> C {
        self.first.cut_off
    }
    #[inline(always)]
    fn scale<N: Number<Scalar = S>>(&self, _: &MixedNode<N, D, P>) -> N {
        N::splat(self.first.scale)
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &MixedNode<N, D, P>,
        l: &MixedNode<N, D, P>,
        apart: &Separation<N, D>,
        to_k: &mut DiffusionSums<N, P>,
        to_l: &mut DiffusionSums<N, P>,
    ) {
        let (shape, r) = (self.first.factor(apart), &apart.r);
        let mut n = *r;
        for i in 0..D {
            n[i] = r[i] * N::splat(self.first.inverse_epsilon);
        }
        let factor = (k.node.weight * l.node.weight) * shape;
        for j in 0..P {
            let mut sum = n;
            for i in 0..D {
                sum[i] = k.flux[j][i] + l.flux[j][i];
            }
            let term = factor * N::dot(&sum, &n);
            to_k.rate[j] -= term;
            to_l.rate[j] += term;
        }
        if self.share == S::ZERO {
            return;
        }
        let mut largest = N::zero();
        for j in 0..P {
            let b = N::splat(self.share) * (k.node.diffusivity[j] + l.node.diffusivity[j]);
            let term = factor * (b * (l.node.value[j] - k.node.value[j]));
            to_k.rate[j] -= term;
            to_l.rate[j] += term;
            largest = largest.max(b);
        }
        let size = shape.max(-shape) * largest;
        to_k.radius += l.node.weight * size;
        to_l.radius += k.node.weight * size;
    }

    /// The image in a closed wall: what goes through one comes on top, and is counted.
    fn reflected(&self, node: &MixedNode<S, D, P>, wall: &Wall<S>) -> MixedNode<S, D, P> {
        let mut image = *node;
        for flux in &mut image.flux {
            if let Some(component) = flux.get_mut(wall.axis) {
                *component = -*component;
            }
        }
        image
    }
}

impl<S: Scalar, C: CutOff, const D: usize, const P: usize> Divergence<S, C, D, P> {
    /// The image in a wall under these conditions.
    pub(super) fn behind(
        &self,
        node: &MixedNode<S, D, P>,
        wall: &Wall<S>,
        walls: &Walls<S, D, P>,
    ) -> MixedNode<S, D, P> {
        let mut image = MixedNode {
            node: imaged(&node.node, wall, walls),
            flux: node.flux,
        };
        let Some(conditions) = end_of(walls, wall) else {
            return image;
        };
        // Fluxes are ε times theirs, and conditions count outwards.
        let epsilon = S::ONE / self.first.inverse_epsilon;
        let values = image.node.value.iter_mut().zip(&node.node.value);
        for ((seen, &u), condition) in values.zip(conditions) {
            // What is exchanged each particle pays by itself.
            if let Condition::Exchange { .. } = condition {
                *seen = u;
            }
        }
        // What passes through a wall is shared out as the fluxes are.
        let epsilon = epsilon * (S::ONE - self.share);
        for (flux, condition) in image.flux.iter_mut().zip(conditions) {
            // Behind a held value `2 g - u` falls along the wall where u rises.
            if let Condition::Value(_) = condition {
                let along = numbered(flux.iter_mut());
                along
                    .filter(|(i, _)| *i != wall.axis)
                    .for_each(|(_, component)| *component = -*component);
            }
            if let Some(component) = flux.get_mut(wall.axis) {
                let outwards = if wall.end == 0 {
                    -*component
                } else {
                    *component
                };
                let seen = condition.flux_image(outwards, epsilon);
                *component = if wall.end == 0 { -seen } else { seen };
            }
        }
        image
    }
}
