//! The zone of a gas that comes in and lets waves out.
//!
//! What runs out through it has `w = (u - u_far)·n` and `p = p_far + ρ c w` ([`super::far`]).
//! Nothing holds particles in their places there, so those of one row, equally far from the side,
//! go on as one: with the means of their w and of their accelerations. Their energy is that of the
//! isentrope through the far state, `e = e_far + (p/ρ)_far w/c_far`, the layers that enter are as
//! dense, and the velocity across is that of the stream: a wave that runs out changes neither
//! entropy nor shear.

use crate::scalar::Scalar;

use super::end::OpenEnd;
use super::far::Far;
use super::inflow::{Inflow, Rear};
use super::state::{Gas, Particle};

/// A row of particles, about equally far from the side.
struct Rank<S> {
    /// Between which distances they lie.
    range: [S; 2],
    /// How far out the last of them is.
    distance: S,
    /// Their mean w.
    excess: S,
    /// The mean of their outward accelerations.
    push: S,
}

impl<S: Scalar> Far<S> {
    /// Makes the particles of each row of an inflow's zone alike; returns its rear.
    pub(super) fn level<const D: usize>(
        &self,
        end: &OpenEnd<S>,
        inflow: &Inflow<'_, S, D>,
        gas: &mut Gas<'_, S, D>,
    ) -> Rear<S, D> {
        let mut rear = self.rear(end, inflow, S::ZERO, S::ZERO);
        loop {
            let distances = gas.position.iter().map(|x| end.distance(x));
            let further = distances.filter(|&distance| distance > rear.distance);
            let Some(nearest) = further.reduce(S::lesser) else {
                return rear;
            };
            let range = [nearest, nearest + inflow.spacing.half().half()];
            let rank = self.rank(end, range, gas);
            rear = self.rear(end, inflow, rank.distance, rank.excess);
            rank.align(end, &rear.particle, gas);
        }
    }

    /// The rear of a zone whose last row has that w.
    fn rear<const D: usize>(
        &self,
        end: &OpenEnd<S>,
        inflow: &Inflow<'_, S, D>,
        distance: S,
        excess: S,
    ) -> Rear<S, D> {
        // Stronger waves than the first order holds for must not make layers vanish.
        let most = S::ONE.half().half();
        let strain = (excess / self.sound_speed).lesser(most).greater(-most);
        let velocity = self.velocity + end.side.outward(excess);
        let particle = Particle {
            velocity: end.with(inflow.particle.velocity, velocity),
            energy: inflow.particle.energy + self.pressure / self.density * strain,
            ..inflow.particle
        };
        Rear {
            distance,
            particle,
            spacing: inflow.spacing - inflow.spacing * strain,
        }
    }

    /// The row in a range of distances; running means, since in fixed point a sum of many could
    /// leave the range of the format.
    fn rank<const D: usize>(
        &self,
        end: &OpenEnd<S>,
        range: [S; 2],
        gas: &Gas<'_, S, D>,
    ) -> Rank<S> {
        let mut rank = Rank {
            range,
            distance: range[0],
            excess: S::ZERO,
            push: S::ZERO,
        };
        let particles = gas
            .position
            .iter()
            .zip(gas.velocity.iter())
            .zip(gas.force.iter())
            .zip(gas.mass.iter());
        let mut count = 0;
        for (((position, velocity), force), &mass) in particles {
            let distance = end.distance(position);
            if !rank.holds(distance) {
                continue;
            }
            count = u32::saturating_add(count, 1);
            let excess = self.excess(end.side, velocity);
            let push = end.side.outward(end.along(force) / mass);
            rank.excess += (excess - rank.excess) / S::count(count);
            rank.push += (push - rank.push) / S::count(count);
            rank.distance = rank.distance.greater(distance);
        }
        rank
    }
}

impl<S: Scalar> Rank<S> {
    fn holds(&self, distance: S) -> bool {
        distance >= self.range[0] && distance <= self.range[1]
    }

    /// Gives all particles of the row the same velocity, energy and acceleration.
    fn align<const D: usize>(
        &self,
        end: &OpenEnd<S>,
        particle: &Particle<S, D>,
        gas: &mut Gas<'_, S, D>,
    ) {
        let particles = gas
            .position
            .iter()
            .zip(gas.velocity.iter_mut())
            .zip(gas.energy.iter_mut())
            .zip(gas.force.iter_mut())
            .zip(gas.mass.iter());
        for ((((position, velocity), energy), force), &mass) in particles {
            if self.holds(end.distance(position)) {
                (*velocity, *energy) = (particle.velocity, particle.energy);
                *force = end.with([S::ZERO; D], end.side.outward(mass * self.push));
            }
        }
    }
}
