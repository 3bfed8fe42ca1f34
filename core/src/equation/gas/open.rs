//! Sides through which gas comes in and goes out.
//!
//! Beyond such a side lies a zone of particles that take part in all sums as partners, while
//! the forces on them are not theirs: outside the zone there is nothing. A particle inside the
//! domain sees partners up to a reach away, and their densities depend on partners a reach
//! further out, so a zone must be more than two reaches deep; three leave room for the ε of the
//! outermost particles, which see nobody on one side and grow.
//!
//! *Inflow*: the zone is filled with the incoming state and moves in as a whole; nothing acts on
//! it. As soon as a layer has room behind the rearmost particle, one enters there: when that is
//! depends on the state alone, not on a clock. For waves from inside it is a piston.
//!
//! *Outflow*: a particle goes on with what it had when it crossed the side, changed only as a
//! wave that runs outwards would change it,
//!
//! `Du_n/Dt = -c div u`, `De/Dt = -(p/ρ) div u`,
//!
//! and is removed at the far end. It is what remains of the equations of a plane simple wave,
//! `p' = ρ c u'`: small waves leave, and so do shocks. Without the first term (velocities frozen
//! at the side) half of a sound pulse comes back at Mach 0.2, with it 3 % (1D, `tests/open_sides.rs`).

use crate::domain::{Axis, Domain};
use crate::error::Error;
use crate::scalar::Scalar;

use super::state::{Gas, Particle};

/// The open sides of one direction of a domain.
#[derive(Clone, Copy, Debug)]
pub struct Opening<'a, S, const D: usize> {
    /// The direction, from 0.
    pub axis: usize,
    /// What is beyond its lower and its upper side.
    pub zones: [Zone<'a, S, D>; 2],
}

/// What is beyond a side.
#[derive(Clone, Copy, Debug)]
pub enum Zone<'a, S, const D: usize> {
    /// What the domain says; the side is not open.
    Shut,
    /// Gas that comes in.
    Inflow(Inflow<'a, S, D>),
    /// Gas that goes out, up to this distance from the side, > 0.
    Outflow(S),
}

/// Gas that comes in: a lattice that moves as a whole, made of equal layers.
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

/// A cloud that particles come to and go from.
pub trait Cloud<S: Scalar, const D: usize> {
    /// Its state.
    fn gas(&mut self) -> Gas<'_, S, D>;

    /// Adds a particle that nothing acts on yet; its id is the number of particles before it.
    /// Error: no room.
    fn insert(&mut self, particle: Particle<S, D>, density: S) -> Result<(), Error>;

    /// Removes a particle; the last one gets its id. Does nothing beyond the end.
    fn swap_remove(&mut self, id: usize);
}

impl<S: Scalar, const D: usize> Opening<'_, S, D> {
    /// Fills the zones at the start, before [`GasDynamics::prepare`](super::GasDynamics::prepare):
    /// the inflow's with what comes in, an outflow's with the cloud's mirror image, moving as
    /// the cloud does.
    pub fn fill(&self, domain: &Domain<S, D>, cloud: &mut impl Cloud<S, D>) -> Result<(), Error> {
        let particles = cloud.gas().len();
        for (end, zone) in self.ends(domain) {
            if let Zone::Outflow(depth) = *zone {
                for id in 0..particles {
                    self.mirror(&end, depth, id, cloud)?;
                }
            }
        }
        self.exchange(domain, cloud)
    }

    /// What comes and goes between two steps. Ids change: the last particles take the places
    /// of those that leave.
    pub fn exchange(
        &self,
        domain: &Domain<S, D>,
        cloud: &mut impl Cloud<S, D>,
    ) -> Result<(), Error> {
        // Who goes makes room for who comes.
        for (end, zone) in self.ends(domain) {
            if let Zone::Outflow(depth) = zone {
                self.release(&end, *depth, cloud);
            }
        }
        for (end, zone) in self.ends(domain) {
            if let Zone::Inflow(inflow) = zone {
                self.refill(&end, inflow, cloud)?;
            }
        }
        Ok(())
    }

    /// The sides with their zones; none where the domain has no such direction.
    fn ends(&self, domain: &Domain<S, D>) -> impl Iterator<Item = (End<S>, &Zone<'_, S, D>)> {
        let axis = domain.axes.get(self.axis);
        axis.into_iter()
            .flat_map(|axis| End::both(axis).into_iter().zip(&self.zones))
    }

    /// The component along the direction.
    fn along(&self, position: &[S; D]) -> S {
        position.get(self.axis).copied().unwrap_or(S::ZERO)
    }

    /// The same position with another component along the direction.
    fn at(&self, mut position: [S; D], x: S) -> [S; D] {
        if let Some(component) = position.get_mut(self.axis) {
            *component = x;
        }
        position
    }

    /// Puts the image of a particle beyond the side.
    fn mirror(
        &self,
        end: &End<S>,
        depth: S,
        id: usize,
        cloud: &mut impl Cloud<S, D>,
    ) -> Result<(), Error> {
        let gas = cloud.gas();
        let Some((particle, density)) = gas.particle(id) else {
            return Ok(());
        };
        let inside = -end.distance(self.along(&particle.position));
        if !(inside > S::ZERO && inside < depth) {
            return Ok(());
        }
        let position = self.at(particle.position, end.place(inside));
        cloud.insert(
            Particle {
                position,
                ..particle
            },
            density,
        )
    }

    /// Removes what is at the far end of an outflow's zone.
    fn release(&self, end: &End<S>, depth: S, cloud: &mut impl Cloud<S, D>) {
        let mut id = 0;
        loop {
            let gas = cloud.gas();
            let far = |x: &[S; D]| end.distance(self.along(x)) > depth;
            let rest = gas.position.iter().skip(id);
            let Some(steps) = rest.into_iter().position(far) else {
                return;
            };
            id += steps;
            cloud.swap_remove(id);
        }
    }

    /// Holds an inflow's zone to its state, and lets layers enter at its back.
    fn refill(
        &self,
        end: &End<S>,
        inflow: &Inflow<'_, S, D>,
        cloud: &mut impl Cloud<S, D>,
    ) -> Result<(), Error> {
        let offsets = inflow.layer.iter().map(|place| self.along(place));
        let first = offsets.reduce(S::lesser).unwrap_or(S::ZERO);
        let mut back = S::ZERO;
        let gas = cloud.gas();
        let particles = gas
            .position
            .iter()
            .zip(gas.velocity.iter_mut())
            .zip(gas.energy.iter_mut());
        for ((position, velocity), energy) in particles {
            let distance = end.distance(self.along(position));
            if distance > S::ZERO {
                // Also what the gas inside has pushed out: it comes in again.
                (*velocity, *energy) = (inflow.particle.velocity, inflow.particle.energy);
                back = back.greater(distance + first);
            }
        }
        loop {
            let next = back + inflow.spacing;
            if !(next > back && next <= inflow.depth) {
                return Ok(());
            }
            for place in inflow.layer {
                let x = end.place(next - self.along(place));
                let position = self.at(*place, x);
                let particle = Particle {
                    position,
                    ..inflow.particle
                };
                cloud.insert(particle, inflow.density)?;
            }
            back = next;
        }
    }
}

/// A side, and which way is out.
struct End<S> {
    side: S,
    is_upper: bool,
}

impl<S: Scalar> End<S> {
    fn both(axis: &Axis<S>) -> [Self; 2] {
        [
            Self {
                side: axis.lower,
                is_upper: false,
            },
            Self {
                side: axis.upper,
                is_upper: true,
            },
        ]
    }

    /// How far out a place is; negative inside.
    fn distance(&self, x: S) -> S {
        if self.is_upper {
            x - self.side
        } else {
            self.side - x
        }
    }

    /// The place that far out.
    fn place(&self, distance: S) -> S {
        if self.is_upper {
            self.side + distance
        } else {
            self.side - distance
        }
    }
}
