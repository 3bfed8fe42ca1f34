//! All that two particles may exchange: (3.10), (3.12) or (3.11), and what [`Options`] adds.
//!
//! Pressure and pseudo-viscosity as in [`super::motion`], and
//!
//! - `Π` from velocities reconstructed linearly to the midpoint under a slope limiter, and
//!   with factors of its own for each particle ([`super::switch`]);
//! - physical viscosity, (4.6) along the line of centres:
//!   `Π = -(D+2) ν (1/ρ_k + 1/ρ_l) (u_k-u_l)·r/|r|²`;
//! - heat conduction, (4.6): `m_k m_l χ (1/ρ_k + 1/ρ_l) (e_k - e_l) g`, `g < 0`;
//! - artificial conduction, (4.6) with `b = α_e ρ v |r|/2`:
//!   `m_k m_l α_e v/ρ̄ (e_k - e_l) |r| g`, `v² = max(|p_k - p_l|/ρ̄ - c̄ max(s, 0), 0)`. Two
//!   particles that recede with `s` in a rarefaction differ by just `Δp = ρ c s`: there the
//!   throttle closes it, and it acts at contacts and shocks (after Price, J. Comp. Phys. 227,
//!   10040, 2008, whose `v² = |Δp|/ρ̄`). Of `e_k - e_l` it sees what remains when both are
//!   continued to the midpoint, so that a smooth profile keeps its shape.
//!
//! Energies are only exchanged within a material: they do not compare across an interface.
//!
//! [`Options`]: super::Options

use crate::cutoff::{CutOff, Needs, Parts, Widths};
use crate::domain::Wall;
use crate::pairs::{Law, Separation};
use crate::record;
use crate::scalar::{Number, Scalar};

use super::options::Diffusion;
use super::viscosity::{Pair, Viscosity};

record! {
    /// What a particle shows.
    pub struct ExchangeNode<N, const D: usize> {
        /// Mass `m`.
        pub mass: N,
        /// Measure μ: the mass, or 1.
        pub measure: N,
        /// `P = (p + q)/(Ω ν²)`.
        pub force_pressure: N,
        /// Pressure `p`.
        pub pressure: N,
        /// `σ ε^-(D+2)`: turns `F(q) r` into the gradient.
        pub gradient: N,
        /// The particle's part of the argument of the cut-off.
        pub scale: N,
        /// Sound speed `c`.
        pub sound_speed: N,
        /// Density ρ.
        pub density: N,
        /// `1/ρ`.
        pub specific_volume: N,
        /// ε.
        pub epsilon: N,
        /// Internal energy `e`.
        pub energy: N,
        /// Number of the material.
        pub material: N,
        /// Factor of α, in [0, 1].
        pub linear: N,
        /// Factor of Π, in [0, 1].
        pub factor: N,
        /// Velocity `u` that forces depend on.
        pub velocity: [N; D],
        /// Velocity that does work; only in [`Sum::Work`].
        pub velocity_now: [N; D],
        /// Acceleration; only in [`Sum::Work`].
        pub acceleration: [N; D],
        /// `∂e/∂x_j`; 0 where nothing is conducted.
        pub energy_slope: [N; D],
        /// `∂u_i/∂x_j`; 0 where nothing is reconstructed.
        pub slope: [[N; D]; D],
    }
}

record! {
    /// What it receives.
    pub struct ExchangeSums<N, const D: usize> {
        /// `Σ_l μ_l (u_k-u_l)·∇ζ_kl(ε_k) = -Ω_k ν_k div u`.
        pub compression: N,
        /// [`Sum::Forces`]: rate of internal energy but for the pressure's part.
        /// [`Sum::Work`]: rate of internal energy with the velocities of now.
        /// [`Sum::Flow`]: rate of total energy.
        pub power: N,
        /// [`Sum::Work`]: what `power` gains in a unit of time while forces do not change.
        pub power_slope: N,
        /// The fastest approach of a partner, along the line of centres; at least 0.
        pub approach: N,
        /// `m_k du_k/dt`.
        pub force: [N; D],
    }
}

/// Which sums are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sum {
    /// Rates of momentum and internal energy: (3.10), (3.12).
    Forces,
    /// The same forces, and the work they do.
    Work,
    /// The same forces, and the total energy that flows: (3.11).
    Flow,
}

/// The law.
#[derive(Clone, Copy, Debug)]
pub struct Exchange<C, V, S> {
    /// The cut-off.
    pub cut_off: C,
    /// The pseudo-viscosity.
    pub viscosity: V,
    /// Whether velocities are reconstructed.
    pub limited: bool,
    /// `α_e`.
    pub conduction: S,
    /// `ν` and `χ`.
    pub diffusion: Diffusion<S>,
    /// Which sums.
    pub sum: Sum,
}

/// A distance below any that matters.
const TINY: f64 = 1.0 / 65536.0;

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

impl<S: Scalar, C: CutOff, V: Viscosity<S>> Exchange<C, V, S> {
    /// `(û_k - û_l)·r`, û the velocities at the midpoint.
    #[inline(always)]
    fn reconstructed<N: Number<Scalar = S>, const D: usize>(
        &self,
        k: &ExchangeNode<N, D>,
        l: &ExchangeNode<N, D>,
        r: &[N; D],
        approach: N,
    ) -> N {
        if !self.limited {
            return approach;
        }
        approach - continued(quadratic(&k.slope, r), quadratic(&l.slope, r))
    }

    /// The internal energy that `k` gives to `l`, negative, or receives, over `m_k m_l g`.
    #[inline(always)]
    fn conducted<N: Number<Scalar = S>, const D: usize>(
        &self,
        k: &ExchangeNode<N, D>,
        l: &ExchangeNode<N, D>,
        r: &[N; D],
        speed: N,
        distance: N,
    ) -> N {
        let half = N::literal(0.5);
        let step = k.energy - l.energy;
        let mut conducted =
            N::splat(self.diffusion.heat) * ((k.specific_volume + l.specific_volume) * step);
        if self.conduction > S::ZERO {
            let density = half * (k.density + l.density);
            let sound_speed = half * (k.sound_speed + l.sound_speed);
            let jump = absolute(k.pressure - l.pressure) / density;
            let signal = (jump - sound_speed * speed.max(N::zero()))
                .max(N::zero())
                .sqrt();
            let left = step - continued(N::dot(&k.energy_slope, r), N::dot(&l.energy_slope, r));
            // Between 0 and the whole step: heat never runs uphill.
            let zero = N::zero();
            let left = step.min(left).max(zero) + step.max(left).min(zero);
            conducted += N::splat(self.conduction) * (signal * distance / density) * left;
        }
        let foreign = absolute(k.material - l.material);
        let same = (N::literal(1.0) - foreign).max(N::zero());
        same * conducted
    }
}

impl<S: Scalar, C: CutOff, V: Viscosity<S>, const D: usize> Law<S, D> for Exchange<C, V, S> {
    type Node = ExchangeNode<S, D>;
    type Sums = ExchangeSums<S, D>;
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
    fn scale<N: Number<Scalar = S>>(&self, node: &ExchangeNode<N, D>) -> N {
        node.scale
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &ExchangeNode<N, D>,
        l: &ExchangeNode<N, D>,
        apart: &Separation<N, D>,
        to_k: &mut ExchangeSums<N, D>,
        to_l: &mut ExchangeSums<N, D>,
    ) {
        let half = N::literal(0.5);
        let Separation {
            r,
            distance_squared,
            zeta,
        } = apart;
        let g_k = k.gradient * zeta.k.gradient;
        let g_l = l.gradient * zeta.l.gradient;
        let g = half * (g_k + g_l);

        let mut u = [N::zero(); D];
        for i in 0..D {
            u[i] = k.velocity[i] - l.velocity[i];
        }
        let approach = N::dot(&u, r);
        let distance = zeta.distance;
        let floored = distance.max(N::literal(TINY));
        let speed = approach / floored;
        let limited = self.reconstructed(k, l, r, approach);
        let artificial = self.viscosity.pair(&Pair {
            approach: limited,
            distance_squared: *distance_squared,
            speed: limited / floored,
            sound_speeds: k.sound_speed + l.sound_speed,
            densities: k.density + l.density,
            epsilons: k.epsilon + l.epsilon,
            linear: half * (k.linear + l.linear),
            factor: half * (k.factor + l.factor),
        });
        let stress = N::splat(self.diffusion.viscosity * S::count(D as u32 + 2))
            * (k.specific_volume + l.specific_volume);
        let pi = artificial - stress * (speed / floored);

        let masses = k.mass * l.mass;
        let measures = k.measure * l.measure;
        let viscous = masses * (pi * g);
        let pressure_k = measures * (k.force_pressure * g_k);
        let pressure_l = measures * (l.force_pressure * g_l);
        let heat = masses * (self.conducted(k, l, r, speed, distance) * g);
        match self.sum {
            Sum::Forces => {
                let term = (pressure_k + pressure_l) + viscous;
                for i in 0..D {
                    let force = term * r[i];
                    to_k.force[i] -= force;
                    to_l.force[i] += force;
                }
                to_k.compression += l.measure * (approach * g_k);
                to_l.compression += k.measure * (approach * g_l);
                let heating = half * (viscous * approach);
                to_k.power += heating + heat;
                to_l.power += heating - heat;
                let closing = -speed * g.below(N::zero());
                to_k.approach = to_k.approach.max(closing);
                to_l.approach = to_l.approach.max(closing);
            }
            Sum::Work => {
                let mut v = [N::zero(); D];
                let mut w = [N::zero(); D];
                for i in 0..D {
                    v[i] = k.velocity_now[i] - l.velocity_now[i];
                    w[i] = k.acceleration[i] - l.acceleration[i];
                }
                let (now, gain) = (N::dot(&v, r), N::dot(&w, r));
                let (share_k, share_l) = (pressure_k + half * viscous, pressure_l + half * viscous);
                to_k.power += share_k * now + heat;
                to_l.power += share_l * now - heat;
                to_k.power_slope += share_k * gain;
                to_l.power_slope += share_l * gain;
            }
            Sum::Flow => {
                let (along_k, along_l) = (N::dot(&k.velocity, r), N::dot(&l.velocity, r));
                let flow = (pressure_k * along_l + pressure_l * along_k)
                    + half * (viscous * (along_k + along_l));
                to_k.power += heat - flow;
                to_l.power += flow - heat;
            }
        }
    }

    fn reflected(&self, node: &ExchangeNode<S, D>, wall: &Wall<S>) -> ExchangeNode<S, D> {
        let mut node = *node;
        for vector in [
            &mut node.velocity,
            &mut node.velocity_now,
            &mut node.acceleration,
            &mut node.energy_slope,
        ] {
            if let Some(component) = vector.get_mut(wall.axis) {
                *component = -*component;
            }
        }
        for (i, row) in node.slope.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                if (i == wall.axis) != (j == wall.axis) {
                    *entry = -*entry;
                }
            }
        }
        node
    }
}
