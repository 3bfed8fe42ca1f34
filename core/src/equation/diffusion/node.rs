//! What the sums over pairs are made of.

use crate::pairs::Fields;
use crate::scalar::{Number, Scalar};

/// What a particle shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiffusionNode<N, const D: usize, const P: usize> {
    /// Weight `w`.
    pub weight: N,
    /// Position; only walls ask for it.
    pub position: [N; D],
    /// `u`.
    pub value: [N; P],
    /// `b`.
    pub diffusivity: [N; P],
}

/// What it receives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiffusionSums<N, const P: usize> {
    /// `ε² dq/dt`.
    pub rate: [N; P],
    /// Half of a bound of `ε² |λ|` by Gershgorin's circle of the particle, the largest of all
    /// species.
    pub radius: N,
    /// Particles within the support, itself among them.
    pub partners: N,
}

impl<S: Scalar, const D: usize, const P: usize> Fields<S> for DiffusionNode<S, D, P> {
    type Of<N: Number<Scalar = S>> = DiffusionNode<N, D, P>;
    const ZERO: Self = Self {
        weight: S::ZERO,
        position: [S::ZERO; D],
        value: [S::ZERO; P],
        diffusivity: [S::ZERO; P],
    };

    #[inline(always)]
    fn splat<N: Number<Scalar = S>>(&self) -> DiffusionNode<N, D, P> {
        DiffusionNode {
            weight: N::splat(self.weight),
            position: self.position.map(N::splat),
            value: self.value.map(N::splat),
            diffusivity: self.diffusivity.map(N::splat),
        }
    }
    #[inline(always)]
    fn gather<'a, N: Number<Scalar = S>>(
        records: impl Iterator<Item = &'a Self>,
    ) -> DiffusionNode<N, D, P>
    where
        Self: 'a,
    {
        let mut of = Self::ZERO.splat::<N>();
        for (i, record) in records.take(N::LANES).enumerate() {
            of.weight.set_lane(i, record.weight);
            for j in 0..D {
                of.position[j].set_lane(i, record.position[j]);
            }
            for j in 0..P {
                of.value[j].set_lane(i, record.value[j]);
                of.diffusivity[j].set_lane(i, record.diffusivity[j]);
            }
        }
        of
    }
    #[inline(always)]
    fn lane<N: Number<Scalar = S>>(of: &DiffusionNode<N, D, P>, i: usize) -> Self {
        Self {
            weight: of.weight.lane(i),
            position: core::array::from_fn(|j| of.position[j].lane(i)),
            value: core::array::from_fn(|j| of.value[j].lane(i)),
            diffusivity: core::array::from_fn(|j| of.diffusivity[j].lane(i)),
        }
    }
}

impl<S: Scalar, const P: usize> Fields<S> for DiffusionSums<S, P> {
    type Of<N: Number<Scalar = S>> = DiffusionSums<N, P>;
    const ZERO: Self = Self {
        rate: [S::ZERO; P],
        radius: S::ZERO,
        partners: S::ZERO,
    };

    #[inline(always)]
    fn splat<N: Number<Scalar = S>>(&self) -> DiffusionSums<N, P> {
        DiffusionSums {
            rate: self.rate.map(N::splat),
            radius: N::splat(self.radius),
            partners: N::splat(self.partners),
        }
    }
    #[inline(always)]
    fn gather<'a, N: Number<Scalar = S>>(
        records: impl Iterator<Item = &'a Self>,
    ) -> DiffusionSums<N, P>
    where
        Self: 'a,
    {
        let mut of = Self::ZERO.splat::<N>();
        for (i, record) in records.take(N::LANES).enumerate() {
            of.radius.set_lane(i, record.radius);
            of.partners.set_lane(i, record.partners);
            for j in 0..P {
                of.rate[j].set_lane(i, record.rate[j]);
            }
        }
        of
    }
    #[inline(always)]
    fn lane<N: Number<Scalar = S>>(of: &DiffusionSums<N, P>, i: usize) -> Self {
        Self {
            rate: core::array::from_fn(|j| of.rate[j].lane(i)),
            radius: of.radius.lane(i),
            partners: of.partners.lane(i),
        }
    }
}
