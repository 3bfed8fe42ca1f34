//! Leap-frog, kick-drift-kick, as the paper names it (Richtmyer & Morton 1967).
//!
//! - kick: `u^(n+1/2) = u^n + dt/2 a^n`, and `e` by `dt/2` of the heat q of viscosity and conduction;
//! - drift: `x^(n+1) = x^n + dt u^(n+1/2)`; densities there; `de = p dρ/ρ²` from the old to the new one
//!   ([`EquationOfState::compressed`]);
//! - forces and heat there, where viscosity needs a velocity with `u^n + dt a^n`;
//! - kick: `u^(n+1) = u^(n+1/2) + dt/2 a^(n+1)`, and `e` by `dt/2 q^(n+1)`.
//!
//! Second order in `dt`. Without dissipation the pressure is a function of the positions, so that the
//! scheme is symplectic, stable for `ω dt < 2`, and leads back the way it came: the energy oscillates
//! and does not drift.
//!
//! Differs from the paper: velocities are known at whole steps, those between are not kept. In
//! [`EnergyForm::Exact`] and [`EnergyForm::Total`] pressures are made likewise, and the energy by the
//! forces and velocities of whole steps: the total is conserved for any step, and waves that are
//! barely resolved in time, `ω dt` near 1, lose to heat what they do not lose in LeapFrog.

use crate::cutoff::CutOff;
use crate::domain::Beyond;
use crate::error::Error;
use crate::material::EquationOfState;
use crate::numbered::numbered;
use crate::pairs::Engine;
use crate::scalar::Scalar;

use super::dynamics::GasDynamics;
use super::options::EnergyForm;
use super::physics::Physics;
use super::state::{Gas, Row};
use super::storage::Workspace;
use super::viscosity::Viscosity;

impl<S, C, V, E, P, const D: usize> GasDynamics<'_, S, C, V, E, P, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
    P: Physics<S, D>,
{
    /// Advances a prepared state by `dt`. On an error the state is between two steps and
    /// must not be used further.
    pub fn advance(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, P::Shown, D>,
        dt: S,
    ) -> Result<(), Error> {
        self.proven(engine, || self.prove_drift(gas, dt))?;
        self.drift(gas, dt)?;
        self.rates(engine, gas, work, dt)
    }

    /// The first kick and the drift: `x + dt (u + dt/2 a)`. Velocities are kicked where the step is
    /// closed, by both accelerations at once.
    fn drift(&self, gas: &mut Gas<'_, S, D>, dt: S) -> Result<(), Error> {
        let half = dt.half();
        let particles = gas
            .position
            .iter_mut()
            .zip(gas.velocity.iter_mut())
            .zip(gas.force.iter_mut())
            .zip(gas.mass.iter());
        for (id, (((position, velocity), force), &mass)) in numbered(particles) {
            let mut step = *velocity;
            for (component, &force) in step.iter_mut().zip(force.iter()) {
                *component = dt * (*component + half * (force / mass));
            }
            let reflected = self.domain.drift(position, &step, id as u32)?;
            let components = velocity.iter_mut().zip(force.iter_mut()).zip(reflected);
            for ((velocity, force), reflected) in components {
                if reflected {
                    (*velocity, *force) = (-*velocity, -*force);
                }
            }
        }
        Ok(())
    }

    /// Gives a particle the density at the end of its drift. Returns the internal energy that its
    /// pressure is made of: heated for half a step, compressed, and heated by as much again, where
    /// the heat of the end is not known yet; it is kept from falling below 0.
    ///
    /// A state that no step has led to has no density that it comes from; its energy is as given.
    #[inline(always)]
    pub(super) fn compress(&self, row: &mut Row<'_, S, D>, density: S, dt: S) -> S {
        let before = core::mem::replace(row.density, density);
        let beyond = self.domain.beyond(row.position);
        if !(dt > S::ZERO) || !(before > S::ZERO) || beyond == Some(Beyond::Inflow) {
            return row.energy.greater(S::ZERO);
        }
        if beyond.is_some() {
            // What goes out loses its partners, and with them its density, to the open side.
            let gained = dt * (row.internal_power(self.physics.energy()) / row.mass);
            return (*row.energy + gained).greater(S::ZERO);
        }
        let heat = row.half_heat(dt);
        let mut energy = *row.energy + heat;
        if let Some(law) = self.materials.get(usize::from(row.material)) {
            energy = law.compressed([before, density], energy);
        }
        // Elsewhere the forces say what the energy is.
        if self.physics.energy() == EnergyForm::LeapFrog {
            *row.energy = energy;
        }
        (energy + heat).greater(S::ZERO)
    }
}

impl<S: Scalar, const D: usize> Row<'_, S, D> {
    /// The velocity at the end of a step, predicted by the force at its start.
    #[inline(always)]
    pub(super) fn predicted(&self, dt: S) -> [S; D] {
        let mut velocity = *self.velocity;
        for (u, &force) in velocity.iter_mut().zip(self.force.iter()) {
            *u += dt * (force / self.mass);
        }
        velocity
    }

    /// Half a kick with the force held, half a kick with the new one, which takes its place.
    #[inline(always)]
    pub(super) fn kick(&mut self, dt: S, force: [S; D]) {
        let half = dt.half();
        let components = self
            .velocity
            .iter_mut()
            .zip(self.force.iter_mut())
            .zip(force);
        for ((u, old), new) in components {
            *u += half * (*old / self.mass);
            *u += half * (new / self.mass);
            *old = new;
        }
    }

    /// `m de/dt` as `power` has it.
    #[inline(always)]
    pub(super) fn internal_power(&self, form: EnergyForm) -> S {
        match form {
            EnergyForm::Total => *self.power - S::dot(self.velocity, self.force),
            EnergyForm::LeapFrog | EnergyForm::Exact => *self.power,
        }
    }

    /// What the heat of a moment adds to the internal energy in half a step.
    #[inline(always)]
    fn half_heat(&self, dt: S) -> S {
        dt.half() * (*self.heat / self.mass)
    }

    /// Half a kick of the internal energy by the new heat, which takes the place of the one held.
    #[inline(always)]
    pub(super) fn warm(&mut self, dt: S, heat: S) {
        *self.heat = heat;
        *self.energy += self.half_heat(dt);
    }

    /// Both halves of a step by a power and the one that takes its place.
    #[inline(always)]
    pub(super) fn flow(&mut self, dt: S, power: S) {
        let half = dt.half();
        *self.energy += half * (*self.power / self.mass);
        *self.energy += half * (power / self.mass);
        *self.power = power;
    }
}
