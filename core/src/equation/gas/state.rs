//! The state of a gas: arrays side by side, in memory that belongs to the caller.

use crate::cloud::{Columns, Unit, columns};
use crate::digest::Digest;
use crate::error::{Error, Quantity};
use crate::scalar::Scalar;

use super::options::EnergyForm;

/// A particle as it is put into a cloud.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle<S, const D: usize> {
    /// Position.
    pub position: [S; D],
    /// Velocity.
    pub velocity: [S; D],
    /// Mass, > 0.
    pub mass: S,
    /// Internal energy per mass, >= 0.
    pub energy: S,
    /// What ε is expected to be; the first density sum corrects it.
    pub epsilon: S,
    /// Number of its material.
    pub material: u8,
}

impl<const D: usize> Particle<f64, D> {
    /// The particle in the scalar of a run, every number rounded once.
    pub fn rounded<S: Scalar>(&self) -> Particle<S, D> {
        Particle {
            position: self.position.map(S::from_f64),
            velocity: self.velocity.map(S::from_f64),
            mass: S::from_f64(self.mass),
            energy: S::from_f64(self.energy),
            epsilon: S::from_f64(self.epsilon),
            material: self.material,
        }
    }
}

/// The state: one array a quantity, all of the same length, indexed by particle id.
///
/// The first five make the state of the paper; the others are made from them, and are part
/// of the state because the next step starts from them.
pub struct Gas<'a, S, const D: usize> {
    /// `x`.
    pub position: &'a mut [[S; D]],
    /// `u`.
    pub velocity: &'a mut [[S; D]],
    /// What rounding has kept from the positions so far: [`Scalar::step`].
    pub position_remainder: &'a mut [[S; D]],
    /// The same of the velocities.
    pub velocity_remainder: &'a mut [[S; D]],
    /// `e`, internal energy per mass.
    pub energy: &'a mut [S],
    /// `m`; never changes.
    pub mass: &'a mut [S],
    /// Place of the material in [`GasDynamics::materials`](super::GasDynamics::materials);
    /// never changes.
    pub material: &'a mut [u8],
    /// ε.
    pub epsilon: &'a mut [S],
    /// ρ.
    pub density: &'a mut [S],
    /// `m du/dt`.
    pub force: &'a mut [[S; D]],
    /// `m de/dt`, or the rate of total energy in [`EnergyForm::Total`].
    pub power: &'a mut [S],
    /// The part of `m de/dt` that compression does not give: of viscosity and conduction.
    pub heat: &'a mut [S],
    /// What `power` gains in a unit of time while the forces do not change; 0 but in
    /// [`EnergyForm::Exact`].
    pub power_slope: &'a mut [S],
    /// Factor of the viscosity's α, in [0, 1], that of [`super::Switch`]; without one
    /// Balsara's factor of the whole viscosity.
    pub viscosity_factor: &'a mut [S],
    /// `div u`.
    pub divergence: &'a mut [S],
    /// The fastest approach of a partner along the line of centres, >= 0.
    pub approach: &'a mut [S],
    /// The speed that bounds the time step, see [`super::Viscosity::signal`].
    pub signal: &'a mut [S],
    /// Partners within the support of the last ε that was summed over (the final one may
    /// differ by [`Scalar::EXTRAPOLATION`]), without the particle itself.
    pub neighbours: &'a mut [S],
}

/// One particle of a [`Gas`]: its entry in every array.
pub(super) struct Row<'a, S, const D: usize> {
    pub(super) position: &'a [S; D],
    pub(super) velocity: &'a mut [S; D],
    pub(super) velocity_remainder: &'a mut [S; D],
    pub(super) energy: &'a mut S,
    pub(super) mass: S,
    pub(super) material: u8,
    pub(super) epsilon: &'a mut S,
    pub(super) density: &'a mut S,
    pub(super) force: &'a mut [S; D],
    pub(super) power: &'a mut S,
    pub(super) heat: &'a mut S,
    pub(super) power_slope: &'a mut S,
    pub(super) viscosity_factor: &'a mut S,
    pub(super) divergence: &'a mut S,
    pub(super) approach: &'a mut S,
    pub(super) signal: &'a mut S,
    pub(super) neighbours: &'a mut S,
}

/// What a particle that goes out sees of the gas around it.
pub(super) struct Wave<S, const D: usize> {
    /// Which way is out.
    pub(super) normal: [S; D],
    /// The force along it.
    pub(super) push: S,
    /// `m de/dt` of compression.
    pub(super) power: S,
}

columns! {
    impl [const D: usize] Gas<'_, S, D> {
        position: vectors, Position, Directions, Unit::LENGTH, State;
        velocity: vectors, Vector, Directions, Unit::VELOCITY, State;
        position_remainder: vectors, Vector, Directions, Unit::LENGTH, Carried;
        velocity_remainder: vectors, Vector, Directions, Unit::VELOCITY, Carried;
        energy: scalars, Scalar, One, Unit::VELOCITY.times(Unit::VELOCITY), State;
        mass: scalars, Scalar, One, Unit::MASS, State;
        material: integers, Integer, One, Unit::NONE, Carried;
        epsilon: scalars, Scalar, One, Unit::LENGTH, State;
        density: scalars, Scalar, One, Unit::MASS.times(Unit::VOLUME.inverse()), State;
        force: vectors, Vector, Directions, Unit::MASS.times(Unit::VELOCITY).times(RATE), State;
        power: scalars, Scalar, One, ENERGY.times(RATE), State;
        heat: scalars, Scalar, One, ENERGY.times(RATE), State;
        power_slope: scalars, Scalar, One, ENERGY.times(RATE).times(RATE), State;
        viscosity_factor: scalars, Scalar, One, Unit::NONE, State;
        divergence: scalars, Scalar, One, RATE, Carried;
        approach: scalars, Scalar, One, Unit::VELOCITY, Carried;
        signal: scalars, Scalar, One, Unit::VELOCITY, Carried;
        neighbours: scalars, Scalar, One, Unit::NONE, Derived;
    }
}

/// One over a time.
const RATE: Unit = Unit {
    time: -1,
    ..Unit::NONE
};
/// An energy.
const ENERGY: Unit = Unit::MASS.times(Unit::VELOCITY).times(Unit::VELOCITY);

impl<S: Scalar, const D: usize> Gas<'_, S, D> {
    /// The digest of the state: position, velocity, energy, mass, ε, density, force, power,
    /// heat, slope of the power and the factor of the viscosity, each for all particles in id order.
    pub fn digest(&self) -> Digest {
        Columns::digest(self)
    }

    /// The same in any order of the particles: [`Columns::digest_unordered`].
    pub fn digest_unordered(&self) -> Digest {
        Columns::digest_unordered(self)
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.mass.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.mass.is_empty()
    }

    /// Whether all arrays have the same length.
    pub(super) fn is_consistent(&self) -> bool {
        let n = self.mass.len();
        let vectors = [
            self.position.len(),
            self.velocity.len(),
            self.position_remainder.len(),
            self.velocity_remainder.len(),
            self.force.len(),
        ];
        let scalars = [
            self.energy.len(),
            self.epsilon.len(),
            self.density.len(),
            self.power.len(),
            self.heat.len(),
            self.power_slope.len(),
            self.viscosity_factor.len(),
            self.material.len(),
            self.divergence.len(),
            self.approach.len(),
            self.signal.len(),
            self.neighbours.len(),
        ];
        vectors.iter().chain(&scalars).all(|&length| length == n)
    }

    /// Particle `id` as it would be put into a cloud, and its density; `None` beyond the end.
    pub fn particle(&self, id: usize) -> Option<(Particle<S, D>, S)> {
        let particle = Particle {
            position: *self.position.get(id)?,
            velocity: *self.velocity.get(id)?,
            mass: *self.mass.get(id)?,
            energy: *self.energy.get(id)?,
            epsilon: *self.epsilon.get(id)?,
            material: *self.material.get(id)?,
        };
        Some((particle, *self.density.get(id)?))
    }

    /// The entries of particle `id`; `None` beyond the end.
    #[inline(always)]
    pub(super) fn row(&mut self, id: u32) -> Option<Row<'_, S, D>> {
        let id = id as usize;
        Some(Row {
            position: self.position.get(id)?,
            velocity: self.velocity.get_mut(id)?,
            velocity_remainder: self.velocity_remainder.get_mut(id)?,
            energy: self.energy.get_mut(id)?,
            mass: *self.mass.get(id)?,
            material: *self.material.get(id)?,
            epsilon: self.epsilon.get_mut(id)?,
            density: self.density.get_mut(id)?,
            force: self.force.get_mut(id)?,
            power: self.power.get_mut(id)?,
            heat: self.heat.get_mut(id)?,
            power_slope: self.power_slope.get_mut(id)?,
            viscosity_factor: self.viscosity_factor.get_mut(id)?,
            divergence: self.divergence.get_mut(id)?,
            approach: self.approach.get_mut(id)?,
            signal: self.signal.get_mut(id)?,
            neighbours: self.neighbours.get_mut(id)?,
        })
    }
}

impl<S: Scalar, const D: usize> Row<'_, S, D> {
    /// Goes out as a wave that runs outwards would have it; its energy answers to compression
    /// alone.
    #[inline(always)]
    pub(super) fn leave(&mut self, dt: S, wave: Wave<S, D>, form: EnergyForm) {
        *self.power = self.internal_power(form);
        self.kick(dt, wave.normal.map(|component| wave.push * component));
        self.flow(dt, wave.power);
        if form == EnergyForm::Total {
            *self.power += S::dot(self.velocity, self.force);
        }
        *self.heat = S::ZERO;
        *self.power_slope = S::ZERO;
    }

    /// Nothing acts on it: it goes on as it is.
    #[inline(always)]
    pub(super) fn hold(&mut self) {
        *self.force = [S::ZERO; D];
        *self.power = S::ZERO;
        *self.heat = S::ZERO;
        *self.power_slope = S::ZERO;
    }

    /// `|u|²/2`.
    #[inline(always)]
    pub(super) fn kinetic_energy(&self) -> S {
        S::dot(self.velocity, self.velocity).half()
    }

    /// The first thing wrong with the particle.
    pub(super) fn problem(&self, particle: u32, feels_energy: bool) -> Option<Error> {
        let not_finite = |quantity| Some(Error::NotFinite { particle, quantity });
        if !self.velocity.iter().all(|u| u.is_finite()) {
            not_finite(Quantity::Velocity)
        } else if !self.energy.is_finite() {
            not_finite(Quantity::Energy)
        } else if !self.density.is_finite() {
            not_finite(Quantity::Density)
        } else if !self.epsilon.is_finite() {
            not_finite(Quantity::Epsilon)
        } else if !self.force.iter().all(|f| f.is_finite()) {
            not_finite(Quantity::Force)
        } else if !self.power.is_finite() {
            not_finite(Quantity::Power)
        } else if feels_energy && *self.energy < S::ZERO {
            Some(Error::NegativeEnergy { particle })
        } else {
            None
        }
    }
}

/// A particle as it was before the last step.
#[derive(Clone, Copy, Debug)]
pub struct Before<S, const D: usize> {
    position: [S; D],
    velocity: [S; D],
    position_remainder: [S; D],
    velocity_remainder: [S; D],
    force: [S; D],
    /// Energy, ε, density, power, heat, slope, factor, divergence, approach, signal, neighbours.
    scalars: [S; 11],
}

impl<S: Scalar, const D: usize> Gas<'_, S, D> {
    /// Particle `id` as it is now; `None` beyond the end.
    pub fn kept(&self, id: usize) -> Option<Before<S, D>> {
        Some(Before {
            position: *self.position.get(id)?,
            velocity: *self.velocity.get(id)?,
            position_remainder: *self.position_remainder.get(id)?,
            velocity_remainder: *self.velocity_remainder.get(id)?,
            force: *self.force.get(id)?,
            scalars: [
                *self.energy.get(id)?,
                *self.epsilon.get(id)?,
                *self.density.get(id)?,
                *self.power.get(id)?,
                *self.heat.get(id)?,
                *self.power_slope.get(id)?,
                *self.viscosity_factor.get(id)?,
                *self.divergence.get(id)?,
                *self.approach.get(id)?,
                *self.signal.get(id)?,
                *self.neighbours.get(id)?,
            ],
        })
    }

    /// Makes particle `id` what it was; does nothing beyond the end.
    pub fn put_back(&mut self, id: usize, before: &Before<S, D>) {
        let vectors = [
            (&mut *self.position, before.position),
            (&mut *self.velocity, before.velocity),
            (&mut *self.position_remainder, before.position_remainder),
            (&mut *self.velocity_remainder, before.velocity_remainder),
            (&mut *self.force, before.force),
        ];
        for (array, value) in vectors {
            if let Some(entry) = array.get_mut(id) {
                *entry = value;
            }
        }
        let scalars = [
            &mut *self.energy,
            &mut *self.epsilon,
            &mut *self.density,
            &mut *self.power,
            &mut *self.heat,
            &mut *self.power_slope,
            &mut *self.viscosity_factor,
            &mut *self.divergence,
            &mut *self.approach,
            &mut *self.signal,
            &mut *self.neighbours,
        ];
        for (array, value) in scalars.into_iter().zip(before.scalars) {
            if let Some(entry) = array.get_mut(id) {
                *entry = value;
            }
        }
    }
}
