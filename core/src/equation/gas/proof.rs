//! Proofs that the sums and products of a gas stay in the range of a format that wraps.
//!
//! By intervals they would be bounded by far too much: a speed is a product over a distance, and the
//! smallest width goes with the largest density. So here each particle's own products are bounded
//! first, and the largest of them taken.

use crate::cutoff::{CutOff, Peaks};
use crate::error::{Error, Quantity};
use crate::material::EquationOfState;
use crate::numbered::numbered;
use crate::pairs::{Engine, Ground, Largest, Law, Partner, each_image, each_partner, holds};
use crate::scalar::Scalar;

use super::density::{Density, DensityNode};
use super::dynamics::GasDynamics;
use super::gradient::{Gradient, GradientNode};
use super::motion::Motion;
use super::node::GasNode;
use super::physics::Physics;
use super::state::Gas;
use super::viscosity::Viscosity;

/// The largest of the components of vectors.
fn longest<S: Scalar, const D: usize>(vectors: &[[S; D]]) -> Largest {
    let components = vectors.iter().flatten().copied();
    let mut longest = Largest::of(components);
    longest.place = longest.place.checked_div(D).unwrap_or(0);
    longest
}

/// The smallest of some positive numbers.
fn smallest<S: Scalar>(numbers: impl Iterator<Item = S>) -> f64 {
    numbers.reduce(Scalar::lesser).map_or(1.0, S::to_f64)
}

/// `√D`: by how much a vector may be longer than its components.
fn diagonal<const D: usize>() -> f64 {
    libm::sqrt(D as f64)
}

impl<S: Scalar, C: CutOff, const D: usize> Density<S, C, D> {
    /// Bounds of the sums `S`, `S'` and `S''`.
    pub(super) fn prove(
        &self,
        ground: &Ground<'_, '_, S, D>,
        nodes: &[DensityNode<S, D>],
    ) -> Result<(), Error> {
        let cut_off = Law::<S, D>::cut_off(self);
        let peaks = Peaks::of::<S, C, D>(cut_off, true);
        let support = f64::from(cut_off.support());
        let measure = Largest::of(nodes.iter().map(|node| node.measure));
        // Beyond its limit nothing of a width is accepted.
        let width = Largest::of(nodes.iter().map(|node| node.limit));
        let squared = width.bound * width.bound;
        let each = (squared * peaks.first.max(peaks.second)).max(peaks.value);
        let term = (squared * support * support).max(ground.partners * each);
        let bound = measure.bound * term;
        let proven = ground.holds(Quantity::DensitySum, width.with(bound));
        proven.or_else(|_| Self::prove_each(&peaks, ground, nodes))
    }

    /// The same of each particle with the partners that it has: dear, and only where the bound of all of
    /// them at once proves nothing.
    #[inline(never)]
    fn prove_each(
        peaks: &Peaks,
        ground: &Ground<'_, '_, S, D>,
        nodes: &[DensityNode<S, D>],
    ) -> Result<(), Error> {
        let mut largest = Largest::default();
        for (place, node) in numbered(nodes) {
            let (mut sum, mut spread) = (0.0f64, 0.0f64);
            let mut add = |partner: &Partner<S, D>| {
                if let Some(l) = nodes.get(partner.place) {
                    let measure = l.measure.to_f64();
                    sum += measure;
                    spread = spread.max(measure.max(1.0) * partner.distance_squared.to_f64());
                }
            };
            each_partner(ground.cells, place, &mut add);
            each_image(ground.cells, place, &mut add);
            // Beyond its limit nothing of a width is accepted.
            let width = node.limit.to_f64();
            let each = (width * width * peaks.first.max(peaks.second)).max(peaks.value);
            largest.see(place, spread.max(sum * each));
        }
        ground.holds(Quantity::DensitySum, largest)
    }
}

impl<S: Scalar, C: CutOff, const D: usize> Gradient<S, C, D> {
    /// Bounds of its sums.
    pub(super) fn prove(
        &self,
        ground: &Ground<'_, '_, S, D>,
        nodes: &[GradientNode<S, D>],
    ) -> Result<(), Error> {
        let cut_off = self.cut_off;
        let peaks = Peaks::of::<S, C, D>(cut_off, false);
        let measure = Largest::of(nodes.iter().map(|node| node.measure)).bound;
        let energy = Largest::of(nodes.iter().map(|node| node.energy));
        let speed = Largest::of(nodes.iter().flat_map(|node| node.velocity)).bound;
        let step = 2.0 * (speed + self.walls.fastest());
        let step = (2.0 * energy.bound).max(step).max(ground.reach);
        // `F |r|` is ε times the slope, ε at most the reach over the support.
        let width = ground.reach / f64::from(cut_off.support());
        let sum = ground.partners * measure * peaks.slope * width * step;
        let made = (step * ground.reach).max(measure * peaks.gradient);
        ground.holds(Quantity::Gradient, energy.with(sum.max(made)))
    }
}

/// What the pairs of a gas may come to, one of them.
pub(super) struct Pairs {
    /// Of the force, and where it is largest.
    pub force: Largest,
    /// `P_k` times the gradient, over masses, with its distance.
    pub pressure: f64,
    /// The same of the viscosity.
    pub viscous: f64,
    /// The largest difference of velocities.
    pub speed: f64,
}

impl<C: CutOff, V, T> Motion<C, V, T> {
    /// Bounds of a pair; refuses products on the way that leave the range.
    pub(super) fn bounds<S: Scalar, X, const D: usize>(
        &self,
        ground: &Ground<'_, '_, S, D>,
        nodes: &[GasNode<S, X, D>],
    ) -> Result<Pairs, Error>
    where
        V: Viscosity<S>,
    {
        let peaks = Peaks::of::<S, C, D>(self.cut_off, false);
        let mass = Largest::of(nodes.iter().map(|node| node.mass)).bound;
        let measure = Largest::of(nodes.iter().map(|node| node.measure)).bound;
        let sound_speed = Largest::of(nodes.iter().map(|node| node.sound_speed));
        let component = Largest::of(nodes.iter().flat_map(|node| node.velocity)).bound;
        let least = smallest(nodes.iter().map(|node| node.density));
        let mut gradient = Largest::default();
        let (mut push, mut pushed) = (Largest::default(), Largest::default());
        let (mut thin, mut slim) = (0.0f64, 0.0f64);
        let mut slope = 0.0f64;
        let (mut stiff, mut soft) = (Largest::default(), 0.0f64);
        for (place, node) in numbered(nodes) {
            let (g, width) = (node.gradient.to_f64(), node.epsilon.to_f64());
            let pressure = node.pressure.to_f64();
            let inverse = 1.0 / node.density.to_f64();
            // `√m/ν`, as what it shows is made and as it is felt.
            let mass = node.mass.to_f64();
            let own = mass * libm::sqrt(mass) * inverse / node.measure.to_f64();
            stiff.see(place, own.max(1.0) * node.sound_speed.to_f64());
            soft = soft.max(1.0 / own);
            // `F` times its factor, and that times the distance.
            let (steep, along) = (g * peaks.gradient, g * width * peaks.slope);
            gradient.see(place, steep);
            push.see(place, pressure.abs() * steep);
            pushed.see(place, pressure.abs() * along);
            slope = slope.max(along);
            thin = thin.max(steep * inverse);
            slim = slim.max(along * inverse);
        }
        ground.holds(Quantity::Velocity, stiff.times(soft.max(1.0)))?;
        ground.holds(Quantity::Force, gradient)?;
        ground.holds(Quantity::Force, push.times((measure * measure).max(1.0)))?;
        // A speed along the line of centres is a product over a distance that is rounded: TINY at least.
        let rounding = S::TINIEST.to_f64() * 65536.0;
        let speed = 2.0 * component * diagonal::<D>() + rounding;
        let approach = Largest {
            bound: speed * ground.reach,
            ..sound_speed
        };
        ground.holds(Quantity::Velocity, approach)?;
        let stress = self.viscosity.largest(speed, sound_speed.bound);
        let pi = Largest {
            bound: stress.max(stress / (2.0 * least)),
            ..sound_speed
        };
        ground.holds(Quantity::Force, pi)?;
        let masses = mass * mass;
        let braked = masses.max(1.0) * stress * thin;
        ground.holds(
            Quantity::Force,
            Largest {
                bound: 2.0 * measure * measure * push.bound + braked,
                ..push
            },
        )?;
        let (pressure, viscous) = (measure * measure * pushed.bound, masses * stress * slim);
        let force = Largest {
            bound: 2.0 * pressure + viscous,
            ..pushed
        };
        ground.holds(Quantity::Force, force.times(ground.partners))?;
        let compression = measure.max(1.0) * speed * slope;
        ground.holds(
            Quantity::Power,
            gradient.with(ground.partners * compression),
        )?;
        Ok(Pairs {
            force,
            pressure,
            viscous,
            speed,
        })
    }

    /// Whether the sums of [`Motion`], and those of the energy that are made of the same pairs with
    /// velocities up to `speeds` times theirs, stay in the range.
    pub(super) fn prove<S: Scalar, X, const D: usize>(
        &self,
        ground: &Ground<'_, '_, S, D>,
        nodes: &[GasNode<S, X, D>],
        speeds: f64,
    ) -> Result<(), Error>
    where
        V: Viscosity<S>,
    {
        let pairs = self.bounds(ground, nodes)?;
        let power = (2.0 * pairs.pressure * speeds + pairs.viscous) * pairs.speed;
        ground.holds(Quantity::Power, pairs.force.with(ground.partners * power))
    }
}

impl Largest {
    /// Another bound of the same particle.
    fn with(self, bound: f64) -> Self {
        Self { bound, ..self }
    }
}

impl<S, C, V, E, P, const D: usize> GasDynamics<'_, S, C, V, E, P, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
    P: Physics<S, D>,
{
    /// Whether a drift over `dt` stays in the range.
    pub(super) fn prove_drift(&self, gas: &Gas<'_, S, D>, dt: S) -> Result<(), Error> {
        let (position, velocity) = (longest(gas.position), longest(gas.velocity));
        let dt = dt.to_f64();
        let speed = velocity.bound + dt * self.pull(gas);
        self.in_range(Quantity::Velocity, velocity.with(speed))?;
        self.in_range(
            Quantity::Position,
            position.with(position.bound + dt * speed),
        )
    }

    /// Whether the kicks of a step, and what follows from settled densities, stay in the range.
    pub(super) fn prove_state(&self, gas: &Gas<'_, S, D>, dt: S) -> Result<(), Error> {
        let velocity = longest(gas.velocity);
        let dt = dt.to_f64();
        let speed = velocity.bound + dt * self.pull(gas);
        self.in_range(Quantity::Velocity, velocity.with(speed))?;
        let mass = smallest(gas.mass.iter().copied());
        let power = Largest::of(gas.power.iter().copied());
        let heating = (power.bound / mass).min(S::LARGEST.to_f64());
        let energy = Largest::of(gas.energy.iter().copied());
        let energy = energy.with(energy.bound + dt * heating);
        self.in_range(Quantity::Energy, energy)?;
        let density = Largest::of(gas.density.iter().copied());
        let densities = [smallest(gas.density.iter().copied()), density.bound];
        for law in self.materials {
            // The sum of two densities, or twice their difference, is on the way to what compression does.
            let bound = law
                .largest(densities, energy.bound)
                .max(2.0 * density.bound);
            self.in_range(Quantity::Pressure, density.with(bound))?;
        }
        self.prove_waves(velocity.with(speed), densities, energy.bound)?;
        let width = Largest::of(gas.epsilon.iter().copied());
        let powers = (0..D + 2).fold(1.0, |power, _| power * width.bound);
        self.in_range(Quantity::Epsilon, width.with(powers))
    }

    /// Whether the pressures beyond open sides, `p + ρ c w`, stay in the range: of speeds, densities
    /// and an energy in that of the laws.
    fn prove_waves(&self, speed: Largest, densities: [f64; 2], energy: f64) -> Result<(), Error> {
        // No law's sound speed has its largest value between the densities.
        let of = |law: &E| {
            let sound_speed = |density| {
                let law = law.sound_speed(S::from_f64(density), S::from_f64(energy));
                law.to_f64()
            };
            densities.map(sound_speed).into_iter().fold(0.0, f64::max)
        };
        let sound_speed = self.materials.iter().map(of).fold(0.0, f64::max);
        let impedance = speed.with(densities[1] * sound_speed);
        for far in self.physics.plain().far.iter().flatten() {
            let own = far.density.to_f64() * far.sound_speed.to_f64();
            let excess = speed.bound + far.velocity.to_f64().abs();
            let wave = 0.5 * (own + impedance.bound) * excess;
            self.in_range(Quantity::Velocity, speed.with(excess))?;
            self.in_range(Quantity::Pressure, impedance)?;
            self.in_range(
                Quantity::Pressure,
                speed.with(own * far.sound_speed.to_f64()),
            )?;
            self.in_range(
                Quantity::Pressure,
                speed.with(far.pressure.to_f64().abs() + wave),
            )?;
        }
        Ok(())
    }

    /// A bound of the acceleration; the quotient saturates.
    fn pull(&self, gas: &Gas<'_, S, D>) -> f64 {
        let force = longest(gas.force).bound;
        (force / smallest(gas.mass.iter().copied())).min(S::LARGEST.to_f64())
    }

    fn in_range(&self, quantity: Quantity, largest: Largest) -> Result<(), Error> {
        holds::<S>(quantity, largest.place as u32, largest.bound)
    }

    /// Proves something of a gas in a format that wraps.
    pub(super) fn proven(
        &self,
        engine: &mut impl Engine<S, D>,
        proof: impl FnOnce() -> Result<(), Error>,
    ) -> Result<(), Error> {
        match S::WRAPS {
            true => proof().or_else(|error| engine.unproven(error)),
            false => Ok(()),
        }
    }
}
