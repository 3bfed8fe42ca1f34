//! The pair term of (1.18).

use crate::cutoff::{CutOff, Needs, Parts, Widths};
use crate::domain::Wall;
use crate::error::Quantity;
use crate::pairs::{Fields, Law, Separation};
use crate::record;
use crate::scalar::{Number, Scalar};

use super::system::FirstOrderSystem;

record! {
    /// What a particle shows: over a number `N`, with the medium `M`.
    pub struct SystemNode<N, M, const D: usize, const P: usize> {
        /// Weight `w`.
        pub weight: N,
        /// `v - a`: how fast the state moves through the particles.
        pub drift: [N; D],
        /// `u`.
        pub value: [N; P],
        /// What the coupling needs to know of the place.
        pub medium: M,
    }
}

record! {
    /// What it receives.
    pub struct SystemSums<N, const P: usize> {
        /// `ε dq/dt` of the pairs.
        pub rate: [N; P],
        /// Particles within the support, itself among them.
        pub partners: N,
    }
}

/// (1.18) with one ε: `ε d(w_k u_k)/dt = - Σ_l w_k w_l ε Σ_i (B_k^i u_l + B_l^i u_k) ∂_i ζ_ε`.
///
/// With `n = r/ε` the gradient is `ε ∇ζ_ε = σ ε^-D F(q) n`, and
/// `Σ_i n_i (B_k^i u_l + B_l^i u_k) = Σ_i n_i (C_k^i u_l + C_l^i u_k) + (d_k·n) u_l + (d_l·n) u_k`,
/// `d = v - a`. Every factor but `n` is the same seen from either side, so what `l` receives is
/// the exact negative of what `k` does.
#[derive(Clone, Copy, Debug)]
pub struct Coupling<'a, S, C, F, const P: usize> {
    /// The system.
    pub system: &'a F,
    /// ζ.
    pub cut_off: C,
    /// `1/ε`.
    pub inverse_epsilon: S,
    /// What turns `|r|` into the argument of the cut-off.
    pub scale: S,
    /// `σ ε^-D`.
    pub height: S,
}

impl<'a, S: Scalar, C: CutOff, F, const P: usize> Coupling<'a, S, C, F, P> {
    /// The law of a system with that cut-off and width, in `D` dimensions.
    pub fn new<const D: usize>(system: &'a F, cut_off: C, epsilon: S) -> Self {
        let inverse_epsilon = S::ONE / epsilon;
        Self {
            system,
            cut_off,
            inverse_epsilon,
            scale: cut_off.scale(inverse_epsilon),
            height: S::from_f64(cut_off.normalisation::<D>()) / epsilon.powi(D),
        }
    }
}

impl<S, C, F, const D: usize, const P: usize> Law<S, D> for Coupling<'_, S, C, F, P>
where
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, D, P>,
{
    type Node = SystemNode<S, F::Medium, D, P>;
    type Sums = SystemSums<S, P>;
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
    fn scale<N: Number<Scalar = S>>(&self, _: &<Self::Node as Fields<S>>::Of<N>) -> N {
        N::splat(self.scale)
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &<Self::Node as Fields<S>>::Of<N>,
        l: &<Self::Node as Fields<S>>::Of<N>,
        apart: &Separation<N, D>,
        to_k: &mut SystemSums<N, P>,
        to_l: &mut SystemSums<N, P>,
    ) {
        let Separation { r, zeta, .. } = apart;
        let gradient = N::splat(self.height) * zeta.k.gradient;
        let factor = (k.weight * l.weight) * gradient;
        let mut n = *r;
        for i in 0..D {
            n[i] = r[i] * N::splat(self.inverse_epsilon);
        }
        let flux = if F::IS_UNIFORM {
            let mut sum = k.value;
            for j in 0..P {
                sum[j] = k.value[j] + l.value[j];
            }
            self.system.flux(&k.medium, &n, &sum)
        } else {
            let there = self.system.flux(&k.medium, &n, &l.value);
            let mut sum = self.system.flux(&l.medium, &n, &k.value);
            for j in 0..P {
                sum[j] += there[j];
            }
            sum
        };
        let from_k = N::dot(&k.drift, &n);
        let from_l = N::dot(&l.drift, &n);
        for j in 0..P {
            let carried = from_k * l.value[j] + from_l * k.value[j];
            let term = factor * (flux[j] + carried);
            to_k.rate[j] -= term;
            to_l.rate[j] += term;
        }
        to_k.partners += zeta.k.within;
        to_l.partners += zeta.k.within;
    }

    fn reflected(&self, node: &Self::Node, wall: &Wall<S>) -> Self::Node {
        let mut drift = node.drift;
        if let Some(component) = drift.get_mut(wall.axis) {
            *component = -*component;
        }
        let image = self.system.reflected(&node.value, wall.axis);
        SystemNode {
            weight: node.weight,
            drift,
            value: self.system.behind(&node.medium, &image, wall),
            medium: self.system.reflected_medium(&node.medium, wall.axis),
        }
    }
}
