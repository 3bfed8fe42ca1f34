//! Motion (3.10) and internal energy (3.12), in one sum over pairs.
//!
//! The sums are rates of momentum and energy, `m_k du_k/dt` and `m_k de_k/dt`: pair terms
//! carry both masses and are exactly opposite, so in fixed point the momentum rates of a
//! free cloud sum to 0.

use crate::cutoff::{CutOff, Needs, Parts, Widths};
use crate::domain::Wall;
use crate::pairs::{Law, Separation};
use crate::record;
use crate::scalar::{Number, Scalar};

use super::viscosity::{Pair, Viscosity};

record! {
    /// What a particle of gas shows.
    pub struct GasNode<N, const D: usize> {
        /// Mass `m`.
        pub mass: N,
        /// Measure μ: the mass, or 1.
        pub measure: N,
        /// `P = (p + q)/(Ω ν²)`.
        pub pressure: N,
        /// `σ ε^-(D+2)`: turns `F(q) r` into the gradient.
        pub gradient: N,
        /// The particle's part of the argument of the cut-off.
        pub scale: N,
        /// Sound speed `c`.
        pub sound_speed: N,
        /// Density ρ.
        pub density: N,
        /// ε.
        pub epsilon: N,
        /// Velocity `u`.
        pub velocity: [N; D],
    }
}

record! {
    /// What it receives.
    pub struct GasSums<N, const D: usize> {
        /// `Σ_l μ_l (u_k-u_l)·∇ζ_kl(ε_k) = -Ω_k ν_k div u`.
        pub compression: N,
        /// `1/2 Σ_l m_k m_l Π_kl (u_k-u_l)·g_kl`.
        pub heating: N,
        /// The fastest approach of a partner, along the line of centres; at least 0.
        pub approach: N,
        /// `m_k du_k/dt`.
        pub force: [N; D],
    }
}

/// (3.10) and (3.12).
#[derive(Clone, Copy, Debug)]
pub struct Motion<C, V> {
    /// The cut-off.
    pub cut_off: C,
    /// The pseudo-viscosity.
    pub viscosity: V,
}

impl<S: Scalar, C: CutOff, V: Viscosity<S>, const D: usize> Law<S, D> for Motion<C, V> {
    type Node = GasNode<S, D>;
    type Sums = GasSums<S, D>;
    type CutOff = C;
    const NEEDS: Needs = Needs {
        parts: Parts::Gradient,
        widths: Widths::Both,
        distance: true,
    };

    fn cut_off(&self) -> C {
        self.cut_off
    }
    #[inline(always)]
    fn scale<N: Number<Scalar = S>>(&self, node: &GasNode<N, D>) -> N {
        node.scale
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &GasNode<N, D>,
        l: &GasNode<N, D>,
        apart: &Separation<N, D>,
        to_k: &mut GasSums<N, D>,
        to_l: &mut GasSums<N, D>,
    ) {
        let Separation {
            r,
            distance_squared,
            zeta,
        } = apart;
        let g_k = k.gradient * zeta.k.gradient;
        let g_l = l.gradient * zeta.l.gradient;
        let g = N::literal(0.5) * (g_k + g_l);

        let mut u = [N::zero(); D];
        for i in 0..D {
            u[i] = k.velocity[i] - l.velocity[i];
        }
        let approach = N::dot(&u, r);
        // The floor is below any distance that matters; at r = 0 the approach is 0 too.
        let speed = approach / zeta.distance.max(N::literal(1.0 / 65536.0));
        let pi = self.viscosity.pair(&Pair {
            approach,
            distance_squared: *distance_squared,
            speed,
            sound_speeds: k.sound_speed + l.sound_speed,
            densities: k.density + l.density,
            epsilons: k.epsilon + l.epsilon,
            linear: N::literal(1.0),
            factor: N::literal(1.0),
        });

        let viscous = (k.mass * l.mass) * (pi * g);
        let measures = k.measure * l.measure;
        let term = measures * (k.pressure * g_k + l.pressure * g_l) + viscous;
        for i in 0..D {
            let force = term * r[i];
            to_k.force[i] -= force;
            to_l.force[i] += force;
        }
        to_k.compression += l.measure * (approach * g_k);
        to_l.compression += k.measure * (approach * g_l);
        let heating = N::literal(0.5) * (viscous * approach);
        to_k.heating += heating;
        to_l.heating += heating;

        // A pair out of reach has no say in the time step; its gradient is exactly 0.
        let closing = -speed * g.below(N::zero());
        to_k.approach = to_k.approach.max(closing);
        to_l.approach = to_l.approach.max(closing);
    }

    fn reflected(&self, node: &GasNode<S, D>, wall: &Wall<S>) -> GasNode<S, D> {
        let mut node = *node;
        if let Some(component) = node.velocity.get_mut(wall.axis) {
            *component = -*component;
        }
        node
    }
}
