//! A first-order system in the scalar of a run.

use motes_core::cutoff::Named;
use motes_core::equation::linear::{FirstOrderSystem, LinearDynamics, NamedField, Particle, Place};
use motes_core::error::Error;
use motes_core::integrator::RungeKutta;
use motes_core::scalar::Scalar;

use super::memory::LinearArrays;
use crate::engine::{HostScalar, Threads};
use crate::families::strengths::{CloudArrays, Plan, Solver};

/// A first-order system (1.18), stepped by a Runge-Kutta method.
pub(in crate::families) struct FirstOrder<S, F, const D: usize, const P: usize> {
    dynamics: LinearDynamics<S, Named, F, NamedField<S, D>, D, P>,
    method: RungeKutta,
}

impl<S: HostScalar, F: FirstOrderSystem<S, D, P>, const D: usize, const P: usize>
    FirstOrder<S, F, D, P>
{
    /// The solver of a plan with that system.
    pub fn new(plan: &Plan, system: F) -> Self {
        Self {
            dynamics: LinearDynamics::new(
                plan.domain(),
                (plan.cut_off, S::from_f64(plan.epsilon)),
                system,
                plan.motion(),
                S::from_f64(plan.courant),
            ),
            method: plan.runge_kutta(),
        }
    }
}

impl<S, F, const D: usize, const P: usize> Solver<S, D, P> for FirstOrder<S, F, D, P>
where
    S: HostScalar,
    F: FirstOrderSystem<S, D, P> + Send + 'static,
    F::Medium: Send,
{
    type Memory = LinearArrays<S, F::Medium, D, P>;
    const BYTES: usize = LinearArrays::<S, F::Medium, D, P>::BYTES;

    fn memory(&self, particles: impl Iterator<Item = Particle<S, D, P>>) -> Self::Memory {
        LinearArrays::new(particles)
    }
    fn cloud(memory: &Self::Memory) -> &CloudArrays<S, D, P> {
        &memory.cloud
    }
    fn cloud_mut(memory: &mut Self::Memory) -> &mut CloudArrays<S, D, P> {
        &mut memory.cloud
    }

    fn prepare(&self, engine: &mut Threads, memory: &mut Self::Memory) -> Result<(), Error> {
        let (mut state, mut work) = memory.parts();
        self.dynamics.prepare(engine, &mut state, &mut work)
    }

    fn stable_step(&self, memory: &mut Self::Memory, time: S) -> Result<Option<S>, Error> {
        let stability = self.method.stability();
        self.dynamics
            .stable_step(&memory.parts().0, time, stability)
    }

    fn time_step(&self, memory: &mut Self::Memory, time: S, longest: S) -> Result<S, Error> {
        let stability = self.method.stability();
        self.dynamics
            .time_step(&memory.parts().0, time, stability, longest)
    }

    fn advance(
        &self,
        engine: &mut Threads,
        memory: &mut Self::Memory,
        step: (S, S),
    ) -> Result<u32, Error> {
        let (mut state, mut work) = memory.parts();
        self.dynamics
            .advance(&self.method, engine, &mut state, &mut work, step)?;
        Ok(self.method.sides())
    }

    fn count_neighbours(
        &self,
        engine: &mut Threads,
        memory: &mut Self::Memory,
        time: S,
    ) -> Result<(), Error> {
        let (mut state, mut work) = memory.parts();
        self.dynamics
            .count_neighbours(engine, &mut state, &mut work, time)
    }

    fn reconstruct(
        &self,
        memory: &mut Self::Memory,
        _: S,
        points: &[[S; D]],
        values: &mut [[S; P]],
    ) -> Result<(), Error> {
        let (state, mut work) = memory.parts();
        self.dynamics.reconstruct(&state, &mut work, points, values)
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
