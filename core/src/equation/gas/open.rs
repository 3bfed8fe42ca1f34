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
//! depends on the state alone, not on a clock. For waves from inside it is a piston: right for a
//! supersonic stream, which none runs against.
//!
//! *Reservoir*: the same for a subsonic stream. Its layers let waves out: [`super::reservoir`].
//!
//! *Outflow*: a particle goes on with what it had when it crossed the side, changed only as a
//! wave that runs outwards would change it,
//!
//! `Du_n/Dt = -c div u`, `De/Dt = -(p/ρ) div u`,
//!
//! and is removed at the far end. It is what remains of the equations of a plane simple wave,
//! `p' = ρ c u'`: small waves leave, and so do shocks. Without the first term (velocities frozen
//! at the side) half of a sound pulse comes back at Mach 0.2, with it 3 % (1D, `tests/open_sides.rs`).
//!
//! A subsonic stream needs what is beyond the side as well ([`super::Plain::far`]), or its mean
//! pressure is nobody's and drifts: see [`super::far`].

use crate::domain::Domain;
use crate::error::Error;
use crate::scalar::Scalar;

use super::end::OpenEnd;
use super::far::Far;
use super::inflow::{Inflow, Rear};
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
    /// Gas that comes in, whatever waves run against it.
    Inflow(Inflow<'a, S, D>),
    /// Gas that comes in from a far state, and lets waves out: see [`super::far`].
    Reservoir(Inflow<'a, S, D>, Far<S>),
    /// Gas that goes out, up to this distance from the side, > 0.
    Outflow(S),
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
                    mirror(&end, depth, id, cloud)?;
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
                release(&end, *depth, cloud);
            }
        }
        for (end, zone) in self.ends(domain) {
            match zone {
                Zone::Shut | Zone::Outflow(_) => {}
                Zone::Inflow(inflow) => {
                    let rear = hold(&end, inflow, &mut cloud.gas());
                    refill(&end, inflow, &rear, cloud)?;
                }
                Zone::Reservoir(inflow, far) => {
                    let rear = far.level(&end, inflow, &mut cloud.gas());
                    refill(&end, inflow, &rear, cloud)?;
                }
            }
        }
        Ok(())
    }

    /// The sides with their zones; none where the domain has no such direction.
    fn ends(&self, domain: &Domain<S, D>) -> impl Iterator<Item = (OpenEnd<S>, &Zone<'_, S, D>)> {
        let axis = domain.axes.get(self.axis);
        axis.into_iter()
            .flat_map(|axis| OpenEnd::both(self.axis, axis).into_iter().zip(&self.zones))
    }
}

/// Puts the image of a particle beyond the side.
fn mirror<S: Scalar, const D: usize>(
    end: &OpenEnd<S>,
    depth: S,
    id: usize,
    cloud: &mut impl Cloud<S, D>,
) -> Result<(), Error> {
    let Some((particle, density)) = cloud.gas().particle(id) else {
        return Ok(());
    };
    let inside = -end.distance(&particle.position);
    if !(inside > S::ZERO && inside < depth) {
        return Ok(());
    }
    let image = Particle {
        position: end.at(particle.position, inside),
        ..particle
    };
    cloud.insert(image, density)
}

/// Removes what is at the far end of an outflow's zone.
fn release<S: Scalar, const D: usize>(end: &OpenEnd<S>, depth: S, cloud: &mut impl Cloud<S, D>) {
    let mut id = 0;
    loop {
        let gas = cloud.gas();
        let mut rest = gas.position.iter().skip(id);
        let Some(steps) = rest.position(|x| end.distance(x) > depth) else {
            return;
        };
        id += steps;
        cloud.swap_remove(id);
    }
}

/// Holds an inflow's zone to its state.
fn hold<S: Scalar, const D: usize>(
    end: &OpenEnd<S>,
    inflow: &Inflow<'_, S, D>,
    gas: &mut Gas<'_, S, D>,
) -> Rear<S, D> {
    let mut distance = S::ZERO;
    let particles = gas
        .position
        .iter()
        .zip(gas.velocity.iter_mut())
        .zip(gas.energy.iter_mut());
    for ((position, velocity), energy) in particles {
        let out = end.distance(position);
        if out > S::ZERO {
            // Also what the gas inside has pushed out: it comes in again.
            (*velocity, *energy) = (inflow.particle.velocity, inflow.particle.energy);
            distance = distance.greater(out);
        }
    }
    Rear {
        distance,
        particle: inflow.particle,
        spacing: inflow.spacing,
    }
}

/// Lets layers enter at the rear of an inflow's zone.
fn refill<S: Scalar, const D: usize>(
    end: &OpenEnd<S>,
    inflow: &Inflow<'_, S, D>,
    rear: &Rear<S, D>,
    cloud: &mut impl Cloud<S, D>,
) -> Result<(), Error> {
    let offsets = inflow.layer.iter().map(|place| end.along(place));
    let first = offsets.reduce(S::lesser).unwrap_or(S::ZERO);
    let mut back = match rear.distance > S::ZERO {
        true => rear.distance + first,
        false => S::ZERO,
    };
    loop {
        let next = back + rear.spacing;
        if !(next > back && next <= inflow.depth) {
            return Ok(());
        }
        for place in inflow.layer {
            let position = end.at(*place, next - end.along(place));
            let particle = Particle {
                position,
                ..rear.particle
            };
            cloud.insert(particle, inflow.density)?;
        }
        back = next;
    }
}
