//! A first-order system in the scalar of a run.

use std::sync::Arc;

use motes_core::cloud::{Columns as _, Words};
use motes_core::cutoff::Named;
use motes_core::digest::Digest;
use motes_core::equation::linear::{FirstOrderSystem, LinearDynamics, Place};
use motes_core::equation::{Dynamics, Parts};
use motes_core::error::Error;
use motes_core::integrator::RungeKutta;
use motes_core::scalar::Scalar;

use super::memory::LinearArrays;
use crate::engine::{HostScalar, Threads};
use crate::families::strengths::{CloudView, Maker, Plan, RunField, Solver, row};

/// A first-order system (1.18), stepped by a Runge-Kutta method.
pub(in crate::families) struct FirstOrder<S, F, const D: usize, const P: usize>
where
    S: HostScalar,
    F: FirstOrderSystem<S, D, P>,
{
    dynamics: LinearDynamics<S, Named, F, RunField<S, D>, D, P>,
    method: RungeKutta,
    /// Whether the system says how fast its energy norm may grow.
    is_bounded: bool,
    memory: LinearArrays<S, F::Medium, D, P>,
}

impl<S, F, const D: usize, const P: usize> FirstOrder<S, F, D, P>
where
    S: HostScalar,
    F: FirstOrderSystem<S, D, P> + Send + 'static,
    F::Medium: Send,
{
    /// Makes the solver of a plan with that system.
    pub fn maker(system: F) -> Maker<S> {
        Maker {
            bytes: LinearArrays::<S, F::Medium, D, P>::BYTES,
            make: Box::new(move |plan: &Arc<Plan>, particles| {
                Box::new(Self {
                    dynamics: LinearDynamics::new(
                        plan.domain(),
                        (plan.cut_off, S::from_f64(plan.epsilon)),
                        system,
                        plan.motion(),
                        S::from_f64(plan.courant),
                    ),
                    method: plan.runge_kutta(),
                    // That of matrices of formulas is the norm of u itself.
                    is_bounded: plan.waves.is_none(),
                    memory: LinearArrays::new(particles.rows()),
                })
            }),
        }
    }
}

impl<S, F, const D: usize, const P: usize> Solver<S> for FirstOrder<S, F, D, P>
where
    S: HostScalar,
    F: FirstOrderSystem<S, D, P> + Send + 'static,
    F::Medium: Send,
{
    fn cloud(&self) -> CloudView<'_, S> {
        self.memory.cloud.view()
    }
    fn digest(&mut self) -> Digest {
        self.memory.cloud.parts().0.digest()
    }
    fn digest_unordered(&mut self) -> Digest {
        self.memory.cloud.parts().0.digest_unordered()
    }
    fn state_bytes(&mut self) -> usize {
        self.memory.cloud.parts().0.state_bytes()
    }

    fn prepare(&mut self, engine: &mut Threads) -> Result<(), Error> {
        let (mut state, mut work) = self.memory.parts();
        self.dynamics.prepare(engine, &mut state, &mut work)
    }

    fn stable_step(&mut self, time: S) -> Result<Option<S>, Error> {
        let stability = self.method.stability();
        let (state, _) = self.memory.parts();
        self.dynamics.stable_step(&state, time, stability)
    }

    fn time_step(&mut self, time: S, longest: S) -> Result<S, Error> {
        let stability = self.method.stability();
        let (state, _) = self.memory.parts();
        self.dynamics.time_step(&state, time, stability, longest)
    }

    fn advance(&mut self, engine: &mut Threads, step: (S, S)) -> Result<u32, Error> {
        let (mut state, mut work) = self.memory.parts();
        self.dynamics
            .advance(&self.method, engine, &mut state, &mut work, step)?;
        Ok(self.method.sides())
    }

    fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        let (state, work) = self.memory.parts();
        Dynamics::pass(&self.dynamics, &mut Parts { state, work }, words)
    }

    fn count_neighbours(&mut self, engine: &mut Threads, time: S) -> Result<(), Error> {
        let (mut state, mut work) = self.memory.parts();
        self.dynamics
            .count_neighbours(engine, &mut state, &mut work, time)
    }

    fn reconstruct(&mut self, _: S, points: Option<&[[S; 3]]>) -> Result<Vec<S>, Error> {
        let points = self.memory.cloud.points(points);
        let mut values = vec![[S::ZERO; P]; points.len()];
        let (state, mut work) = self.memory.parts();
        self.dynamics
            .reconstruct(&state, &mut work, &points, &mut values)?;
        Ok(values.into_flattened())
    }

    fn energy_density(&self, x: &[S], time: S, u: &[S]) -> S {
        let position = row(x);
        self.dynamics
            .energy_density(&Place { position, time }, &row(u))
    }
    fn source(&self, x: &[S], time: S, rates: &mut [S]) {
        let position = row(x);
        let source = self.dynamics.system.source(&Place { position, time });
        rates.copy_from_slice(&source);
    }
    fn growth(&self) -> Option<f64> {
        self.is_bounded
            .then(|| Scalar::to_f64(self.dynamics.system.growth()))
    }
    fn order(&self) -> u32 {
        self.method.order
    }
}
