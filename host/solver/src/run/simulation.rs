//! What every family of equations is seen as from outside.

use std::collections::BTreeMap;

use motes_core::cloud::Words;
use motes_core::digest::Digest;
use motes_core::error::Error;

use super::balance::Balance;
use super::description::Description;
use super::error::RunError;
use super::outcome::Outcome;
use super::schedule::Schedule;
use super::spread::{Spread, Spreading};
use crate::engine::Threads;

/// A step that has been made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Its length, in the scenario's unit of time.
    pub length: f64,
    /// Whether its length says something of the scheme; if not, of the end of the run alone.
    pub is_whole: bool,
    /// Right-hand sides that it took.
    pub evaluations: u32,
}

/// A particle in the scenario's units. One is filled in again and again, so that a cloud can be
/// looked at without being copied.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// Position; 0 beyond the dimension.
    pub position: [f64; 3],
    /// Its share of space.
    pub volume: f64,
    /// The values of its fields: [`Description::fields`] says which.
    pub values: Vec<f64>,
}

/// A sum that is conserved.
#[derive(Clone, Debug, PartialEq)]
pub struct Sum {
    /// It: one number, or the components of a vector.
    pub value: Vec<f64>,
    /// What its drift is compared with.
    pub size: f64,
}

/// What is measured between two steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Measures {
    /// A number for each of [`Description::diagnostics`].
    pub diagnostics: Vec<f64>,
    /// A sum for each of [`Description::sums`].
    pub sums: Vec<Sum>,
}

/// What summaries say of some simulations only.
#[derive(Clone, Debug, PartialEq)]
pub struct Particulars {
    /// Kind of the system.
    pub system: String,
    /// Names of the components.
    pub components: Vec<String>,
    /// Name of the time integrator.
    pub method: String,
    /// Width of the cut-off.
    pub epsilon: f64,
    /// The energy norm over the run.
    pub energy_norm: EnergyNorm,
}

/// The energy norm `(Σ w u·Pu)^(1/2)` over a run.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct EnergyNorm {
    /// At the start.
    pub first: f64,
    /// At the end.
    pub last: f64,
    /// What no solution exceeds at the end; `null` where nothing bounds them: driven walls, some
    /// reactions, a tensor in the direct form.
    pub bound: Option<f64>,
}

/// A run in memory, at some time. Numbers are in the scenario's units.
///
/// Looking changes no bit. Whatever its scalar, its dimension and its equations, it is one
/// `Box<dyn Simulation>`, made by the table of families.
pub trait Simulation: Send {
    /// What there is to see.
    fn description(&self) -> &Description;

    /// Time.
    fn time(&self) -> f64;
    /// Steps made.
    fn steps(&self) -> u64;
    /// The part of the run that is done, in [0, 1].
    fn done(&self) -> f64;
    /// Whether the end is reached.
    fn is_over(&self) -> bool;

    /// Shortens steps from now on so that some end at the times of a schedule.
    fn meet(&mut self, schedule: Schedule);

    /// Makes a step; `None` at the end.
    ///
    /// # Errors
    /// What [`RunError`] lists. The state is that of a step that was not finished then.
    fn step(&mut self, engine: &mut Threads) -> Result<Option<Step>, RunError>;

    /// Passes all that the next step starts from, and what is told of the way so far: saves it, or puts
    /// what was saved of a run of the same scenario in its place. The run then goes on with the bits
    /// that it would have had.
    ///
    /// # Errors
    /// Those of [`Words`]. A run that was to be read into is not to be used then.
    fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error>;

    /// Counts neighbours, and sums the forces on walls, where steps do not: [`Simulation::measures`] tells
    /// those of the last time.
    ///
    /// # Errors
    /// Of the solver.
    fn observe(&mut self, engine: &mut Threads) -> Result<(), RunError> {
        let _ = engine;
        Ok(())
    }

    /// Places in memory, at least as many as there are particles to see.
    fn places(&self) -> usize;
    /// Fills in the particle of a place; `false`, and nothing, where it lies beyond an open side.
    fn show(&self, place: usize, row: &mut Row) -> bool;

    /// Sums and diagnostics.
    fn measures(&self) -> Measures;
    /// What the sums should be now, from those at the start.
    fn expected(&self, first: Vec<Sum>) -> Vec<Sum> {
        first
    }
    /// The matrix P of the energy `u·Pu` of a state, row by row: it weighs components of unlike units
    /// against each other; empty where there is none, or where it is that of the squares alone.
    fn energy_weights(&self) -> Vec<f64> {
        Vec::new()
    }
    /// The neighbour counts of all particles to see.
    fn neighbours(&self) -> Spread;
    /// The mean width of the cut-off.
    fn width(&self) -> f64;
    /// The digest of the state: 64 bits that change when any bit of it does.
    fn digest(&mut self) -> Digest;
    /// The same whatever the order of the particles: a sum over them.
    fn digest_unordered(&mut self) -> Digest;

    /// Bytes of a particle that the next step starts from, in the scalar of the run.
    fn state_bytes(&mut self) -> usize;

    /// The reconstruction (1.13) of the state at some points, at the particles without any, one
    /// after the other; empty where there is none. For the end of a run.
    ///
    /// # Errors
    /// Of the solver.
    fn reconstruct(&mut self, points: Option<&[[f64; 3]]>) -> Result<Vec<f64>, RunError> {
        let _ = points;
        Ok(Vec::new())
    }

    /// The part of the state in waves that the solver does not damp as it should; 0 where there
    /// are none. For the end of a run, before it is reconstructed.
    ///
    /// # Errors
    /// Of the solver.
    fn undamped(&mut self, engine: &mut Threads) -> Result<f64, RunError> {
        let _ = engine;
        Ok(0.0)
    }

    /// Why the results may not mean what they say, whatever the resolution.
    fn doubts(&self, outcome: &Outcome) -> Vec<String> {
        let _ = outcome;
        Vec::new()
    }

    /// What a careful reader should know of this run.
    fn warnings(&self, outcome: &Outcome) -> Vec<String> {
        let _ = outcome;
        Vec::new()
    }

    /// Why the sum is what it is, of each component that something comes from, or goes to.
    fn balance(&self, outcome: &Outcome) -> Vec<Balance> {
        let _ = outcome;
        Vec::new()
    }

    /// The force of a gas on each of its walls at the end, by the name of the wall; empty without any.
    fn wall_forces(&self, outcome: &Outcome) -> BTreeMap<String, Vec<f64>> {
        let _ = outcome;
        BTreeMap::new()
    }

    /// What summaries say beside what they say of all; `None` for nothing.
    fn particulars(&self, outcome: &Outcome) -> Option<Particulars> {
        let _ = outcome;
        None
    }
}

impl dyn Simulation + '_ {
    /// Steps until a time is reached or passed, or the end. No step is shortened for it: what is
    /// seen on the way has the bits of a run that nobody looked at.
    ///
    /// # Errors
    /// What [`RunError`] lists.
    pub fn advance_to(&mut self, time: f64, engine: &mut Threads) -> Result<(), RunError> {
        while self.time() < time && self.step(engine)?.is_some() {}
        Ok(())
    }

    /// Visits the particles to see, in id order; stops at the first error.
    ///
    /// # Errors
    /// Those of the visitor.
    pub fn visit<E>(&self, mut visitor: impl FnMut(&Row) -> Result<(), E>) -> Result<(), E> {
        let mut row = Row::default();
        for place in 0..self.places() {
            if self.show(place, &mut row) {
                visitor(&row)?;
            }
        }
        Ok(())
    }

    /// Visits the particles to see, in id order.
    pub fn each(&self, mut visitor: impl FnMut(&Row)) {
        let all = self.visit(|row| {
            visitor(row);
            Ok::<(), std::convert::Infallible>(())
        });
        all.unwrap_or_else(|never| match never {});
    }

    /// Number of particles to see.
    pub fn particles(&self) -> usize {
        let mut count = 0;
        self.each(|_| count += 1);
        count
    }

    /// The values of all particles under a heading such as `density` or `velocity_x`; `None`
    /// where there is none of that name.
    pub fn column(&self, heading: &str) -> Option<Vec<f64>> {
        let headings = self.description().headings();
        let place = headings.iter().position(|name| name == heading)?;
        let mut column = Vec::with_capacity(self.places());
        self.each(|row| column.push(row.values[place]));
        Some(column)
    }

    /// Smallest, mean and largest value under a heading.
    pub fn spread(&self, heading: &str) -> Option<Spread> {
        let headings = self.description().headings();
        let place = headings.iter().position(|name| name == heading)?;
        let mut spreading = Spreading::default();
        self.each(|row| spreading.add(row.values[place]));
        Some(spreading.spread())
    }
}
