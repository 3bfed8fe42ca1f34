//! A linear system as a [`Dynamics`]: by a Runge-Kutta method.

use crate::cloud::{Particle, State, VelocityField, Words};
use crate::cutoff::CutOff;
use crate::equation::linear::{FirstOrderSystem, LinearDynamics, LinearWorkspace};
use crate::equation::{Dynamics, Parts, Step};
use crate::error::Error;
use crate::integrator::RungeKutta;
use crate::pairs::Engine;
use crate::scalar::Scalar;

impl<S, C, F, A, const D: usize, const P: usize> Dynamics<S, D> for LinearDynamics<S, C, F, A, D, P>
where
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, D, P>,
    A: VelocityField<S, D>,
{
    type Method = RungeKutta;
    type State<'a> = State<'a, S, D, P>;
    type Work<'a> = LinearWorkspace<'a, S, F::Medium, D, P>;
    type Particle = Particle<S, D, P>;

    fn prepare<E: Engine<S, D>>(
        &self,
        engine: &mut E,
        parts: &mut Parts<'_, S, Self, D>,
    ) -> Result<(), Error> {
        self.prepare(engine, &mut parts.state, &mut parts.work)
    }

    fn resume<E: Engine<S, D>>(
        &self,
        _: &mut E,
        parts: &mut Parts<'_, S, Self, D>,
        _: S,
    ) -> Result<(), Error> {
        *parts.work.grid = None;
        Ok(())
    }

    fn pass(&self, parts: &mut Parts<'_, S, Self, D>, words: &mut dyn Words) -> Result<(), Error> {
        if words.fills() {
            *parts.work.grid = None;
        }
        words.columns(&mut parts.state)
    }

    fn stable_step(
        &self,
        method: &RungeKutta,
        parts: &Parts<'_, S, Self, D>,
        time: S,
        longest: S,
    ) -> Result<S, Error> {
        self.time_step(&parts.state, time, method.stability(), longest)
    }

    fn advance<E: Engine<S, D>>(
        &self,
        method: &RungeKutta,
        engine: &mut E,
        parts: &mut Parts<'_, S, Self, D>,
        step: Step<S>,
    ) -> Result<u32, Error> {
        let (state, work) = (&mut parts.state, &mut parts.work);
        self.advance(method, engine, state, work, (step.time, step.dt))?;
        Ok(method.sides())
    }
}
