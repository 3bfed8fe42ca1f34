//! The equations of the paper. One folder each; every one is a [`Law`](crate::pairs::Law) and what
//! goes with it, and a [`Dynamics`]: how it is stepped.

pub mod diffusion;
pub mod gas;
pub mod linear;
mod range;

pub(crate) use range::{own_rate, prove_own, prove_rates, with_own};

use crate::cloud::{Columns, Words};
use crate::error::{Error, Parameter};
use crate::pairs::Engine;
use crate::scalar::Scalar;

/// An equation and how it is solved: what a `Stepper` steps.
///
/// It holds numbers, no particles. The state and the memory of a step belong to a [`Storage`].
pub trait Dynamics<S: Scalar, const D: usize> {
    /// How time goes on.
    type Method;
    /// The state, one array a quantity.
    type State<'a>: Columns<S>;
    /// What a step works in.
    type Work<'a>;
    /// A particle as it is put into a cloud.
    type Particle: Copy;

    /// Checks a state whose positions and values have been set, and makes what the first step
    /// starts from.
    fn prepare<E: Engine<S, D>>(
        &self,
        engine: &mut E,
        parts: &mut Parts<'_, S, Self, D>,
    ) -> Result<(), Error>;

    /// Makes what the next step starts from anew, after particles have come or gone; the state
    /// stays as it is.
    fn resume<E: Engine<S, D>>(
        &self,
        engine: &mut E,
        parts: &mut Parts<'_, S, Self, D>,
        time: S,
    ) -> Result<(), Error> {
        let _ = (engine, parts, time);
        Ok(())
    }

    /// The step to make from `time`: stable, at most `longest`.
    fn stable_step(
        &self,
        method: &Self::Method,
        parts: &Parts<'_, S, Self, D>,
        time: S,
        longest: S,
    ) -> Result<S, Error>;

    /// Whether all numbers that drive the equation over a step are numbers: what a control loop
    /// sets is checked here, before it reaches the state.
    fn ready(&self, step: Step<S>) -> Result<(), Error> {
        let _ = step;
        Ok(())
    }

    /// Makes a step; how many right-hand sides that took. On an error the state is between two
    /// steps: a [`Storage`] has kept the one before.
    fn advance<E: Engine<S, D>>(
        &self,
        method: &Self::Method,
        engine: &mut E,
        parts: &mut Parts<'_, S, Self, D>,
        step: Step<S>,
    ) -> Result<u32, Error>;

    /// Passes all that the next step starts from: saves it, or puts what was saved in its place, for
    /// as many particles. Then the next step has the bits that it would have had.
    ///
    /// Errors: those of [`Words`]. A state that is read is neither the old nor the new one then.
    fn pass(&self, parts: &mut Parts<'_, S, Self, D>, words: &mut dyn Words) -> Result<(), Error> {
        words.columns(&mut parts.state)
    }

    /// Lets particles come and go between two steps.
    fn exchange<M: Storage<S, Self, D>>(&self, storage: &mut M) -> Result<(), Error> {
        let _ = storage;
        Ok(())
    }
}

/// A step in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<S> {
    /// Where it starts.
    pub time: S,
    /// Its length.
    pub dt: S,
}

/// Refuses a factor of the stable time step that is not in (0, 1], NaN among them.
pub(crate) fn check_courant<S: Scalar>(courant: S) -> Result<(), Error> {
    match courant > S::ZERO && courant <= S::ONE {
        true => Ok(()),
        false => Err(Error::Parameter {
            parameter: Parameter::Courant,
        }),
    }
}

/// A state, and what a step works in.
pub struct Parts<'a, S: Scalar, Y: Dynamics<S, D> + ?Sized, const D: usize> {
    /// The state.
    pub state: Y::State<'a>,
    /// What a step works in.
    pub work: Y::Work<'a>,
}

/// The memory of a cloud: its state, the work of a step, and the state before the last one.
pub trait Storage<S: Scalar, Y: Dynamics<S, D> + ?Sized, const D: usize> {
    /// The state and the workspace.
    fn parts(&mut self) -> Parts<'_, S, Y, D>;
    /// Adds a particle; its id is the number of particles before it. Error: no room.
    fn insert(&mut self, particle: Y::Particle) -> Result<(), Error>;
    /// Removes a particle; the last one gets its id. Does nothing beyond the end.
    fn swap_remove(&mut self, id: usize);
    /// Remembers the state.
    fn keep(&mut self);
    /// Goes back to the state that was remembered; as many particles must be there.
    fn restore(&mut self);
}

impl<S: Scalar, Y: Dynamics<S, D> + ?Sized, M: Storage<S, Y, D>, const D: usize> Storage<S, Y, D>
    for &mut M
{
    fn parts(&mut self) -> Parts<'_, S, Y, D> {
        (**self).parts()
    }
    fn insert(&mut self, particle: Y::Particle) -> Result<(), Error> {
        (**self).insert(particle)
    }
    fn swap_remove(&mut self, id: usize) {
        (**self).swap_remove(id);
    }
    fn keep(&mut self) {
        (**self).keep();
    }
    fn restore(&mut self) {
        (**self).restore();
    }
}
