//! Convection-diffusion in a slab: a wall in the weather.

use motes_core::cutoff::Named as CutOff;
use motes_core::equation::diffusion::{
    DiffusionDynamics, DiffusionWorkspace, DirectStorage, Lists, NamedProblem,
};
use motes_core::equation::linear::{State, Still};
use motes_core::error::Error;
use motes_core::integrator::{Clock, MOST_STAGES, Rkl2};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

use crate::console::Console;
use crate::wall::{CELLS, CUT_OFF, LAYERS, NAME, PARTICLES, POINTS, SLAB, motion};

/// All memory of a wall but the stack.
pub struct Storage<S: Scalar> {
    cloud: DirectStorage<S, 1, 1, PARTICLES, CELLS>,
    lists: Lists<S, POINTS, LAYERS>,
}

impl<S: Scalar> Storage<S> {
    /// An empty wall.
    pub const fn new() -> Self {
        Self {
            cloud: DirectStorage::new(),
            lists: Lists::new(),
        }
    }
}

impl<S: Scalar> Default for Storage<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// A wall between two steps.
pub struct Run<'a, S: Scalar> {
    dynamics: DiffusionDynamics<S, CutOff, NamedProblem<'a, S, 1, 1>, Still, 1, 1>,
    state: State<'a, S, 1, 1>,
    work: DiffusionWorkspace<'a, S, 1, 1>,
    clock: Clock<S>,
    /// The time step, where it is given.
    step: Option<S>,
}

impl<'a, S: Scalar> Run<'a, S> {
    /// The wall at its start.
    pub fn new(storage: &'a mut Storage<S>) -> Result<Self, Error> {
        let Storage { cloud, lists } = storage;
        cloud.clear();
        for particle in SLAB.particles() {
            cloud.push(particle)?;
        }
        let (state, work) = cloud.parts();
        let problem = SLAB.problem(lists)?;
        let mut run = Self {
            dynamics: SLAB.dynamics(CUT_OFF, problem, motion::<S>()),
            state,
            work,
            clock: Clock::new(SLAB.duration()),
            step: SLAB.step(),
        };
        run.dynamics
            .prepare(&mut HalfLoop, &mut run.state, &mut run.work)?;
        Ok(run)
    }

    /// Makes a step; `false` where the end has been reached before.
    pub fn step(&mut self) -> Result<bool, Error> {
        let Some(left) = self.clock.left() else {
            return Ok(false);
        };
        let time = self.clock.time;
        let radius = self.dynamics.radius(&self.state, &self.work);
        let dt = match self.step {
            Some(step) => step.lesser(left),
            None => {
                let reach = Rkl2::with_stages(SLAB.stages).reach();
                let longest = left.lesser(SLAB.longest());
                self.dynamics.time_step(radius, reach, longest)?
            }
        };
        let method = self.dynamics.stabilised(radius, dt, MOST_STAGES);
        let method = method.unwrap_or(Rkl2::with_stages(MOST_STAGES));
        self.dynamics.advance_split(
            method,
            &mut HalfLoop,
            &mut self.state,
            &mut self.work,
            (time, dt),
        )?;
        self.clock.tick(dt)?;
        Ok(true)
    }

    /// Runs to the end; the digest of the last state.
    fn complete(mut self) -> Result<u64, Error> {
        while self.step()? {}
        Ok(self.state.digest().0)
    }
}

/// Runs the wall in one scalar to its end and prints its line: behind the digest the bytes of its
/// memory. `false` where the run failed.
pub fn report<S: Scalar>(
    scalar: &str,
    storage: Option<&mut Storage<S>>,
    console: &mut Console,
) -> bool {
    let storage = storage.ok_or(Error::Lengths);
    let outcome = storage.and_then(Run::new).and_then(Run::complete);
    console.row(NAME, PARTICLES, scalar);
    match outcome {
        Ok(digest) => {
            console.hexadecimal(digest);
            console.text(" bytes ");
            console.decimal(size_of::<Storage<S>>() as u64);
            console.text("\n");
        }
        Err(_) => console.text("failed\n"),
    }
    outcome.is_ok()
}
