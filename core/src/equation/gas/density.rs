//! Density (3.13), with the width of the cut-off tied to it.
//!
//! `ν_k = Σ_l μ_l ζ_ε_k(x_k - x_l)`, `l = k` included, and `ε_k = η (μ_k/ν_k)^(1/D)`. The
//! *measure* μ is the mass (3.13), and ν then the density ρ; or it is 1, and ν a density of
//! particles: see [`Weights`](super::Weights).
//!
//! Differs from the paper: the particle's own term is such that a lattice has its density. A sum over
//! its points is not the integral of the cut-off, so `ν_k` is less by `δ μ_k ζ_ε_k(0)`, and
//! `δ z(0) = T - η^D/σ` with `T = Σ_n z(|n|/η)` over the points of a lattice of spacing 1: see
//! [`Packing`] (after Dehnen & Aly, MNRAS 425, 1068, 2012, section 2.5, who fit δ to glasses). Only
//! where ε is adaptive; with one ε for all the spacing is not known.
//!
//! With `S(λ) = Σ_l μ_l z(|r|/ε)`, `λ = ln ε`, the two say `S(λ_k) = μ_k T`: one equation
//! in one unknown, without a root. Its derivatives are sums over the same pairs,
//!
//! `S' = -Σ μ q z'`, `S'' = Σ μ (q z' + q² z'')`,
//!
//! and a second-order step `δ = d - (S''/2S') d²`, `d = (μ T - S)/S'`, ends in
//! `ε e^δ`, `ν = μ (η/ε)^D` and
//!
//! `Ω = 1 + ε/(D ν) ∂ν/∂ε = σ S'/(D μ η^D)`.
//!
//! A step below [`Scalar::EXTRAPOLATION`] is the last one: what it leaves out is then of the
//! order of the format's rounding (ε), or of the square of the step (Ω). Each particle
//! iterates on its own, so the bits do not depend on who shares its loop.

use crate::cutoff::{CutOff, Needs, Parts, Shape, Widths};
use crate::error::Error;
use crate::pairs::{Ground, Law, Separation};
use crate::record;
use crate::scalar::{Number, Scalar};

use super::packing::Packing;

/// How wide the cut-off of a particle is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Width<S> {
    /// The same ε everywhere: the paper's.
    Constant {
        /// ε, a length.
        epsilon: S,
    },
    /// `ε_k = η (μ_k/ν_k)^(1/D)`, `η (m_k/ρ_k)^(1/D)` for weights by mass: about the same number of neighbours everywhere.
    Adaptive {
        /// η, in spacings.
        eta: S,
        /// The lattice that has its density.
        packing: Packing,
    },
}

impl<S> Width<S> {
    /// Adaptive, with the density of a cubic lattice.
    pub const fn adaptive(eta: S) -> Self {
        Self::Adaptive {
            eta,
            packing: Packing::Cubic,
        }
    }
}

record! {
    /// What the density sum knows of a particle.
    pub struct DensityNode<N, const D: usize> {
        /// Measure μ.
        pub measure: N,
        /// The particle's part of the argument of the cut-off.
        pub scale: N,
        /// ε; where [`Law::close`] leaves it above `limit`, the cloud must be sorted anew.
        pub epsilon: N,
        /// The largest ε for which the neighbours at hand are all there are.
        pub limit: N,
        /// The largest ε seen whose sum was too small.
        pub low: N,
        /// The smallest ε seen whose sum was too large.
        pub high: N,
        /// ν, when settled.
        pub density: N,
        /// Ω, when settled.
        pub omega: N,
        /// Passes made so far.
        pub passes: N,
    }
}

record! {
    /// The sums of one pass.
    pub struct DensitySums<N, const D: usize> {
        /// `S = Σ μ z`.
        pub value: N,
        /// `Σ μ |r|² F`, `ε²` times `Σ μ q z'`.
        pub first: N,
        /// `Σ μ |r|² (F + z'')`, `ε²` times `S''`.
        pub second: N,
        /// Partners within the support, the particle itself among them.
        pub partners: N,
    }
}

/// Passes after which the iteration for ε is given up.
pub const MAX_PASSES: u32 = 32;

/// By how much ε may grow before the cloud must be sorted anew.
pub const GROWTH: f64 = 1.0 / 32.0;

/// (3.13).
#[derive(Clone, Copy, Debug)]
pub struct Density<S, C, const D: usize> {
    cut_off: C,
    width: Width<S>,
    /// `σ`.
    sigma: S,
    /// `η^D/σ`.
    target: S,
    /// `T`.
    lattice: S,
}

impl<S: Scalar, C: CutOff, const D: usize> Density<S, C, D> {
    /// The law for a cut-off and a rule for its width.
    pub fn new(cut_off: C, width: Width<S>) -> Self {
        let sigma = S::from_f64(cut_off.normalisation::<D>());
        let (target, lattice) = match width {
            Width::Constant { .. } => (S::ONE, S::ONE),
            Width::Adaptive { eta, packing } => {
                (eta.powi(D) / sigma, packing.sum::<S, C, D>(cut_off, eta))
            }
        };
        Self {
            cut_off,
            width,
            sigma,
            target,
            lattice,
        }
    }

    /// The node of a particle whose ε is expected to be `epsilon`.
    pub fn node(&self, measure: S, epsilon: S) -> DensityNode<S, D> {
        let (epsilon, limit) = match self.width {
            Width::Constant { epsilon } => (epsilon, epsilon),
            Width::Adaptive { .. } => (epsilon, self.limit(epsilon)),
        };
        DensityNode {
            measure,
            scale: self.cut_off.scale(S::ONE / epsilon),
            epsilon,
            limit,
            low: S::ZERO,
            high: S::REACH_LIMIT,
            density: S::ZERO,
            omega: S::ONE,
            passes: S::ZERO,
        }
    }

    /// The largest ε that may come out where `epsilon` is expected.
    pub fn limit(&self, epsilon: S) -> S {
        match self.width {
            Width::Constant { epsilon } => epsilon,
            Width::Adaptive { .. } => epsilon + epsilon * S::from_f64(GROWTH),
        }
    }

    /// The term of a partner of that measure, seen at a particle's own width.
    #[inline(always)]
    fn term<N: Number<Scalar = S>>(
        zeta: &Shape<N>,
        measure: N,
        distance_squared: N,
        to: &mut DensitySums<N, D>,
    ) {
        let spread = measure * distance_squared;
        to.value += measure * zeta.value;
        to.first += spread * zeta.gradient;
        to.second += spread * (zeta.gradient + zeta.curvature);
        to.partners += zeta.within;
    }

    /// One step of the iteration; `true` when the node holds the result, or needs other
    /// neighbours, or has used up its passes.
    fn adapt(&self, eta: S, node: &mut DensityNode<S, D>, sums: &DensitySums<S, D>) -> bool {
        let inverse = S::ONE / node.epsilon;
        let target = node.measure * self.target;
        let slope = -(sums.first * inverse * inverse);
        let second = sums.second * inverse * inverse;
        let missing = node.measure * self.lattice - sums.value;
        let delta = self.step(node, missing, slope, second);
        node.epsilon += node.epsilon * (delta + (delta * delta).half());
        node.passes += S::ONE;
        if node.epsilon > node.limit {
            return true;
        }
        if !(delta.abs() > S::EXTRAPOLATION) {
            node.density = node.measure * (eta / node.epsilon).powi(D);
            node.omega = (slope + delta * second) / (S::count(D as u32) * target);
            return true;
        }
        node.scale = self.cut_off.scale(S::ONE / node.epsilon);
        !(node.passes < S::count(MAX_PASSES))
    }

    /// The step in ln ε: of second order, at most 1/4, and within what earlier passes have
    /// bracketed, else to the middle of it. `S` rises with ε, so the bracket always closes.
    fn step(&self, node: &mut DensityNode<S, D>, missing: S, slope: S, second: S) -> S {
        if missing > S::ZERO {
            node.low = node.epsilon;
        } else {
            node.high = node.epsilon;
        }
        let largest = S::from_f64(0.25);
        let bounded = |delta: S| delta.greater(-largest).lesser(largest);
        let delta = if slope > node.measure * self.target * S::from_f64(1.0 / 64.0) {
            let d = bounded(missing / slope);
            // At most half of d, or the two could cancel far from the solution.
            let correction = (second / slope * d * d).half();
            let most = d.abs().half();
            bounded(d - correction.greater(-most).lesser(most))
        } else {
            // No neighbour to speak of: widen.
            largest
        };
        let there = node.epsilon + node.epsilon * (delta + (delta * delta).half());
        let settled = !(delta.abs() > S::EXTRAPOLATION);
        if settled || there > node.low && there < node.high {
            delta
        } else {
            let middle = node.low.half() + node.high.half();
            bounded((middle - node.epsilon) / node.epsilon)
        }
    }
}

impl<S: Scalar, C: CutOff, const D: usize> Law<S, D> for Density<S, C, D> {
    type Node = DensityNode<S, D>;
    type Sums = DensitySums<S, D>;
    type CutOff = C;
    const NEEDS: Needs = Needs {
        parts: Parts::All,
        widths: Widths::Own,
        distance: false,
    };

    fn cut_off(&self) -> C {
        self.cut_off
    }
    #[inline(always)]
    fn scale<N: Number<Scalar = S>>(&self, node: &DensityNode<N, D>) -> N {
        node.scale
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &DensityNode<N, D>,
        l: &DensityNode<N, D>,
        apart: &Separation<N, D>,
        to_k: &mut DensitySums<N, D>,
        to_l: &mut DensitySums<N, D>,
    ) {
        let (zeta, squared) = (&apart.zeta, apart.distance_squared);
        Self::term(&zeta.k, l.measure, squared, to_k);
        Self::term(&zeta.l, k.measure, squared, to_l);
    }

    fn proof(&self, ground: &Ground<'_, '_, S, D>, nodes: &[Self::Node]) -> Result<(), Error> {
        self.prove(ground, nodes)
    }

    fn close(&self, node: &mut DensityNode<S, D>, sums: &DensitySums<S, D>) -> bool {
        match self.width {
            Width::Constant { epsilon } => {
                node.density = self.sigma * sums.value * (S::ONE / epsilon).powi(D);
                true
            }
            Width::Adaptive { eta, .. } => self.adapt(eta, node, sums),
        }
    }
}
