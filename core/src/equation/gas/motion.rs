//! Motion (3.10) and internal energy (3.12), in one sum over pairs.
//!
//! The sums are rates of momentum and energy, `m_k du_k/dt` and `m_k de_k/dt`: pair terms
//! carry both masses and are exactly opposite, so in fixed point the momentum rates of a
//! free cloud sum to 0.
//!
//! The law is the same whatever goes beyond the paper: that enters through [`Terms`], and a term
//! that is off changes no bit.

use crate::cutoff::{CutOff, Needs, Parts, Widths};
use crate::domain::Wall;
use crate::error::Error;
use crate::neighbours::Image;
use crate::pairs::{Ground, Law, Separation, by_pairs};
use crate::scalar::{Number, Scalar};

use super::terms::{Between, NodeOf, NodeOver, Sheared, Terms};
use super::viscosity::Viscosity;
use super::walls::{Reversal, apart_as};

pub use super::node::{GasNode, GasSums};

/// (3.10) and (3.12).
#[derive(Clone, Copy, Debug)]
pub struct Motion<C, V, T> {
    /// The cut-off.
    pub cut_off: C,
    /// The pseudo-viscosity.
    pub viscosity: V,
    /// What goes beyond the paper.
    pub terms: T,
}

/// What a pair exchanges, over `r`.
pub(super) struct Exchanged<N, const D: usize> {
    /// `μ_k μ_l P_k` times the factor of the gradient of `k`.
    pub pressure_k: N,
    /// `μ_k μ_l P_l` times that of `l`.
    pub pressure_l: N,
    /// `m_k m_l Π` times the mean of both.
    pub viscous: N,
    /// What `k` receives as heat and `l` gives.
    pub heat: N,
    /// What the gradients point along where that is not r: see [`Terms::directions`].
    pub directions: Option<[[N; D]; 2]>,
    /// What the viscous stresses of both exert: see [`Terms::drag`].
    pub drag: Option<[[N; D]; 2]>,
    /// `u_k - u_l` as the viscous stresses see it, of the velocities that forces depend on.
    pub u: [N; D],
    /// `Σ_i (u_k-u_l)_i r_i`, of the velocities that forces depend on.
    pub approach: N,
    /// `(u_k-u_l)` times the direction of the gradient of `k`, and of `l`.
    pub along: [N; 2],
    /// The approach over the distance.
    pub speed: N,
    /// The factors of the gradients: of `k`, of `l`, and their mean.
    pub gradients: [N; 3],
}

/// A distance below any that matters.
const TINY: f64 = 1.0 / 65536.0;

impl<C, V, T> Motion<C, V, T> {
    /// What a pair exchanges.
    #[inline(always)]
    pub(super) fn exchanged<S, N, const D: usize>(
        &self,
        k: &NodeOver<N, S, T, D>,
        l: &NodeOver<N, S, T, D>,
        apart: &Separation<N, D>,
        seen: Option<&Reversal<N, D>>,
    ) -> Exchanged<N, D>
    where
        S: Scalar,
        N: Number<Scalar = S>,
        V: Viscosity<S>,
        T: Terms<S, D>,
    {
        let Separation { r, zeta, .. } = apart;
        let g_k = k.gradient * zeta.k.gradient;
        let g_l = l.gradient * zeta.l.gradient;
        let g = N::literal(0.5) * (g_k + g_l);
        let mut u = [N::zero(); D];
        for i in 0..D {
            u[i] = k.velocity[i] - l.velocity[i];
        }
        // At r = 0 the approach is 0 too.
        let approach = N::dot(&u, r);
        let floored = zeta.distance.max(N::literal(TINY));
        let between = Between {
            r: *r,
            u,
            distance_squared: apart.distance_squared,
            distance: zeta.distance,
            floored,
            approach,
            speed: approach / floored,
        };
        let pi = self.terms.stress(&self.viscosity, k, l, &between);
        let masses = k.mass * l.mass;
        let measures = k.measure * l.measure;
        let sheared = Sheared {
            u: match seen {
                None => u,
                Some(_) => apart_as(seen, &k.velocity, &l.velocity),
            },
            factors: [measures * g_k, measures * g_l],
            seen,
        };
        let directions = self.terms.directions(k, l, r);
        Exchanged {
            pressure_k: measures * (k.pressure * g_k),
            pressure_l: measures * (l.pressure * g_l),
            viscous: masses * (pi * g),
            heat: self.terms.heat(k, l, &between, masses * g),
            along: match &directions {
                None => [approach; 2],
                Some(directions) => [0, 1].map(|of| N::dot(&u, &directions[of])),
            },
            directions,
            drag: self.terms.drag(k, l, r, &sheared),
            u: sheared.u,
            approach,
            speed: between.speed,
            gradients: [g_k, g_l, g],
        }
    }

    /// Adds the term of a pair; `seen`: how the viscous stress sees `l`.
    #[inline(always)]
    fn add<S, N, const D: usize>(
        &self,
        [k, l]: [&NodeOver<N, S, T, D>; 2],
        apart: &Separation<N, D>,
        seen: Option<&Reversal<N, D>>,
        to_k: &mut GasSums<N, D>,
        to_l: &mut GasSums<N, D>,
    ) where
        S: Scalar,
        N: Number<Scalar = S>,
        V: Viscosity<S>,
        T: Terms<S, D>,
    {
        let of = self.exchanged(k, l, apart, seen);
        let [g_k, g_l, g] = of.gradients;
        let term = (of.pressure_k + of.pressure_l) + of.viscous;
        for i in 0..D {
            let force = match &of.directions {
                None => term * apart.r[i],
                Some([r_k, r_l]) => {
                    let pressed = of.pressure_k * r_k[i] + of.pressure_l * r_l[i];
                    pressed + of.viscous * apart.r[i]
                }
            };
            to_k.force[i] -= force;
            to_l.force[i] += force;
        }
        to_k.compression += l.measure * (of.along[0] * g_k);
        to_l.compression += k.measure * (of.along[1] * g_l);
        let heating = N::literal(0.5) * (of.viscous * of.approach);
        to_k.power += heating + of.heat;
        to_l.power += heating - of.heat;
        if let Some([of_k, of_l]) = &of.drag {
            for i in 0..D {
                let drag = of_k[i] + of_l[i];
                to_k.force[i] -= drag;
                to_l.force[i] += drag;
            }
            to_k.power += N::dot(of_k, &of.u);
            to_l.power += N::dot(of_l, &of.u);
        }
        // A pair out of reach has no say in the time step; its gradient is exactly 0.
        let near = g.below(N::zero());
        let closing = -of.speed * near;
        to_k.approach = to_k.approach.max(closing);
        to_l.approach = to_l.approach.max(closing);
        to_k.stiffest = to_k.stiffest.max(l.stiffness * near);
        to_l.stiffest = to_l.stiffest.max(k.stiffness * near);
    }
}

impl<S, C, V, T, const D: usize> Law<S, D> for Motion<C, V, T>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    T: Terms<S, D>,
{
    type Node = NodeOf<S, T, D>;
    type Sums = GasSums<S, D>;
    type CutOff = C;
    const NEEDS: Needs = NEEDS;

    fn cut_off(&self) -> C {
        self.cut_off
    }
    #[inline(always)]
    fn scale<N: Number<Scalar = S>>(&self, node: &NodeOver<N, S, T, D>) -> N {
        node.scale
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &NodeOver<N, S, T, D>,
        l: &NodeOver<N, S, T, D>,
        apart: &Separation<N, D>,
        to_k: &mut GasSums<N, D>,
        to_l: &mut GasSums<N, D>,
    ) {
        self.add([k, l], apart, None, to_k, to_l);
    }

    #[inline(always)]
    fn pair_behind<N: Number<Scalar = S>>(
        &self,
        pair: [&NodeOver<N, S, T, D>; 2],
        image: &Image<D>,
        apart: &Separation<N, D>,
        to_k: &mut GasSums<N, D>,
        to_l: &mut GasSums<N, D>,
    ) {
        let seen = self.terms.seen(image);
        self.add(pair, apart, seen.as_ref(), to_k, to_l);
    }

    fn proof(&self, ground: &Ground<'_, '_, S, D>, nodes: &[Self::Node]) -> Result<(), Error> {
        if self.terms.is_bounded() && self.prove(ground, nodes, 0.0).is_ok() {
            return Ok(());
        }
        by_pairs(self, ground, nodes, |node, wall| self.reflected(node, wall))
    }

    fn reflected(&self, node: &Self::Node, wall: &Wall<S>) -> Self::Node {
        reflected::<S, T, D>(node, wall)
    }
}

/// What the laws of a gas read of its cut-off.
pub(super) const NEEDS: Needs = Needs {
    parts: Parts::Gradient,
    widths: Widths::Both,
    distance: true,
};

/// A node as it is seen behind a wall.
pub(super) fn reflected<S: Scalar, T: Terms<S, D>, const D: usize>(
    node: &NodeOf<S, T, D>,
    wall: &Wall<S>,
) -> NodeOf<S, T, D> {
    let mut image = *node;
    if let Some(component) = image.velocity.get_mut(wall.axis) {
        *component = -*component;
    }
    image.terms = T::reflected(&node.terms, wall.axis);
    image
}
