//! Leap-frog, kick-drift-kick (Richtmyer & Morton 1967, as the paper uses it).
//!
//! `u^(n+1/2) = u^n + dt/2 a^n`, `x^(n+1) = x^n + dt u^(n+1/2)`; densities and forces at
//! `x^(n+1)` with the predicted `u^n + dt a^n` and `e^n + dt ė^n`; then
//! `u^(n+1) = u^(n+1/2) + dt/2 a^(n+1)`, and `e` likewise. Second order in `dt`.

use crate::cutoff::CutOff;
use crate::equation::gas::{Gas, GasDynamics, Physics, Viscosity, Workspace};
use crate::error::Error;
use crate::material::EquationOfState;
use crate::pairs::Engine;
use crate::scalar::Scalar;

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
        let half = dt.half();
        let particles = gas
            .position
            .iter_mut()
            .zip(gas.velocity.iter_mut())
            .zip(gas.force.iter_mut())
            .zip(gas.mass.iter());
        for (id, (((position, velocity), force), &mass)) in particles.enumerate() {
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
        self.rates(engine, gas, work, dt)
    }
}
