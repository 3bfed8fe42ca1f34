//! Steps of linear systems: positions, weights and strengths together.

#[cfg(test)]
mod tests;

use crate::cloud::{accumulate, clear, put, remember};
use crate::cutoff::CutOff;
use crate::equation::linear::{
    FirstOrderSystem, LinearDynamics, LinearWorkspace, Register, Stability, State, VelocityField,
};
use crate::error::Error;
use crate::pairs::Engine;
use crate::scalar::Scalar;

use super::runge_kutta::{From, RungeKutta, SemiDiscrete};

/// A solver with the state that it moves.
struct Stepping<'a, 's, 'w, E, S, C, F, A, const D: usize, const P: usize>
where
    S: Scalar,
    F: FirstOrderSystem<S, D, P>,
{
    dynamics: &'a LinearDynamics<S, C, F, A, D, P>,
    engine: &'a mut E,
    state: &'a mut State<'s, S, D, P>,
    work: &'a mut LinearWorkspace<'w, S, F::Medium, D, P>,
}

impl<E, S, C, F, A, const D: usize, const P: usize> SemiDiscrete<S>
    for Stepping<'_, '_, '_, E, S, C, F, A, D, P>
where
    E: Engine<S, D>,
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, D, P>,
    A: VelocityField<S, D>,
{
    fn start(&mut self) -> Result<(), Error> {
        clear(self.state.len(), self.work.sum)?;
        remember(self.state, self.work.start)
    }

    fn rates(&mut self, time: S) -> Result<(), Error> {
        self.dynamics
            .rates(self.engine, self.state, self.work, time)
    }

    fn accumulate(&mut self, n: u32) {
        accumulate(self.work.sum, self.work.last, n);
    }

    fn stage(&mut self, dt: S, from: From) -> Result<(), Error> {
        let rates: &[Register<S, D, P>] = match from {
            From::Last => self.work.last,
            From::Sum => self.work.sum,
        };
        let dynamics = self.dynamics;
        let moved = (!dynamics.field.is_still()).then_some((&dynamics.domain, dt));
        let registers = (&*self.work.start, rates);
        put(self.state, registers, moved, dt / dynamics.epsilon)
    }
}

impl<S, C, F, A, const D: usize, const P: usize> LinearDynamics<S, C, F, A, D, P>
where
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, D, P>,
    A: VelocityField<S, D>,
{
    /// Advances a prepared state from `time` by `dt`. On an error the state is between two steps
    /// and must not be used further.
    ///
    /// Errors: a particle that leaves the domain by more than its length, or a weight or strength
    /// that is no number any more.
    pub fn advance(
        &self,
        method: &RungeKutta,
        engine: &mut impl Engine<S, D>,
        state: &mut State<'_, S, D, P>,
        work: &mut LinearWorkspace<'_, S, F::Medium, D, P>,
        (time, dt): (S, S),
    ) -> Result<(), Error> {
        let mut stepping = Stepping {
            dynamics: self,
            engine,
            state,
            work,
        };
        method.advance(&mut stepping, time, dt)?;
        state.check()
    }
}

impl RungeKutta {
    /// What it stays stable in.
    pub fn stability(&self) -> Stability {
        Stability {
            imaginary: self.imaginary,
            real: self.real,
        }
    }
}
