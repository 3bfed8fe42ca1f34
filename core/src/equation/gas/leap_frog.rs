//! Leap-frog, kick-drift-kick, as the paper names it (Richtmyer & Morton 1967).
//!
//! - kick and drift: `u^(n+1/2) = u^n + dt/2 a^n`, `x^(n+1) = x^n + dt u^(n+1/2)`;
//! - densities at `x^(n+1)`; forces there with the predicted `u^n + dt a^n` and `e^n + dt ė^n`
//!   (`Row::predicted`);
//! - kick: `u^(n+1) = u^(n+1/2) + dt/2 a^(n+1)`, and `e` likewise (`Row::kick`, `Row::heat`).
//!
//! Second order in `dt`.
//!
//! Differs from the paper: velocities are known at whole steps, those between are not kept, and `e` goes
//! by the trapezoidal rule with predicted values, where the staggered form takes the work of the
//! velocities at half steps.

use crate::cutoff::CutOff;
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
}

impl<S: Scalar, const D: usize> Row<'_, S, D> {
    /// Velocity and energy at the end of a step, predicted by the rates of its start. The
    /// prediction of energy is kept from falling below 0.
    #[inline(always)]
    pub(super) fn predicted(&self, dt: S, form: EnergyForm) -> ([S; D], S) {
        let mut velocity = *self.velocity;
        for (u, &force) in velocity.iter_mut().zip(self.force.iter()) {
            *u += dt * (force / self.mass);
        }
        let mut power = *self.power;
        if form == EnergyForm::Total {
            power -= S::dot(self.velocity, self.force);
        }
        let energy = *self.energy + dt * (power / self.mass);
        (velocity, energy.greater(S::ZERO))
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

    /// The same for the internal energy.
    #[inline(always)]
    pub(super) fn heat(&mut self, dt: S, power: S) {
        let half = dt.half();
        *self.energy += half * (*self.power / self.mass);
        *self.energy += half * (power / self.mass);
        *self.power = power;
    }
}
