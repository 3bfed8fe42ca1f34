//! Leap-frog, kick-drift-kick, as the paper names it (Richtmyer & Morton 1967).
//!
//! - kick: `u^(n+1/2) = u^n + dt/2 a^n`, and `e` by `dt/2` of the heat q of viscosity and conduction;
//! - drift: `x^(n+1) = x^n + dt u^(n+1/2)`; densities there; `de = p dρ/ρ²` from the old to the new one
//!   ([`EquationOfState::compressed`]);
//! - forces and heat there, where viscosity needs a velocity with `u^n + dt a^n`;
//! - kick: `u^(n+1) = u^(n+1/2) + dt/2 a^(n+1)`, and `e` by `dt/2 q^(n+1)`.
//!
//! In shocks, where viscosity heats, e goes by the work of the forces instead; and everywhere with the
//! gradients of [`super::direction`], where the pressure of the new state is still that of the density.
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
            .zip(gas.position_remainder.iter_mut())
            .zip(gas.velocity_remainder.iter_mut())
            .zip(gas.force.iter_mut())
            .zip(gas.mass.iter());
        for (id, (((((position, velocity), left), slower), force), &mass)) in numbered(particles) {
            let mut step = *velocity;
            for i in 0..D {
                let speed = velocity[i] + half * (force[i] / mass);
                step[i] = position[i].step(dt, speed, &mut left[i]);
            }
            let reflected = self.domain.drift(position, &step, id as u32)?;
            for i in 0..D {
                if reflected[i] {
                    velocity[i] = -velocity[i];
                    left[i] = -left[i];
                    slower[i] = -slower[i];
                    force[i] = -force[i];
                }
            }
        }
        Ok(())
    }

    /// The internal energy that the pressure at the end of a drift to `density` is made of: heated
    /// for half a step, compressed, and heated by as much again, where the heat of the end is not known
    /// yet; it is kept from falling below 0.
    #[inline(always)]
    pub(super) fn expected_energy(&self, row: &Row<'_, S, D>, density: S, dt: S) -> S {
        let energy = match self.domain.beyond(row.position) {
            None => self.compressed(row, density, dt) + row.half_heat(dt),
            Some(Beyond::Inflow) => *row.energy,
            // What goes out loses its partners, and with them its density, to the open side.
            Some(Beyond::Outflow(_)) => {
                *row.energy + dt * (row.internal_power(self.physics.energy()) / row.mass)
            }
        };
        energy.greater(S::ZERO)
    }

    /// The internal energy after half a step's heat and the way from the row's density to `density`.
    ///
    /// A state that no step has led to has no density that it comes from; its energy is as given.
    #[inline(always)]
    fn compressed(&self, row: &Row<'_, S, D>, density: S, dt: S) -> S {
        let before = *row.density;
        let energy = *row.energy + row.half_heat(dt);
        match self.materials.get(usize::from(row.material)) {
            Some(law) if dt > S::ZERO && before > S::ZERO => {
                law.compressed([before, density], energy)
            }
            _ => energy,
        }
    }

    /// Closes the step of an internal energy that goes by leap-frog.
    ///
    /// What is compressed without heat follows its density. In a shock it does not: there heat and
    /// work make each other, and the energy that kinetic energy lost is the work of the forces. Between
    /// them the share of that work is `4 Q/(Q+P)`, at most 1, of the heat Q and the reversible power P
    /// of the step: 0 without dissipation, 1 where a third as much is heat.
    #[inline(always)]
    pub(super) fn close_energy(
        &self,
        row: &mut Row<'_, S, D>,
        density: S,
        [power, heat]: [S; 2],
        dt: S,
    ) {
        if !self.physics.follows_density() {
            row.flow(dt, power);
            *row.heat = heat;
            return;
        }
        let along = self.compressed(row, density, dt);
        let [old_power, old_heat] = [*row.power, *row.heat];
        let irreversible = old_heat.abs().half() + heat.abs().half();
        let reversible =
            (old_power.half() - old_heat.half()).abs() + (power.half() - heat.half()).abs();
        row.flow(dt, power);
        let by_work = core::mem::replace(row.energy, along);
        row.warm(dt, heat);
        if irreversible > S::ZERO {
            let share = irreversible / (irreversible + reversible);
            let share = share.lesser(S::ONE.half().half()) * S::count(4);
            *row.energy += share * (by_work - *row.energy);
        }
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
        for i in 0..D {
            let u = &mut self.velocity[i];
            for force in [self.force[i], force[i]] {
                *u += u.step(half, force / self.mass, &mut self.velocity_remainder[i]);
            }
            self.force[i] = force[i];
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
