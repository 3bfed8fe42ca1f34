//! Where the pseudo-viscosity acts: a factor of α for each particle, and Balsara's factor.
//!
//! The factor `a_k(t)` in `[a_min, 1]` jumps up where the gas is about to be compressed, and
//! decays elsewhere (Cullen & Dehnen, MNRAS 408, 669, 2010):
//!
//! `A = ξ max(-d(div u)/dt, 0)`, `target = h² A/(v² + h² A)`,
//!
//! `a = target` where that is more, else `da/dt = -ℓ v/ε (a - max(target, a_min))`,
//!
//! with `ξ = (div u)²/((div u)² + tr S²)`, S the traceless part of the shear, h the radius of
//! the cut-off's support, and `v = c + max(0, max_l (u_l - u_k)·r/|r|)`, `r = x_k - x_l`. A
//! sound wave of small amplitude does not trigger it.
//!
//! Balsara's factor (J. Comp. Phys. 121, 357, 1995) is `|div u|/(|div u| + |curl u| + c/10⁴ε)`.

use crate::scalar::Scalar;

use super::gradient::{curl_squared, divergence, shear_squared};
use super::options::Switch;

/// A particle as the switch sees it.
pub(super) struct Flow<S, const D: usize> {
    /// `∂u_i/∂x_j`.
    pub gradient: [[S; D]; D],
    /// `div u` a step before.
    pub divergence_before: S,
    /// ε.
    pub epsilon: S,
    /// Radius of the cut-off's support in units of ε.
    pub support: S,
    /// v: the sound speed and the fastest approach of a partner, 0 where none is known yet.
    pub signal: S,
    /// Time since `divergence_before`; 0 at the start.
    pub dt: S,
}

impl<S: Scalar> Switch<S> {
    /// The factor of α after a step that began with `before`.
    pub(super) fn factor<const D: usize>(&self, before: S, flow: &Flow<S, D>) -> S {
        let now = divergence(&flow.gradient);
        let shear = shear_squared(&flow.gradient);
        let squared = now * now;
        let pure = if shear > S::ZERO {
            squared / (squared + shear)
        } else {
            S::ONE
        };
        // ε² A/ξ, with -div u v/ε in place of the unknown rate at the start.
        let compression = if flow.dt > S::ZERO {
            (flow.divergence_before - now) * (flow.epsilon / flow.dt) * flow.epsilon
        } else {
            -now * flow.epsilon * flow.signal
        };
        let trigger = flow.support * flow.support * (pure * compression.greater(S::ZERO));
        let target = if trigger > S::ZERO {
            trigger / (flow.signal * flow.signal + trigger)
        } else {
            S::ZERO
        };
        let floor = target.greater(self.minimum);
        if target > before {
            return floor;
        }
        let decay = flow.dt * (self.decay * (flow.signal / flow.epsilon));
        ((before + decay * floor) / (S::ONE + decay)).greater(self.minimum)
    }
}

/// Balsara's factor: 1 in pure compression, 0 in pure shear.
pub(super) fn balsara<S: Scalar, const D: usize>(
    gradient: &[[S; D]; D],
    sound_speed: S,
    epsilon: S,
) -> S {
    let divergence = divergence(gradient).abs();
    let curl = curl_squared(gradient).sqrt();
    let noise = S::from_f64(1e-4) * (sound_speed / epsilon);
    let sum = divergence + curl + noise;
    if sum > S::ZERO {
        divergence / sum
    } else {
        S::ONE
    }
}
