//! Convection-diffusion in a slab: a wall in the weather.

use motes_core::cloud::Still;
use motes_core::cutoff::Named as CutOff;
use motes_core::equation::diffusion::{DiffusionDynamics, DirectStorage, Lists, NamedProblem};
use motes_core::error::Error;
use motes_core::integrator::{DiffusionMethod, Scheme, Stepper};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

use crate::console::Console;
use crate::steps::complete;
use crate::wall::{CELLS, CUT_OFF, LAYERS, NAME, PARTICLES, POINTS, SLAB, motion};

/// All memory of a wall but the stack.
pub struct Storage<S: Scalar> {
    cloud: DirectStorage<S, 1, 1, PARTICLES, CELLS>,
    lists: Lists<S, POINTS, LAYERS>,
}

impl<S: Scalar> Storage<S> {
    /// An empty wall. Made when the program is compiled, and copied to where it is to be: made in
    /// place, its parts may be on the stack a second time.
    #[inline(always)]
    pub const fn new() -> Self {
        const {
            Self {
                cloud: DirectStorage::new(),
                lists: Lists::new(),
            }
        }
    }
}

impl<S: Scalar> Default for Storage<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// The equation of a wall.
type Wall<'a, S> = DiffusionDynamics<S, CutOff, NamedProblem<'a, S, 1, 1>, Still, 1, 1>;

/// The memory of its particles.
type Cloud<S> = DirectStorage<S, 1, 1, PARTICLES, CELLS>;

/// A wall between two steps.
pub type Run<'a, S> = Stepper<S, Wall<'a, S>, HalfLoop, &'a mut Cloud<S>, 1>;

/// The wall at its start.
pub fn start<S: Scalar>(storage: &mut Storage<S>) -> Result<Run<'_, S>, Error> {
    let Storage { cloud, lists } = storage;
    cloud.clear();
    for particle in SLAB.particles() {
        cloud.push(particle)?;
    }
    let dynamics = SLAB.dynamics(CUT_OFF, SLAB.problem(lists)?, motion::<S>());
    let method = DiffusionMethod {
        scheme: Scheme::Stabilised(SLAB.stages),
        longest: SLAB.longest(),
    };
    let mut run = Stepper::new(dynamics, method, HalfLoop, cloud)?.until(SLAB.duration());
    run.step = SLAB.step();
    Ok(run)
}

/// Runs the wall in one scalar to its end and prints its line: behind the digest the bytes of its
/// memory. `false` where the run failed.
pub fn report<S: Scalar>(
    scalar: &str,
    storage: Option<&mut Storage<S>>,
    console: &mut Console,
) -> bool {
    let storage = storage.ok_or(Error::Lengths);
    let run = storage.and_then(start);
    let outcome = run.and_then(|mut run| complete(&mut run));
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
