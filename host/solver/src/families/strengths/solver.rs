//! What a run of strengths needs of its equation.

use std::sync::Arc;

use motes_core::cloud::Words;
use motes_core::digest::Digest;
use motes_core::error::Error;
use motes_core::scalar::Scalar;

use super::balance::Source;
use super::particles::Particles;
use super::plan::Plan;
use crate::engine::{HostScalar, Threads};

/// A cloud of strengths and the solver of its equation, in the scalar of a run.
///
/// Dimension and components are behind it, so that a run is compiled once for a scalar and not for each
/// system: what it looks at are rows of numbers.
pub(in crate::families) trait Solver<S: HostScalar>: Send {
    /// What there is to see.
    fn cloud(&self) -> CloudView<'_, S>;
    /// The digest of the state.
    fn digest(&mut self) -> Digest;
    /// The same in any order of the particles.
    fn digest_unordered(&mut self) -> Digest;
    /// Bytes of a particle that the next step starts from.
    fn state_bytes(&mut self) -> usize;
    /// What has come in from a source so far, in units of a strength; `None` where that is not counted.
    fn intake(&self, source: Source) -> Option<f64> {
        let _ = source;
        None
    }

    /// Checks a state and makes what the first step needs.
    fn prepare(&mut self, engine: &mut Threads) -> Result<(), Error>;

    /// The largest stable step; `None` where nothing bounds it.
    ///
    /// # Errors
    /// Of the solver.
    fn stable_step(&mut self, time: S) -> Result<Option<S>, Error>;

    /// The step to make, at most `longest`.
    fn time_step(&mut self, time: S, longest: S) -> Result<S, Error>;

    /// Makes a step `(time, dt)`; how many right-hand sides that took.
    fn advance(&mut self, engine: &mut Threads, step: (S, S)) -> Result<u32, Error>;

    /// Passes all that the next step starts from.
    fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error>;

    /// Counts neighbours where steps do not. Changes no bit of the run.
    fn count_neighbours(&mut self, engine: &mut Threads, time: S) -> Result<(), Error> {
        let _ = (engine, time);
        Ok(())
    }

    /// The reconstruction (1.13) at some points, at the particles without any, of a run at its end: rows
    /// of all components.
    fn reconstruct(&mut self, time: S, points: Option<&[[S; 3]]>) -> Result<Vec<S>, Error>;

    /// `u·Pu` at a place, whose weighted sum is the square of the energy norm.
    fn energy_density(&self, x: &[S], time: S, u: &[S]) -> S;
    /// `f(x,t)`, into `rates`.
    fn source(&self, x: &[S], time: S, rates: &mut [S]);
    /// `λ` with `‖u‖' <= λ ‖u‖ + ‖f‖`; `None` where nothing bounds the norm.
    fn growth(&self) -> Option<f64>;
    /// The order of the time integrator.
    fn order(&self) -> u32;

    /// The part of the state in waves that the solver does not damp as it should, of a run at its
    /// end; 0 where there are no such waves.
    fn undamped(&mut self, engine: &mut Threads, time: S) -> Result<f64, Error> {
        let _ = (engine, time);
        Ok(0.0)
    }
}

/// A solver that can be made for the particles of a plan.
pub(in crate::families) struct Maker<S> {
    /// Bytes that one particle takes in memory.
    pub bytes: usize,
    /// Makes it; ids are places.
    pub make: Box<Make<S>>,
}

type Make<S> = dyn FnOnce(&Arc<Plan>, Particles) -> Box<dyn Solver<S>>;

/// The arrays of a cloud, row after row.
#[derive(Clone, Copy)]
pub(in crate::families) struct CloudView<'a, S: Scalar> {
    /// Numbers in a position.
    pub dimension: usize,
    /// Numbers in a value. They may exceed the components of the plan: those beyond stay 0.
    pub components: usize,
    /// `x`.
    pub position: &'a [S],
    /// `w`.
    pub weight: &'a [S],
    /// `u`.
    pub value: &'a [S],
    /// `q`.
    pub strength: &'a [S::Wide],
    /// Partners within the support.
    pub neighbours: &'a [S],
}

impl<'a, S: Scalar> CloudView<'a, S> {
    /// The positions.
    pub fn positions(self) -> impl Iterator<Item = &'a [S]> {
        self.position.chunks_exact(self.dimension)
    }
    /// The values.
    pub fn values(self) -> impl Iterator<Item = &'a [S]> {
        self.value.chunks_exact(self.components)
    }
    /// The strengths of a component.
    pub fn strengths(self, component: usize) -> impl Iterator<Item = S::Wide> {
        let rows = self.strength.chunks_exact(self.components);
        rows.map(move |q| q[component])
    }
}

/// A row as the solvers of a dimension, and of a number of components, take it.
pub(in crate::families) fn row<S: Scalar, const N: usize>(row: &[S]) -> [S; N] {
    std::array::from_fn(|i| row.get(i).copied().unwrap_or(S::ZERO))
}
