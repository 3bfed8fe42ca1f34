//! Steps of linear systems: positions, weights and strengths together.

#[cfg(test)]
mod tests;

use crate::cutoff::CutOff;
use crate::equation::linear::{
    FirstOrderSystem, LinearDynamics, LinearWorkspace, Register, Stability, Start, State,
    VelocityField,
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
        let n = self.state.len();
        let (Some(start), Some(sum)) = (self.work.start.get_mut(..n), self.work.sum.get_mut(..n))
        else {
            return Err(Error::Lengths);
        };
        sum.fill(Register::ZERO);
        let rows = start.iter_mut().zip(self.state.position.iter());
        let rows = rows.zip(self.state.weight.iter());
        for (((start, &position), &weight), &strength) in rows.zip(self.state.strength.iter()) {
            *start = Start {
                position,
                weight,
                strength,
            };
        }
        Ok(())
    }

    fn rates(&mut self, time: S) -> Result<(), Error> {
        self.dynamics
            .rates(self.engine, self.state, self.work, time)
    }

    fn accumulate(&mut self, n: u32) {
        for (sum, last) in self.work.sum.iter_mut().zip(self.work.last.iter()) {
            sum.add(n, last);
        }
    }

    fn stage(&mut self, dt: S, from: From) -> Result<(), Error> {
        let registers: &[Register<S, D, P>] = match from {
            From::Last => self.work.last,
            From::Sum => self.work.sum,
        };
        // Rates of strengths are ε times theirs: small numbers times 1/ε would lose digits.
        let per_epsilon = dt / self.dynamics.epsilon;
        let still = self.dynamics.field.is_still();
        for (id, (start, rates)) in self.work.start.iter().zip(registers).enumerate() {
            let Some(row) = self.state.row(id) else { break };
            if !still {
                *row.position = start.position;
                let step = rates.position.map(|a| dt * a);
                self.dynamics.domain.drift(row.position, &step, id as u32)?;
                *row.weight = start.weight + dt * rates.weight;
            }
            let components = row.strength.iter_mut().zip(&start.strength);
            for ((strength, &q), &rate) in components.zip(&rates.strength) {
                *strength = S::wide_sum(q, S::product(per_epsilon, rate));
            }
            row.revalue();
        }
        Ok(())
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
