//! Steps of convection-diffusion: all at once, or transport and diffusion in turns.

use crate::cloud::{Place, Register, State, VelocityField};
use crate::cloud::{accumulate, clear, put, remember, remember_strengths};
use crate::cutoff::CutOff;
use crate::equation::diffusion::{DiffusionDynamics, DiffusionProblem, DiffusionWorkspace};
use crate::error::Error;
use crate::numbered::numbered;
use crate::pairs::Engine;
use crate::scalar::Scalar;

use super::rkl2::{MOST_STAGES, Rkl2, Stabilised};
use super::runge_kutta::{From, RungeKutta, SemiDiscrete};

/// A solver with the state that it moves.
struct Stepping<'a, 's, 'w, E, S, C, B, A, const D: usize, const P: usize>
where
    S: Scalar,
{
    dynamics: &'a DiffusionDynamics<S, C, B, A, D, P>,
    engine: &'a mut E,
    state: &'a mut State<'s, S, D, P>,
    work: &'a mut DiffusionWorkspace<'w, S, D, P>,
    /// `1/ε²`: what strengths' rates are still to be multiplied with.
    per_squared: S,
}

impl<E, S, C, B, A, const D: usize, const P: usize> SemiDiscrete<S>
    for Stepping<'_, '_, '_, E, S, C, B, A, D, P>
where
    E: Engine<S, D>,
    S: Scalar,
    C: CutOff,
    B: DiffusionProblem<S, D, P>,
    A: VelocityField<S, D>,
{
    fn start(&mut self) -> Result<(), Error> {
        clear(self.state.len(), self.work.sum)?;
        self.work.ledger.start();
        remember(self.state, self.work.start)
    }

    fn rates(&mut self, time: S) -> Result<(), Error> {
        self.dynamics
            .rates(self.engine, self.state, self.work, time)
    }

    fn accumulate(&mut self, n: u32) {
        accumulate(self.work.sum, self.work.last, n);
        self.work.ledger.accumulate(n);
    }

    fn stage(&mut self, dt: S, from: From) -> Result<(), Error> {
        let per_power = dt * self.per_squared;
        match from {
            From::Last => self.work.ledger.put_last(per_power),
            From::Sum => self.work.ledger.put_sum(per_power),
        }
        let rates: &[Register<S, D, P>] = match from {
            From::Last => self.work.last,
            From::Sum => self.work.sum,
        };
        let dynamics = self.dynamics;
        let still = dynamics.field.is_still();
        if !still {
            *self.work.grid = None;
        }
        let moved = (!still).then_some((&dynamics.domain, dt));
        let registers = (&*self.work.start, rates);
        put(self.state, registers, moved, per_power)
    }
}

impl<E, S, C, B, A, const D: usize, const P: usize> Stabilised<S>
    for Stepping<'_, '_, '_, E, S, C, B, A, D, P>
where
    E: Engine<S, D>,
    S: Scalar,
    C: CutOff,
    B: DiffusionProblem<S, D, P>,
    A: VelocityField<S, D>,
{
    fn start(&mut self) -> Result<(), Error> {
        self.work.stages.fill([[S::ZERO; P]; 3]);
        self.work.ledger.start();
        remember_strengths(self.state, self.work.start)
    }

    fn rates(&mut self, time: S) -> Result<(), Error> {
        SemiDiscrete::rates(self, time)
    }

    fn keep(&mut self) {
        self.work.ledger.keep();
        for (stages, last) in self.work.stages.iter_mut().zip(self.work.last.iter()) {
            let [first, _, _] = stages;
            *first = last.strength;
        }
    }

    fn combine(&mut self, [mu, nu]: [S; 2], fresh: S, first: S) -> Result<(), Error> {
        let (fresh, first) = (fresh * self.per_squared, first * self.per_squared);
        self.work.ledger.combine([mu, nu], fresh, first);
        let rows = self.work.stages.iter_mut().zip(self.work.last.iter());
        for (id, ((stages, last), start)) in numbered(rows.zip(self.work.start.iter())) {
            let Some(row) = self.state.row(id) else { break };
            let [rates, before, earlier] = stages;
            for j in 0..P {
                let increment =
                    mu * before[j] + nu * earlier[j] + fresh * last.strength[j] + first * rates[j];
                (earlier[j], before[j]) = (before[j], increment);
                row.strength[j] = S::wide_sum(start.strength[j], S::product(S::ONE, increment));
            }
            row.revalue();
        }
        Ok(())
    }
}

impl<S, C, B, A, const D: usize, const P: usize> DiffusionDynamics<S, C, B, A, D, P>
where
    S: Scalar,
    C: CutOff,
    B: DiffusionProblem<S, D, P>,
    A: VelocityField<S, D>,
{
    fn stepping<'a, 's, 'w, E>(
        &'a self,
        engine: &'a mut E,
        state: &'a mut State<'s, S, D, P>,
        work: &'a mut DiffusionWorkspace<'w, S, D, P>,
    ) -> Stepping<'a, 's, 'w, E, S, C, B, A, D, P> {
        Stepping {
            dynamics: self,
            engine,
            state,
            work,
            per_squared: S::ONE / (self.epsilon * self.epsilon),
        }
    }

    /// Advances a prepared state from `time` by `dt`, transport and diffusion together. On an
    /// error the state is between two steps and must not be used further.
    ///
    /// In fixed point the sums of the strengths are conserved to the bit without reactions, also
    /// between walls that let nothing through.
    pub fn advance(
        &self,
        method: &RungeKutta,
        engine: &mut impl Engine<S, D>,
        state: &mut State<'_, S, D, P>,
        work: &mut DiffusionWorkspace<'_, S, D, P>,
        (time, dt): (S, S),
    ) -> Result<(), Error> {
        let mut stepping = self.stepping(engine, state, work);
        method.advance(&mut stepping, time, dt)?;
        state.check()
    }

    /// The fewest stages of the stabilised method that a step takes, with `courant` to spare; at most
    /// `most`, which bounds the work of a step. `None` where that is too few.
    pub fn stabilised(&self, radius: S, dt: S, most: u32) -> Option<Rkl2> {
        let mut stages = 3;
        while stages <= Ord::min(most, MOST_STAGES) {
            let method = Rkl2::with_stages(stages);
            // Not `radius dt`, which may leave the format.
            if !(radius > S::ZERO) || dt <= self.courant * (method.reach::<S>() / radius) {
                return Some(method);
            }
            stages += 2;
        }
        None
    }

    /// The same with half a step of transport, a step of diffusion by the stabilised method on
    /// particles that stand still, and half a step of transport (Strang 1968). Second order; sums
    /// are conserved to rounding.
    pub fn advance_split(
        &self,
        method: Rkl2,
        engine: &mut impl Engine<S, D>,
        state: &mut State<'_, S, D, P>,
        work: &mut DiffusionWorkspace<'_, S, D, P>,
        (time, dt): (S, S),
    ) -> Result<(), Error> {
        let half = dt.half();
        self.carry(state, work, (time, half))?;
        let mut stepping = self.stepping(engine, state, work);
        method.advance(&mut stepping, time, dt)?;
        self.carry(state, work, (time + half, half))?;
        state.check()
    }

    /// Moves particles along their characteristics, each by itself, by the classical method of
    /// order 4; strengths stay.
    fn carry(
        &self,
        state: &mut State<'_, S, D, P>,
        work: &mut DiffusionWorkspace<'_, S, D, P>,
        (time, dt): (S, S),
    ) -> Result<(), Error> {
        if self.field.is_still() {
            return Ok(());
        }
        *work.grid = None;
        let (half, sixth) = (dt.half(), dt / S::count(6));
        for id in 0..state.len() {
            let Some(row) = state.row(id) else { break };
            let (x, w) = (*row.position, *row.weight);
            let at = |position: [S; D], weight: S, time: S| {
                let place = Place { position, time };
                let velocity = self.field.velocity(&place);
                (velocity, weight * self.field.divergence(&place))
            };
            let ahead = |(velocity, rate): &([S; D], S), dt: S| {
                let mut position = x;
                for (x, &a) in position.iter_mut().zip(velocity) {
                    *x += dt * a;
                }
                (position, w + dt * *rate)
            };
            let one = at(x, w, time);
            let (y, v) = ahead(&one, half);
            let two = at(y, v, time + half);
            let (y, v) = ahead(&two, half);
            let three = at(y, v, time + half);
            let (y, v) = ahead(&three, dt);
            let four = at(y, v, time + dt);
            let mut step = [S::ZERO; D];
            for i in 0..D {
                let middle = two.0[i] + three.0[i];
                step[i] = sixth * (one.0[i] + (middle + middle) + four.0[i]);
            }
            let middle = two.1 + three.1;
            *row.weight = w + sixth * (one.1 + (middle + middle) + four.1);
            self.domain.drift(row.position, &step, id as u32)?;
            row.revalue();
        }
        Ok(())
    }
}
