//! Convection-diffusion in the scalar of a run.

use std::sync::Arc;

use motes_core::cloud::{Columns as _, Words};
use motes_core::cutoff::Named;
use motes_core::digest::Digest;
use motes_core::equation::Parts;
use motes_core::equation::diffusion::{
    DiffusionDynamics, DiffusionProblem, DrivenCondition, Form, Reaction,
};
use motes_core::equation::linear::{State, VelocityField};
use motes_core::error::Error;
use motes_core::integrator::{MOST_STAGES, Rkl2, RungeKutta};
use motes_core::scalar::Scalar;

use super::formulas::RunProblem;
use super::memory::DiffusionArrays;
use super::problem::{Media, form};
use crate::engine::{HostScalar, Threads};
use crate::families::strengths::{CloudView, Maker, Plan, RunField, Solver, Source, row};
use crate::scenario::linear::{ConvectionDiffusion, Method};

/// How its steps are made.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Stepping {
    /// Transport and diffusion together.
    RungeKutta(RungeKutta),
    /// Diffusion by the stabilised method between two halves of transport, with steps for so many
    /// stages.
    Stabilised(u32),
}

/// A convection-diffusion problem (4.1) on its particles.
pub(in crate::families) struct Diffusion<S: Scalar, const D: usize, const P: usize> {
    planned: Planned<S>,
    memory: DiffusionArrays<S, D, P>,
}

/// The problem and how it is stepped. The problem refers to its lists, so it is made anew from them
/// for each call.
struct Planned<S> {
    plan: Arc<Plan>,
    problem: ConvectionDiffusion,
    media: Media<S>,
    stepping: Stepping,
    /// The longest step that is made without being asked for: stability alone would let a run that is
    /// not stiff be made in one.
    longest: S,
}

type Dynamics<'a, S, const D: usize, const P: usize> =
    DiffusionDynamics<S, Named, RunProblem<'a, S, D, P>, RunField<S, D>, D, P>;

/// The fewest steps of a run whose step is not given: with steps of second order a wave that falls to
/// `1/e` is off by some 1e-5 then.
const FEWEST_STEPS: f64 = 64.0;

impl Plan {
    /// The longest step that is made without being asked for.
    pub fn longest_step(&self) -> f64 {
        self.end / FEWEST_STEPS
    }
}

impl<S: Scalar> Planned<S> {
    /// That of a plan with that problem.
    fn new(plan: &Arc<Plan>, problem: &ConvectionDiffusion) -> Self {
        Self {
            plan: Arc::clone(plan),
            problem: problem.clone(),
            media: plan.media(problem),
            stepping: match plan.method {
                Method::Rkl2 => Stepping::Stabilised(plan.stages),
                Method::Rk4 | Method::SspRk3 => Stepping::RungeKutta(plan.runge_kutta()),
            },
            longest: S::from_f64(plan.longest_step()),
        }
    }

    fn dynamics<const D: usize, const P: usize>(&self) -> Dynamics<'_, S, D, P> {
        let plan = &self.plan;
        let (form, mean) = form(&self.problem);
        DiffusionDynamics {
            domain: plan.domain(),
            cut_off: plan.cut_off,
            epsilon: S::from_f64(plan.epsilon),
            problem: plan.problem(&self.problem, &self.media),
            field: plan.motion(),
            form,
            mean,
            courant: S::from_f64(plan.courant),
        }
    }

    /// The largest `-λ dt` of a step.
    fn reach(&self, stages: u32) -> S {
        match self.stepping {
            Stepping::RungeKutta(method) => S::from_f64(method.real),
            Stepping::Stabilised(_) => Rkl2::with_stages(stages).reach(),
        }
    }
}

/// Whether something comes in through a wall.
fn is_driven<S: Scalar, const D: usize, const P: usize>(dynamics: &Dynamics<'_, S, D, P>) -> bool {
    let mut walls = dynamics.problem.named.walls.iter().flatten().flatten();
    walls.any(|wall| *wall != DrivenCondition::NoFlux)
}

impl<S: HostScalar, const D: usize, const P: usize> Diffusion<S, D, P> {
    /// Makes the solver of a plan with that problem.
    pub fn maker(problem: &ConvectionDiffusion) -> Maker<S> {
        let problem = problem.clone();
        Maker {
            bytes: DiffusionArrays::<S, D, P>::BYTES,
            make: Box::new(move |plan: &Arc<Plan>, particles| {
                let is_mixed = form(&problem).0 == Form::Mixed;
                Box::new(Self {
                    planned: Planned::new(plan, &problem),
                    memory: DiffusionArrays::new(particles.rows(), is_mixed),
                })
            }),
        }
    }
}

impl<S: HostScalar, const D: usize, const P: usize> Solver<S> for Diffusion<S, D, P> {
    fn cloud(&self) -> CloudView<'_, S> {
        self.memory.cloud.view()
    }
    fn digest(&mut self) -> Digest {
        self.memory.cloud.parts().0.digest()
    }
    fn digest_unordered(&mut self) -> Digest {
        self.memory.cloud.parts().0.digest_unordered()
    }
    fn state_bytes(&mut self) -> usize {
        self.memory.cloud.parts().0.state_bytes()
    }
    fn intake(&self, source: Source) -> Option<f64> {
        Some(source.total(&self.memory.ledger))
    }

    fn prepare(&mut self, engine: &mut Threads) -> Result<(), Error> {
        let (mut state, mut work) = self.memory.parts();
        let dynamics = self.planned.dynamics();
        dynamics.prepare(engine, &mut state, &mut work)
    }

    fn stable_step(&mut self, _: S) -> Result<Option<S>, Error> {
        let (state, work) = self.memory.parts();
        let radius = self.planned.dynamics().radius(&state, &work)?;
        Ok((radius > S::ZERO).then(|| self.planned.reach(MOST_STAGES) / radius))
    }

    fn time_step(&mut self, _: S, longest: S) -> Result<S, Error> {
        let planned = &self.planned;
        let stages = match planned.stepping {
            Stepping::Stabilised(stages) => stages,
            Stepping::RungeKutta(_) => 0,
        };
        let dynamics = planned.dynamics();
        let longest = Scalar::lesser(longest, planned.longest);
        let (state, work) = self.memory.parts();
        let radius = dynamics.radius(&state, &work)?;
        dynamics.time_step(radius, planned.reach(stages), longest)
    }

    fn advance(&mut self, engine: &mut Threads, (time, dt): (S, S)) -> Result<u32, Error> {
        let dynamics = self.planned.dynamics();
        let (mut state, mut work) = self.memory.parts();
        let (state, work) = (&mut state, &mut work);
        match self.planned.stepping {
            Stepping::RungeKutta(method) => {
                dynamics.advance(&method, engine, state, work, (time, dt))?;
                Ok(method.sides())
            }
            Stepping::Stabilised(_) => {
                let radius = dynamics.radius(state, work)?;
                let method = dynamics.stabilised(radius, dt, MOST_STAGES);
                let method = method.unwrap_or(Rkl2::with_stages(MOST_STAGES));
                dynamics.advance_split(method, engine, state, work, (time, dt))?;
                Ok(method.stages())
            }
        }
    }

    fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        let dynamics = self.planned.dynamics::<D, P>();
        let (state, work) = self.memory.parts();
        motes_core::equation::Dynamics::pass(&dynamics, &mut Parts { state, work }, words)
    }

    fn reconstruct(&mut self, time: S, points: Option<&[[S; 3]]>) -> Result<Vec<S>, Error> {
        let points = self.memory.cloud.points(points);
        let mut values = vec![[S::ZERO; P]; points.len()];
        let (state, mut work) = self.memory.parts();
        let dynamics = self.planned.dynamics();
        dynamics.reconstruct(&state, &mut work, time, (&points, &mut values))?;
        Ok(values.into_flattened())
    }

    fn energy_density(&self, _: &[S], _: S, u: &[S]) -> S {
        S::dot::<P>(&row(u), &row(u))
    }

    fn source(&self, _: &[S], _: S, rates: &mut [S]) {
        let planned = &self.planned;
        let reaction = planned.plan.reaction::<S, P>(&planned.problem.reaction);
        match reaction {
            Reaction::Linear { source, .. } => rates.copy_from_slice(&source),
            _ => rates.fill(S::ZERO),
        }
    }

    /// Diffusion by itself takes from the norm; the flow may squeeze it, a reaction feed it.
    fn growth(&self) -> Option<f64> {
        let dynamics = self.planned.dynamics::<D, P>();
        let problem = &dynamics.problem.named;
        if !dynamics.problem.formulas.rates.is_empty() {
            return None;
        }
        // Of pairs along which a tensor counts below 0, diffusion may give to the norm.
        if is_driven(&dynamics) || problem.tensor.is_some() && dynamics.form == Form::Direct {
            return None;
        }
        let squeezed = VelocityField::<S, D>::convergence(&dynamics.field);
        let fed = match &problem.reaction {
            Reaction::None => 0.0,
            Reaction::Linear { matrix, .. } => fastest(matrix),
            Reaction::Logistic { rate, .. } => rate.to_f64(),
            Reaction::GrayScott { .. } => return None,
        };
        Some(0.5 * squeezed.to_f64() + fed)
    }

    fn order(&self) -> u32 {
        match self.planned.stepping {
            Stepping::RungeKutta(method) => method.order,
            Stepping::Stabilised(_) => 2,
        }
    }

    /// Of the mixed form: waves of two spacings, which its centred sums do not see and the direct form
    /// damps the fastest. Where the rates of the two forms differ by `Λ` of the direct one,
    /// there is nothing but such waves.
    fn undamped(&mut self, engine: &mut Threads, time: S) -> Result<f64, Error> {
        let dynamics = self.planned.dynamics();
        if dynamics.form == Form::Direct {
            return Ok(0.0);
        }
        let (mut state, mut work) = self.memory.parts();
        let (state, work) = (&mut state, &mut work);
        dynamics.rates(engine, state, work, time)?;
        let mixed: Vec<[S; P]> = work.last.iter().map(|rates| rates.strength).collect();
        let direct = DiffusionDynamics {
            form: Form::Direct,
            ..dynamics
        };
        direct.rates(engine, state, work, time)?;
        let reacted = direct.problem.reaction_rate();
        let fastest = (direct.radius(state, work)? - reacted).to_f64();
        let squared = direct.epsilon.to_f64() * direct.epsilon.to_f64();
        let scale = squared * fastest;
        let rows = mixed.iter().zip(work.last.iter());
        let mut off = 0.0;
        for ((mixed, direct), w) in rows.zip(state.weight.iter()) {
            let w = w.to_f64();
            for (mixed, direct) in mixed.iter().zip(&direct.strength) {
                let part = (direct.to_f64() - mixed.to_f64()) / (scale * w);
                off += w * part * part;
            }
        }
        let varied = variation(state);
        Ok(match off > 0.0 && varied > 0.0 {
            true => (off / varied).sqrt(),
            false => 0.0,
        })
    }
}

/// `Σ w |u - mean|²`.
fn variation<S: Scalar, const D: usize, const P: usize>(state: &State<'_, S, D, P>) -> f64 {
    let rows = || state.weight.iter().zip(state.value.iter());
    let volume: f64 = state.weight.iter().map(|w| w.to_f64()).sum();
    let of = |j: usize| {
        let sum: f64 = rows().map(|(w, u)| w.to_f64() * u[j].to_f64()).sum();
        let mean = sum / volume;
        let squares = rows().map(|(w, u)| {
            let off = u[j].to_f64() - mean;
            w.to_f64() * off * off
        });
        squares.sum::<f64>()
    };
    (0..P).map(of).sum()
}

/// A bound of `(u·Mu)/|u|²`, at least 0: of the circles of the symmetric part, as what only turns
/// `u` feeds nothing, and of the largest singular value.
fn fastest<S: Scalar, const P: usize>(matrix: &[[S; P]; P]) -> f64 {
    let entry = |i: usize, j: usize| matrix[i][j].to_f64();
    let circle = |i: usize| {
        let others = (0..P).filter(|&j| j != i);
        let radius: f64 = others.map(|j| (entry(i, j) + entry(j, i)).abs()).sum();
        entry(i, i) + 0.5 * radius
    };
    (0..P).map(circle).fold(0.0, f64::max).min(norm(matrix))
}

/// A bound of the largest singular value: of rows and columns `√(‖M‖_1 ‖M‖_∞)`.
fn norm<S: Scalar, const P: usize>(matrix: &[[S; P]; P]) -> f64 {
    let size = |i: usize, j: usize| matrix[i][j].to_f64().abs();
    let largest = |sum: &dyn Fn(usize) -> f64| (0..P).map(sum).fold(0.0, f64::max);
    let rows = largest(&|i| (0..P).map(|j| size(i, j)).sum());
    let columns = largest(&|j| (0..P).map(|i| size(i, j)).sum());
    (rows * columns).sqrt()
}
