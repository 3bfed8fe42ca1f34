//! Gas that comes in through a side.

use super::state::Particle;

/// Gas that comes in: a lattice made of equal layers.
#[derive(Clone, Copy, Debug)]
pub struct Inflow<'a, S, const D: usize> {
    /// The state of its particles; the position means nothing.
    pub particle: Particle<S, D>,
    /// Their density.
    pub density: S,
    /// The thickness of a layer, > 0.
    pub spacing: S,
    /// The particles of a layer; along the direction their distance from the back of the
    /// layer, in [0, `spacing`].
    pub layer: &'a [[S; D]],
    /// Layers enter as long as they lie within this distance from the side; at least
    /// `spacing`.
    pub depth: S,
}

/// The rear of an inflow's zone, where layers enter.
pub(super) struct Rear<S, const D: usize> {
    /// How far from the side the rearmost particle is; 0 of an empty zone.
    pub distance: S,
    /// The state of the particles that enter.
    pub particle: Particle<S, D>,
    /// The thickness of their layers.
    pub spacing: S,
}
