//! The gas far beyond an open side, and what it lets come in.
//!
//! At a side with outward normal n, with `w = (u - u_far)·n`, a wave of small amplitude that runs
//! out has `p = p_far + ρ c w`, one that runs in `p = p_far - ρ c w`. A zone in which the first
//! holds brings in nothing but the far state: of the Riemann invariants the outgoing one is that of
//! the gas inside, the incoming one that of the far state (Thompson, J. Comput. Phys. 68, 1, 1987;
//! with buffers of particles: Lastiwka, Basa & Quinlan, Int. J. Numer. Meth. Fluids 61, 709, 2009).
//! w is the mean of a slice of the zone. Why: `docs/decisions/17-open-sides.md`.

use crate::domain::Passed;
use crate::scalar::Scalar;

/// The state of the gas far beyond an open side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Far<S> {
    /// The velocity along the open direction; the components across play no part.
    pub velocity: S,
    /// Pressure.
    pub pressure: S,
    /// Density, > 0.
    pub density: S,
    /// Sound speed, > 0.
    pub sound_speed: S,
    /// How far from the side the zone of particles reaches, > 0.
    pub depth: S,
}

impl<S: Scalar> Far<S> {
    /// Whether a wave runs in, or out, against the stream there.
    #[inline(always)]
    pub fn is_subsonic(&self) -> bool {
        self.velocity.abs() < self.sound_speed
    }

    /// How much faster a particle goes out than the far gas: `w = (u - u_far)·n`.
    #[inline(always)]
    pub(super) fn excess<const D: usize>(&self, side: Passed, velocity: &[S; D]) -> S {
        let along = velocity.get(side.axis).copied().unwrap_or(S::ZERO);
        side.outward(along - self.velocity)
    }

    /// The pressure of a particle in a wave that runs out.
    ///
    /// `ρ c` is the mean of that of the particle and of the far state, as befits a shock; the
    /// pressure falls by at most `ρ c²/4` of the far state.
    #[inline(always)]
    pub(super) fn pressure_of_wave(&self, excess: S, impedance: S) -> S {
        let own = self.density * self.sound_speed;
        let lowest = -(own * self.sound_speed).half().half();
        self.pressure + ((own.half() + impedance.half()) * excess).greater(lowest)
    }
}
