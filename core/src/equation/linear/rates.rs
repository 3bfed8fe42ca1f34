//! The right-hand sides of (1.18), (1.20) and (1.21) for a whole cloud.

use crate::cutoff::CutOff;
use crate::equation::{own_rate, prove_own, prove_rates, with_own};
use crate::error::Error;
use crate::neighbours::sort;
use crate::pairs::{Engine, Fields as _, Settled};
use crate::scalar::Scalar;

use super::dynamics::LinearDynamics;
use super::law::{Coupling, SystemNode, SystemSums};
use super::storage::LinearWorkspace;
use super::system::FirstOrderSystem;
use crate::cloud::Place;
use crate::cloud::State;
use crate::cloud::VelocityField;

impl<S, C, F, A, const D: usize, const P: usize> LinearDynamics<S, C, F, A, D, P>
where
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, D, P>,
    A: VelocityField<S, D>,
{
    /// Checks a state whose positions, weights and values have been set, makes its strengths and
    /// finds its neighbours. Must run once before the first step.
    ///
    /// Errors: arrays of unequal lengths, a weight that is not above 0, a particle without
    /// neighbours.
    pub fn prepare(
        &self,
        engine: &mut impl Engine<S, D>,
        state: &mut State<'_, S, D, P>,
        work: &mut LinearWorkspace<'_, S, F::Medium, D, P>,
    ) -> Result<(), Error> {
        if !state.is_consistent() {
            return Err(Error::Lengths);
        }
        state.check()?;
        state.weigh();
        *work.grid = None;
        self.sums(engine, state, work, S::ZERO, true)?;
        let alone = |&neighbours: &S| !(neighbours > S::ZERO);
        match state.neighbours.iter().position(alone) {
            Some(particle) if state.len() > 1 => Err(Error::Isolated {
                particle: particle as u32,
            }),
            _ => Ok(()),
        }
    }

    /// Counts the neighbours of a state at that time, where its steps do not: nothing passes
    /// between particles that go with what they carry. Changes no bit of the run.
    pub fn count_neighbours(
        &self,
        engine: &mut impl Engine<S, D>,
        state: &mut State<'_, S, D, P>,
        work: &mut LinearWorkspace<'_, S, F::Medium, D, P>,
        time: S,
    ) -> Result<(), Error> {
        match F::IS_COUPLED {
            true => Ok(()),
            false => self.sums(engine, state, work, time, true),
        }
    }

    /// The rates of all particles at the stage that `state` holds, into `work.last`, in id order.
    pub(crate) fn rates(
        &self,
        engine: &mut impl Engine<S, D>,
        state: &mut State<'_, S, D, P>,
        work: &mut LinearWorkspace<'_, S, F::Medium, D, P>,
        time: S,
    ) -> Result<(), Error> {
        self.sums(engine, state, work, time, false)?;
        let n = state.len();
        let sums = work.sums.get(..n).unwrap_or(&[]);
        let order = work.cells.order.get(..n).unwrap_or(&[]);
        let damping = self.system.damping();
        if damping > S::ZERO {
            prove_own(engine, (state.value, state.weight), self.epsilon, |u| {
                damping.to_f64() * u
            })?;
        }
        for (settled, &id) in sums.iter().zip(order) {
            let id = id as usize;
            let (Some(&position), Some(rates)) = (state.position.get(id), work.last.get_mut(id))
            else {
                continue;
            };
            let place = Place { position, time };
            let node = &settled.node;
            rates.weight = node.weight * self.field.divergence(&place);
            let decay = self.system.decay(&place, &node.value);
            let source = self.system.source(&place);
            let terms = rates.strength.iter_mut().zip(settled.sums.rate);
            for (((rate, pairs), decay), source) in terms.zip(decay).zip(source) {
                let own = own_rate(self.epsilon, node.weight, [source, decay]);
                *rate = with_own(pairs, own);
            }
        }
        prove_rates(engine, work.last.get(..n).unwrap_or(&[]))
    }

    /// Velocities into `work.last`, sums over pairs into `work.sums`. Where nothing passes
    /// between particles the sums are 0, unless `counted`: then they are made for the sake of
    /// the neighbours.
    fn sums(
        &self,
        engine: &mut impl Engine<S, D>,
        state: &mut State<'_, S, D, P>,
        work: &mut LinearWorkspace<'_, S, F::Medium, D, P>,
        time: S,
        counted: bool,
    ) -> Result<(), Error> {
        let n = state.len();
        let grid = match *work.grid {
            Some(grid) => grid,
            None => {
                let reach = self.reach();
                let grid = sort(&self.domain, state.position, &|_| reach, &mut work.cells)?;
                engine.sorted();
                grid
            }
        };
        *work.grid = self.field.is_still().then_some(grid);
        let cells = work.cells.cells(grid, n);
        let (Some(nodes), Some(sums), Some(last)) = (
            work.nodes.get_mut(..n),
            work.sums.get_mut(..n),
            work.last.get_mut(..n),
        ) else {
            return Err(Error::Lengths);
        };
        let mut carried = false;
        for (node, &id) in nodes.iter_mut().zip(cells.order()) {
            let id = id as usize;
            let (Some(&position), Some(&weight), Some(&value), Some(rates)) = (
                state.position.get(id),
                state.weight.get(id),
                state.value.get(id),
                last.get_mut(id),
            ) else {
                continue;
            };
            let place = Place { position, time };
            rates.position = self.field.velocity(&place);
            let drift = self.drift(&place, &rates.position);
            carried |= drift.iter().any(|&component| component != S::ZERO);
            *node = SystemNode {
                weight,
                drift,
                value,
                medium: self.system.medium(&place),
            };
        }
        if !(F::IS_COUPLED || carried || counted) {
            for (settled, node) in sums.iter_mut().zip(nodes.iter()) {
                *settled = Settled::new(*node, SystemSums::ZERO);
            }
            return Ok(());
        }
        let law = Coupling::new::<D>(&self.system, self.cut_off, self.epsilon);
        engine.evaluate(&law, &cells, nodes, sums)?;
        for (settled, &id) in sums.iter().zip(cells.order()) {
            if let Some(neighbours) = state.neighbours.get_mut(id as usize) {
                *neighbours = settled.sums.partners - S::ONE;
            }
        }
        Ok(())
    }
}
