//! What both kinds of strengths need of their solver.

use motes_core::equation::diffusion::Ledger;
use motes_core::equation::linear::{Particle, Place};
use motes_core::error::Error;

use super::memory::CloudArrays;
use crate::engine::{HostScalar, Threads};

/// A solver of an equation for strengths on particles that follow a field, in the scalar of a run.
pub(in crate::families) trait Solver<S: HostScalar, const D: usize, const P: usize>:
    Send
{
    /// The state and the workspace in memory.
    type Memory: Send;

    /// Bytes that one particle takes there.
    const BYTES: usize;

    /// A cloud of these particles; ids are places.
    fn memory(&self, particles: impl Iterator<Item = Particle<S, D, P>>) -> Self::Memory;
    /// What there is to see of it.
    fn cloud(memory: &Self::Memory) -> &CloudArrays<S, D, P>;
    /// The same, to take a digest of.
    fn cloud_mut(memory: &mut Self::Memory) -> &mut CloudArrays<S, D, P>;

    /// What has come in through walls and from reactions, where that is counted.
    fn ledger(memory: &Self::Memory) -> Option<&Ledger<S, D, P>> {
        let _ = memory;
        None
    }

    /// Checks a state and makes what the first step needs.
    fn prepare(&self, engine: &mut Threads, memory: &mut Self::Memory) -> Result<(), Error>;

    /// The largest stable step; `None` where nothing bounds it.
    ///
    /// # Errors
    /// Of the solver.
    fn stable_step(&self, memory: &mut Self::Memory, time: S) -> Result<Option<S>, Error>;

    /// The step to make, at most `longest`.
    fn time_step(&self, memory: &mut Self::Memory, time: S, longest: S) -> Result<S, Error>;

    /// Makes a step `(time, dt)`; how many right-hand sides that took.
    fn advance(
        &self,
        engine: &mut Threads,
        memory: &mut Self::Memory,
        step: (S, S),
    ) -> Result<u32, Error>;

    /// Counts neighbours where steps do not. Changes no bit of the run.
    fn count_neighbours(
        &self,
        engine: &mut Threads,
        memory: &mut Self::Memory,
        time: S,
    ) -> Result<(), Error> {
        let _ = (engine, memory, time);
        Ok(())
    }

    /// The reconstruction (1.13) at some points, of a run at its end.
    fn reconstruct(
        &self,
        memory: &mut Self::Memory,
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
        memory: &mut Self::Memory,
        time: S,
    ) -> Result<f64, Error> {
        let _ = (engine, memory, time);
        Ok(0.0)
    }
}
