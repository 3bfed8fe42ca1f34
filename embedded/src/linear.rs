//! Linear systems on a line: acoustics and the telegraph line.

use motes_core::cloud::VelocityField;
use motes_core::cutoff::CutOff;
use motes_core::equation::linear::{FirstOrderSystem, Line, LinearDynamics, LinearStorage};
use motes_core::error::Error;
use motes_core::integrator::{RungeKutta, Stepper};
use motes_core::pairs::{HalfLoop, Nothing};
use motes_core::scalar::Scalar;

use crate::console::Console;
use crate::steps::complete;
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
pub type Run<'a, S, C, F, A> =
    Stepper<S, LinearDynamics<S, C, F, A, 1, 2>, HalfLoop, &'a mut Storage<S>, 1>;

/// A line at its start.
pub fn start<'a, S, C, F, A>(
    storage: &'a mut Storage<S>,
    line: &Line<'_, 2>,
    (cut_off, system, motion): (C, F, A),
    method: RungeKutta,
) -> Result<Run<'a, S, C, F, A>, Error>
where
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, 1, 2, Medium = Nothing>,
    A: VelocityField<S, 1>,
{
    storage.clear();
    for particle in line.particles() {
        storage.push(particle)?;
    }
    let dynamics = line.dynamics(cut_off, system, motion);
    let mut run = Stepper::new(dynamics, method, HalfLoop, storage)?.until(line.duration());
    run.step = line.step();
    Ok(run)
}

/// Acoustics to its end; the digest of its last state.
pub fn acoustics<S: Scalar>(storage: &mut Storage<S>) -> Result<u64, Error> {
    use acoustics::{CUT_OFF, LINE, METHOD, motion, system};
    let equation = (CUT_OFF, system::<S>(), motion::<S>());
    complete(&mut start(storage, &LINE, equation, METHOD)?)
}

/// The telegraph line to its end; the digest of its last state.
pub fn telegraph<S: Scalar>(storage: &mut Storage<S>) -> Result<u64, Error> {
    use telegraph::{CUT_OFF, LINE, METHOD, motion, system};
    let equation = (CUT_OFF, system::<S>(), motion::<S>());
    complete(&mut start(storage, &LINE, equation, METHOD)?)
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
