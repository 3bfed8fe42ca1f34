//! What a run steps: a first-order system, or convection-diffusion.

use motes_core::cutoff::CutOff;
use motes_core::equation::linear::{
    FirstOrderSystem, LinearDynamics, LinearWorkspace, NamedField, Particle, Place, State,
};
use motes_core::error::Error;
use motes_core::integrator::RungeKutta;
use motes_core::scalar::Scalar;

use super::arrays::LinearArrays;
use crate::engine::{HostScalar, Threads};

/// A solver of an equation for strengths on particles that follow a field.
pub(super) trait Solver<S: HostScalar, const D: usize, const P: usize> {
    /// The state and the workspace in memory.
    type Arrays;
    /// The workspace.
    type Work<'a>;

    /// A cloud of these particles; ids are places.
    fn arrays(&self, particles: Vec<Particle<S, D, P>>) -> Self::Arrays;
    /// The state and the workspace.
    fn parts(arrays: &mut Self::Arrays) -> (State<'_, S, D, P>, Self::Work<'_>);

    /// Checks a state and makes what the first step needs.
    fn prepare(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
    ) -> Result<(), Error>;

    /// The largest stable step; `None` where nothing bounds it.
    fn stable_step(&self, state: &State<'_, S, D, P>, work: &Self::Work<'_>, time: S) -> Option<S>;

    /// The step to make, at most `longest`.
    fn time_step(
        &self,
        state: &State<'_, S, D, P>,
        work: &Self::Work<'_>,
        time: S,
        longest: S,
    ) -> Result<S, Error>;

    /// Makes a step `(time, dt)`; how many right-hand sides that took.
    fn advance(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        step: (S, S),
    ) -> Result<u32, Error>;

    /// Counts neighbours where steps do not. Changes no bit of the run.
    fn count_neighbours(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        time: S,
    ) -> Result<(), Error>;

    /// The reconstruction (1.13) at some points, of a run at its end.
    fn reconstruct(
        &self,
        state: &State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        time: S,
        points: &[[S; D]],
        values: &mut [[S; P]],
    ) -> Result<(), Error>;

    /// `u·Pu`, whose weighted sum is the square of the energy norm.
    fn energy_density(&self, place: &Place<S, D>, u: &[S; P]) -> S;
    /// `f(x,t)`.
    fn source(&self, place: &Place<S, D>) -> [S; P];
    /// `λ` with `‖u‖' <= λ ‖u‖ + ‖f‖`; `None` where nothing bounds the norm.
    fn growth(&self) -> Option<f64>;
    /// The order of the time integrator.
    fn order(&self) -> u32;

    /// The part of the state in waves that the solver does not damp as it should, of a run at its
    /// end; 0 where there are no such waves.
    fn undamped(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        time: S,
    ) -> Result<f64, Error> {
        let _ = (engine, state, work, time);
        Ok(0.0)
    }
}

/// A first-order system (1.18), stepped by a Runge-Kutta method.
pub(super) struct FirstOrder<S, C, F, const D: usize, const P: usize> {
    pub dynamics: LinearDynamics<S, C, F, NamedField<S, D>, D, P>,
    pub method: RungeKutta,
}

impl<S: HostScalar, C, F, const D: usize, const P: usize> Solver<S, D, P>
    for FirstOrder<S, C, F, D, P>
where
    C: CutOff,
    F: FirstOrderSystem<S, D, P> + 'static,
{
    type Arrays = LinearArrays<S, F::Medium, D, P>;
    type Work<'a> = LinearWorkspace<'a, S, F::Medium, D, P>;

    fn arrays(&self, particles: Vec<Particle<S, D, P>>) -> Self::Arrays {
        LinearArrays::new(&particles)
    }
    fn parts(arrays: &mut Self::Arrays) -> (State<'_, S, D, P>, Self::Work<'_>) {
        arrays.parts()
    }

    fn prepare(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
    ) -> Result<(), Error> {
        self.dynamics.prepare(engine, state, work)
    }

    fn stable_step(&self, state: &State<'_, S, D, P>, _: &Self::Work<'_>, time: S) -> Option<S> {
        let stability = self.method.stability();
        self.dynamics.stable_step(state, time, stability)
    }

    fn time_step(
        &self,
        state: &State<'_, S, D, P>,
        _: &Self::Work<'_>,
        time: S,
        longest: S,
    ) -> Result<S, Error> {
        let stability = self.method.stability();
        self.dynamics.time_step(state, time, stability, longest)
    }

    fn advance(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        step: (S, S),
    ) -> Result<u32, Error> {
        self.dynamics
            .advance(&self.method, engine, state, work, step)?;
        Ok(self.method.sides())
    }

    fn count_neighbours(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        time: S,
    ) -> Result<(), Error> {
        self.dynamics.count_neighbours(engine, state, work, time)
    }

    fn reconstruct(
        &self,
        state: &State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        _: S,
        points: &[[S; D]],
        values: &mut [[S; P]],
    ) -> Result<(), Error> {
        self.dynamics.reconstruct(state, work, points, values)
    }

    fn energy_density(&self, place: &Place<S, D>, u: &[S; P]) -> S {
        self.dynamics.energy_density(place, u)
    }
    fn source(&self, place: &Place<S, D>) -> [S; P] {
        self.dynamics.system.source(place)
    }
    fn growth(&self) -> Option<f64> {
        Some(Scalar::to_f64(self.dynamics.system.growth()))
    }
    fn order(&self) -> u32 {
        self.method.order
    }
}
