//! Convection-diffusion as a [`Dynamics`]: by a Runge-Kutta method, or by the stabilised one.

use crate::cloud::{Particle, State, VelocityField, Words};
use crate::cutoff::CutOff;
use crate::domain::Side;
use crate::equation::diffusion::{DiffusionDynamics, DiffusionProblem, DiffusionWorkspace};
use crate::equation::{Dynamics, Parts, Step};
use crate::error::{Error, Parameter};
use crate::integrator::{MOST_STAGES, Rkl2, RungeKutta};
use crate::pairs::Engine;
use crate::scalar::Scalar;

/// How convection-diffusion goes on in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiffusionMethod<S> {
    /// The scheme.
    pub scheme: Scheme,
    /// The longest step that is made without being given.
    pub longest: S,
}

/// A scheme for convection-diffusion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scheme {
    /// Transport and diffusion together, by a Runge-Kutta method.
    RungeKutta(RungeKutta),
    /// In turns, diffusion by the stabilised method, with steps made for so many stages.
    Stabilised(u32),
}

impl<S, C, B, A, const D: usize, const P: usize> Dynamics<S, D>
    for DiffusionDynamics<S, C, B, A, D, P>
where
    S: Scalar,
    C: CutOff,
    B: DiffusionProblem<S, D, P>,
    A: VelocityField<S, D>,
{
    type Method = DiffusionMethod<S>;
    type State<'a> = State<'a, S, D, P>;
    type Work<'a> = DiffusionWorkspace<'a, S, D, P>;
    type Particle = Particle<S, D, P>;

    fn prepare<E: Engine<S, D>>(
        &self,
        engine: &mut E,
        parts: &mut Parts<'_, S, Self, D>,
    ) -> Result<(), Error> {
        self.prepare(engine, &mut parts.state, &mut parts.work)
    }

    fn resume<E: Engine<S, D>>(
        &self,
        engine: &mut E,
        parts: &mut Parts<'_, S, Self, D>,
        time: S,
    ) -> Result<(), Error> {
        *parts.work.grid = None;
        self.rates(engine, &mut parts.state, &mut parts.work, time)
    }

    /// The stable step follows from the rates of the last stage, which no state holds: their radius goes
    /// with it.
    fn pass(&self, parts: &mut Parts<'_, S, Self, D>, words: &mut dyn Words) -> Result<(), Error> {
        let mut radius = S::ZERO;
        if words.fills() {
            *parts.work.grid = None;
        } else {
            radius = self.radius(&parts.state, &parts.work)?;
        }
        words.columns(&mut parts.state)?;
        parts.work.ledger.pass(words)?;
        words.scalar(&mut radius)?;
        *parts.work.radius = Some(radius);
        Ok(())
    }

    fn stable_step(
        &self,
        method: &DiffusionMethod<S>,
        parts: &Parts<'_, S, Self, D>,
        _: S,
        longest: S,
    ) -> Result<S, Error> {
        let radius = self.radius(&parts.state, &parts.work)?;
        let reach = match method.scheme {
            Scheme::RungeKutta(method) => S::from_f64(method.real),
            Scheme::Stabilised(stages) => Rkl2::with_stages(stages).reach(),
        };
        self.time_step(radius, reach, longest.lesser(method.longest))
    }

    /// A number at a wall that is not finite would reach every particle near it.
    fn ready(&self, step: Step<S>) -> Result<(), Error> {
        for time in [step.time, step.time + step.dt] {
            let walls = self.walls(time);
            for (axis, (ends, sides)) in walls.iter().zip(&self.domain.axes).enumerate() {
                for (end, (conditions, side)) in ends.iter().zip(sides.sides).enumerate() {
                    let finite = conditions.iter().all(|condition| condition.is_finite());
                    if side == Side::Mirror && !finite {
                        return Err(Error::Parameter {
                            parameter: Parameter::Wall {
                                axis: axis as u8,
                                end: end as u8,
                            },
                        });
                    }
                }
            }
        }
        Ok(())
    }

    fn advance<E: Engine<S, D>>(
        &self,
        method: &DiffusionMethod<S>,
        engine: &mut E,
        parts: &mut Parts<'_, S, Self, D>,
        step: Step<S>,
    ) -> Result<u32, Error> {
        let Step { time, dt } = step;
        let radius = self.radius(&parts.state, &parts.work)?;
        let (state, work) = (&mut parts.state, &mut parts.work);
        match &method.scheme {
            Scheme::RungeKutta(method) => {
                self.advance(method, engine, state, work, (time, dt))?;
                Ok(method.sides())
            }
            Scheme::Stabilised(_) => {
                let method = self.stabilised(radius, dt, MOST_STAGES);
                let method = method.unwrap_or(Rkl2::with_stages(MOST_STAGES));
                self.advance_split(method, engine, state, work, (time, dt))?;
                Ok(method.stages())
            }
        }
    }
}
