//! What [`Options`] adds to the sums over pairs.
//!
//! - `Π` from velocities reconstructed linearly to the midpoint under a slope limiter, and
//!   with factors of its own for each particle ([`super::switch`]);
//! - pressure along gradients that are exact for linear fields: [`super::direction`];
//! - physical viscosity, the stress of Navier and Stokes: [`super::stress`];
//! - heat conduction, (4.6): `m_k m_l χ (v_k + v_l) (e_k - e_l) g`, `g < 0`, `v = 1/(ρ M)`, M the
//!   second moment of the cut-off's gradient where an integral has 1. A sum over a lattice of squares
//!   at the usual width is 4 % less than the integral, and no finer lattice brings it nearer;
//! - artificial conduction, (4.6) with `b = α_e ρ v |r|/2`:
//!   `m_k m_l α_e v/ρ̄ (e_k - e_l) |r| g`, `v² = max(|p_k - p_l|/ρ̄ - c̄ max(s, 0), 0)`. Two
//!   particles that recede with `s` in a rarefaction differ by just `Δp = ρ c s`: there the
//!   throttle closes it, and it acts at contacts and shocks (after Price, J. Comp. Phys. 227,
//!   10040, 2008, whose `v² = |Δp|/ρ̄`). Of `e_k - e_l` it sees what remains when both are
//!   continued to the midpoint, so that a smooth profile keeps its shape.
//!
//! Energies are only exchanged within a material: they do not compare across an interface.

use crate::neighbours::Image;
use crate::record;
use crate::scalar::{Number, Scalar};

use super::options::Options;
use super::terms::{Between, NodeOver, Sheared, Terms};
use super::viscosity::{Pair, Viscosity};
use super::walls::Reversal;

record! {
    /// What a particle shows beyond the paper's equations.
    pub struct Extras<N, const D: usize> {
        /// Pressure `p`.
        pub pressure: N,
        /// `1/(ρ M)`, M the second moment of the cut-off's gradient in place of 1.
        pub specific_volume: N,
        /// Internal energy `e`.
        pub energy: N,
        /// Number of the material.
        pub material: N,
        /// Factor of α, in [0, 1].
        pub linear: N,
        /// Factor of Π, in [0, 1].
        pub factor: N,
        /// Factor of `u_k - u_l` in the viscous stress.
        pub shear: N,
        /// The diffusivity that bounds the time step.
        pub diffusivity: N,
        /// Velocity at the end of the step; only in the laws of [`super::energy`].
        pub velocity_now: [N; D],
        /// Acceleration; only in [`super::energy::PairWork`].
        pub acceleration: [N; D],
        /// `∂e/∂x_j`; 0 where nothing is conducted.
        pub energy_slope: [N; D],
        /// `∂u_i/∂x_j`; 0 where nothing is reconstructed.
        pub slope: [[N; D]; D],
        /// Factor of r in the viscous stress; 0 without one.
        pub stress: [[N; D]; D],
        /// B, what turns r towards the gradient of the particle: see [`super::direction`]. 0 where
        /// gradients are along r.
        pub direction: [[N; D]; D],
    }
}

/// `Σ_ij a_ij r_i r_j`.
#[inline(always)]
fn quadratic<N: Number, const D: usize>(a: &[[N; D]; D], r: &[N; D]) -> N {
    let mut rows = [N::zero(); D];
    for i in 0..D {
        rows[i] = N::dot(&a[i], r);
    }
    N::dot(&rows, r)
}

/// `|a|`.
#[inline(always)]
fn absolute<N: Number>(a: N) -> N {
    a.max(-a)
}

/// By how much a difference shrinks when both sides are continued to the midpoint with the
/// slopes `a` and `b` (times r) that they see: limited, the same for both, 0 where the slopes
/// differ in sign, whole where they agree.
#[inline(always)]
fn continued<N: Number>(a: N, b: N) -> N {
    let largest = absolute(a).max(absolute(b));
    // x in [0, 1]: the smaller over the larger slope, 0 for unequal signs.
    let agreeing = absolute(a + b) - absolute(a - b);
    let smallest = N::literal(0.5) * agreeing.max(N::zero());
    let x = smallest / largest.max(N::splat(N::Scalar::TINIEST));
    x * (N::literal(2.0) - x) * (N::literal(0.5) * (a + b))
}

/// What the viscous stress of one of a pair exerts.
#[inline(always)]
fn exerted<N: Number, const D: usize>(
    shown: &Extras<N, D>,
    [r, u]: [&[N; D]; 2],
    factor: N,
    seen: Option<&Reversal<N, D>>,
) -> [N; D] {
    let mut along = [N::zero(); D];
    for i in 0..D {
        along[i] = N::dot(&shown.stress[i], r);
    }
    if let Some(seen) = seen {
        along = seen.rate(&along);
    }
    let mut exerted = [N::zero(); D];
    for i in 0..D {
        exerted[i] = -(factor * (shown.shear * u[i] + along[i]));
    }
    exerted
}

impl<S: Scalar, const D: usize> Options<S, D> {
    /// `(û_k - û_l)·r`, û the velocities at the midpoint.
    #[inline(always)]
    fn reconstructed<N: Number<Scalar = S>>(
        &self,
        k: &Extras<N, D>,
        l: &Extras<N, D>,
        between: &Between<N, D>,
    ) -> N {
        if !self.limited {
            return between.approach;
        }
        let r = &between.r;
        between.approach - continued(quadratic(&k.slope, r), quadratic(&l.slope, r))
    }
}

impl<S: Scalar, const D: usize> Terms<S, D> for Options<S, D> {
    type Shown = Extras<S, D>;

    #[inline(always)]
    fn stress<N: Number<Scalar = S>, V: Viscosity<S>>(
        &self,
        viscosity: &V,
        k: &NodeOver<N, S, Self, D>,
        l: &NodeOver<N, S, Self, D>,
        between: &Between<N, D>,
    ) -> N {
        let half = N::literal(0.5);
        let limited = self.reconstructed(&k.terms, &l.terms, between);
        viscosity.pair(&Pair {
            approach: limited,
            distance_squared: between.distance_squared,
            speed: limited / between.floored,
            sound_speeds: k.sound_speed + l.sound_speed,
            densities: k.density + l.density,
            epsilons: k.epsilon + l.epsilon,
            linear: half * (k.terms.linear + l.terms.linear),
            factor: half * (k.terms.factor + l.terms.factor),
        })
    }

    #[inline(always)]
    fn drag<N: Number<Scalar = S>>(
        &self,
        k: &NodeOver<N, S, Self, D>,
        l: &NodeOver<N, S, Self, D>,
        r: &[N; D],
        sheared: &Sheared<'_, N, D>,
    ) -> Option<[[N; D]; 2]> {
        if !self.diffusion.is_viscous() {
            return None;
        }
        let (between, [factor_k, factor_l]) = ([r, &sheared.u], sheared.factors);
        Some([
            exerted(&k.terms, between, factor_k, None),
            exerted(&l.terms, between, factor_l, sheared.seen),
        ])
    }

    #[inline(always)]
    fn seen<N: Number<Scalar = S>>(&self, image: &Image<D>) -> Option<Reversal<N, D>> {
        self.walls.seen(image)
    }

    #[inline(always)]
    fn directions<N: Number<Scalar = S>>(
        &self,
        k: &NodeOver<N, S, Self, D>,
        l: &NodeOver<N, S, Self, D>,
        r: &[N; D],
    ) -> Option<[[N; D]; 2]> {
        if !self.linear_exact {
            return None;
        }
        let mut directions = [[N::zero(); D]; 2];
        for i in 0..D {
            directions[0][i] = N::dot(&k.terms.direction[i], r);
            directions[1][i] = N::dot(&l.terms.direction[i], r);
        }
        Some(directions)
    }

    fn is_bounded(&self) -> bool {
        !self.linear_exact && !self.diffusion.is_viscous() && !(self.diffusion.heat > S::ZERO)
    }

    #[inline(always)]
    fn heat<N: Number<Scalar = S>>(
        &self,
        k: &NodeOver<N, S, Self, D>,
        l: &NodeOver<N, S, Self, D>,
        between: &Between<N, D>,
        coupling: N,
    ) -> N {
        let half = N::literal(0.5);
        let zero = N::zero();
        let (a, b) = (&k.terms, &l.terms);
        let step = a.energy - b.energy;
        let volumes = a.specific_volume + b.specific_volume;
        let mut conducted = N::splat(self.diffusion.heat) * (volumes * step);
        if self.conduction > S::ZERO {
            let density = half * (k.density + l.density);
            let sound_speed = half * (k.sound_speed + l.sound_speed);
            let jump = absolute(a.pressure - b.pressure) / density;
            let throttled = jump - sound_speed * between.speed.max(zero);
            let signal = throttled.max(zero).sqrt();
            let r = &between.r;
            let left = step - continued(N::dot(&a.energy_slope, r), N::dot(&b.energy_slope, r));
            // Between 0 and the whole step: heat never runs uphill.
            let left = step.min(left).max(zero) + step.max(left).min(zero);
            conducted += N::splat(self.conduction) * (signal * between.distance / density) * left;
        }
        let foreign = absolute(a.material - b.material);
        let same = (N::literal(1.0) - foreign).max(zero);
        coupling * (same * conducted)
    }

    fn reflected(shown: &Extras<S, D>, axis: usize) -> Extras<S, D> {
        let mut image = *shown;
        for vector in [
            &mut image.velocity_now,
            &mut image.acceleration,
            &mut image.energy_slope,
        ] {
            if let Some(component) = vector.get_mut(axis) {
                *component = -*component;
            }
        }
        for tensor in [&mut image.slope, &mut image.stress, &mut image.direction] {
            for (i, row) in tensor.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    if (i == axis) != (j == axis) {
                        *entry = -*entry;
                    }
                }
            }
        }
        image
    }
}
