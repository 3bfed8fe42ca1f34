//! Linear systems on a line: acoustics and the telegraph line.

use motes_core::cutoff::CutOff;
use motes_core::equation::linear::{
    FirstOrderSystem, Line, LinearDynamics, LinearStorage, LinearWorkspace, Nothing, State,
    VelocityField,
};
use motes_core::error::Error;
use motes_core::integrator::{Clock, RungeKutta};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

use crate::console::Console;
use crate::{acoustics, telegraph};

/// Particles of the larger of the lines.
const PARTICLES: usize = larger(acoustics::PARTICLES, telegraph::PARTICLES);

/// Cells they can take, and one.
const CELLS: usize = larger(acoustics::CELLS, telegraph::CELLS);

const fn larger(a: usize, b: usize) -> usize {
    if a > b { a } else { b }
}

/// A line of two components in static memory.
pub type Storage<S> = LinearStorage<S, Nothing, 1, 2, PARTICLES, CELLS>;

/// A line between two steps.
pub struct Run<'a, S: Scalar, C, F, A> {
    dynamics: LinearDynamics<S, C, F, A, 1, 2>,
    method: RungeKutta,
    state: State<'a, S, 1, 2>,
    work: LinearWorkspace<'a, S, Nothing, 1, 2>,
    clock: Clock<S>,
    /// The time step, where it is given.
    step: Option<S>,
}

impl<'a, S, C, F, A> Run<'a, S, C, F, A>
where
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, 1, 2, Medium = Nothing>,
    A: VelocityField<S, 1>,
{
    /// A line at its start.
    pub fn new(
        storage: &'a mut Storage<S>,
        line: &Line<'_, 2>,
        (cut_off, system, motion): (C, F, A),
        method: RungeKutta,
    ) -> Result<Self, Error> {
        storage.clear();
        for particle in line.particles() {
            storage.push(particle)?;
        }
        let (state, work) = storage.parts();
        let mut run = Self {
            dynamics: line.dynamics(cut_off, system, motion),
            method,
            state,
            work,
            clock: Clock::new(line.duration()),
            step: line.step(),
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
        let dt = match self.step {
            Some(step) => step.lesser(left),
            None => {
                let stability = self.method.stability();
                self.dynamics
                    .time_step(&self.state, time, stability, left)?
            }
        };
        self.dynamics.advance(
            &self.method,
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

/// Acoustics to its end; the digest of its last state.
pub fn acoustics<S: Scalar>(storage: &mut Storage<S>) -> Result<u64, Error> {
    use acoustics::{CUT_OFF, LINE, METHOD, motion, system};
    Run::new(
        storage,
        &LINE,
        (CUT_OFF, system::<S>(), motion::<S>()),
        METHOD,
    )?
    .complete()
}

/// The telegraph line to its end; the digest of its last state.
pub fn telegraph<S: Scalar>(storage: &mut Storage<S>) -> Result<u64, Error> {
    use telegraph::{CUT_OFF, LINE, METHOD, motion, system};
    Run::new(
        storage,
        &LINE,
        (CUT_OFF, system::<S>(), motion::<S>()),
        METHOD,
    )?
    .complete()
}

/// Runs both lines in one scalar, one after the other in the same memory, and prints their lines.
/// `false` where a run failed.
pub fn report<S: Scalar>(
    scalar: &str,
    storage: Option<&mut Storage<S>>,
    console: &mut Console,
) -> bool {
    let Some(storage) = storage else {
        return false;
    };
    let sound = acoustics(storage);
    console.row(acoustics::NAME, acoustics::PARTICLES, scalar);
    console.outcome(&sound);
    let line = telegraph(storage);
    console.row(telegraph::NAME, telegraph::PARTICLES, scalar);
    console.outcome(&line);
    sound.is_ok() & line.is_ok()
}
