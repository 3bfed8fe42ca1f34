//! Convection-diffusion in the scalar of a run.

use motes_core::cutoff::CutOff;
use motes_core::equation::diffusion::{
    DiffusionDynamics, DiffusionProblem, DiffusionWorkspace, DrivenCondition, Form, NamedProblem,
    Reaction,
};
use motes_core::equation::linear::{NamedField, Particle, Place, State, VelocityField};
use motes_core::error::Error;
use motes_core::integrator::{MOST_STAGES, Rkl2, RungeKutta};
use motes_core::scalar::Scalar;

use super::super::arrays::DiffusionArrays;
use super::super::plan::Plan;
use super::super::solver::Solver;
use crate::engine::{HostScalar, Threads};

/// How its steps are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::linear) enum Stepping {
    /// Transport and diffusion together.
    RungeKutta(RungeKutta),
    /// Diffusion by the stabilised method between two halves of transport, with steps for so many
    /// stages.
    Stabilised(u32),
}

/// A convection-diffusion problem (4.1) and how it is stepped.
pub(in crate::linear) struct Diffusion<'a, S, C, const D: usize, const P: usize> {
    pub dynamics: DiffusionDynamics<S, C, NamedProblem<'a, S, D, P>, NamedField<S, D>, D, P>,
    pub stepping: Stepping,
    /// The longest step that is made without being asked for: stability alone would let a run that is
    /// not stiff be made in one.
    pub longest: S,
}

/// The fewest steps of a run whose step is not given: with steps of second order a wave that falls to
/// `1/e` is off by some 1e-5 then.
const FEWEST_STEPS: f64 = 64.0;

impl Plan {
    /// The longest step that is made without being asked for.
    pub fn longest_step(&self) -> f64 {
        self.end / FEWEST_STEPS
    }
}

impl<S: HostScalar, C: CutOff, const D: usize, const P: usize> Diffusion<'_, S, C, D, P> {
    /// The bound of the spectral radius that the rates made last give.
    fn radius(&self, state: &State<'_, S, D, P>, work: &DiffusionWorkspace<'_, S, D, P>) -> S {
        self.dynamics.radius(state, work)
    }

    /// The largest `-λ dt` of a step.
    fn reach(&self, stages: u32) -> S {
        match self.stepping {
            Stepping::RungeKutta(method) => S::from_f64(method.real),
            Stepping::Stabilised(_) => Rkl2::with_stages(stages).reach(),
        }
    }

    /// Whether something comes in through a wall.
    fn is_driven(&self) -> bool {
        let walls = self.dynamics.problem.walls.iter().flatten().flatten();
        walls
            .filter(|&wall| *wall != DrivenCondition::NoFlux)
            .count()
            > 0
    }
}

impl<S: HostScalar, C: CutOff, const D: usize, const P: usize> Solver<S, D, P>
    for Diffusion<'_, S, C, D, P>
{
    type Arrays = DiffusionArrays<S, D, P>;
    type Work<'a> = DiffusionWorkspace<'a, S, D, P>;

    fn arrays(&self, particles: Vec<Particle<S, D, P>>) -> Self::Arrays {
        DiffusionArrays::new(&particles, self.dynamics.form == Form::Mixed)
    }
    fn parts(arrays: &mut Self::Arrays) -> (State<'_, S, D, P>, Self::Work<'_>) {
        arrays.parts()
    }

    fn prepare(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
    ) -> Result<(), Error> {
        self.dynamics.prepare(engine, state, work)
    }

    fn stable_step(&self, state: &State<'_, S, D, P>, work: &Self::Work<'_>, _: S) -> Option<S> {
        let radius = self.radius(state, work);
        (radius > S::ZERO).then(|| self.reach(MOST_STAGES) / radius)
    }

    fn time_step(
        &self,
        state: &State<'_, S, D, P>,
        work: &Self::Work<'_>,
        _: S,
        longest: S,
    ) -> Result<S, Error> {
        let stages = match self.stepping {
            Stepping::Stabilised(stages) => stages,
            Stepping::RungeKutta(_) => 0,
        };
        let radius = self.radius(state, work);
        let longest = Scalar::lesser(longest, self.longest);
        self.dynamics.time_step(radius, self.reach(stages), longest)
    }

    fn advance(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        (time, dt): (S, S),
    ) -> Result<u32, Error> {
        let dynamics = &self.dynamics;
        match self.stepping {
            Stepping::RungeKutta(method) => {
                dynamics.advance(&method, engine, state, work, (time, dt))?;
                Ok(method.sides())
            }
            Stepping::Stabilised(_) => {
                let radius = self.radius(state, work);
                let method = dynamics.stabilised(radius, dt, MOST_STAGES);
                let method = method.unwrap_or(Rkl2::with_stages(MOST_STAGES));
                dynamics.advance_split(method, engine, state, work, (time, dt))?;
                Ok(method.stages())
            }
        }
    }

    /// They are counted at every stage.
    fn count_neighbours(
        &self,
        _: &mut Threads,
        _: &mut State<'_, S, D, P>,
        _: &mut Self::Work<'_>,
        _: S,
    ) -> Result<(), Error> {
        Ok(())
    }

    fn reconstruct(
        &self,
        state: &State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        time: S,
        points: &[[S; D]],
        values: &mut [[S; P]],
    ) -> Result<(), Error> {
        self.dynamics
            .reconstruct(state, work, time, (points, values))
    }

    fn energy_density(&self, _: &Place<S, D>, u: &[S; P]) -> S {
        S::dot(u, u)
    }

    fn source(&self, _: &Place<S, D>) -> [S; P] {
        match self.dynamics.problem.reaction {
            Reaction::Linear { source, .. } => source,
            _ => [S::ZERO; P],
        }
    }

    /// Diffusion by itself takes from the norm; the flow may squeeze it, a reaction feed it.
    fn growth(&self) -> Option<f64> {
        let problem = &self.dynamics.problem;
        // Of pairs along which a tensor counts below 0, diffusion may give to the norm.
        if self.is_driven() || problem.tensor.is_some() && self.dynamics.form == Form::Direct {
            return None;
        }
        let squeezed = VelocityField::<S, D>::convergence(&self.dynamics.field);
        let fed = match &problem.reaction {
            Reaction::None => 0.0,
            Reaction::Linear { matrix, .. } => fastest(matrix),
            Reaction::Logistic { rate, .. } => rate.to_f64(),
            Reaction::GrayScott { .. } => return None,
        };
        Some(0.5 * squeezed.to_f64() + fed)
    }

    fn order(&self) -> u32 {
        match self.stepping {
            Stepping::RungeKutta(method) => method.order,
            Stepping::Stabilised(_) => 2,
        }
    }

    /// Of the mixed form: waves of two spacings, which its centred sums do not see and the direct form
    /// damps the fastest. Where the rates of the two forms differ by `Λ` of the direct one,
    /// there is nothing but such waves.
    fn undamped(
        &self,
        engine: &mut Threads,
        state: &mut State<'_, S, D, P>,
        work: &mut Self::Work<'_>,
        time: S,
    ) -> Result<f64, Error> {
        if self.dynamics.form == Form::Direct {
            return Ok(0.0);
        }
        self.dynamics.rates(engine, state, work, time)?;
        let mixed: Vec<[S; P]> = work.last.iter().map(|rates| rates.strength).collect();
        let direct = DiffusionDynamics {
            form: Form::Direct,
            ..self.dynamics
        };
        direct.rates(engine, state, work, time)?;
        let reacted = self.dynamics.problem.reaction_rate();
        let fastest = (direct.radius(state, work) - reacted).to_f64();
        let squared = self.dynamics.epsilon.to_f64() * self.dynamics.epsilon.to_f64();
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
        Ok(if off > 0.0 && varied > 0.0 {
            (off / varied).sqrt()
        } else {
            0.0
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
