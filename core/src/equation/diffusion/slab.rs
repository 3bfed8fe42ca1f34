//! A slab in one dimension: its first state, its problem and its solver, from plain numbers.
//!
//! A device sets up its run with this code, and a server makes the same of the same numbers, so
//! that equal numbers give equal bits.

use core::mem::take;

use super::conductor::{Conductor, Modulation};
use super::drive::{Drive, DrivenCondition};
use super::dynamics::{DiffusionDynamics, Form};
use super::mean::Mean;
use super::named::NamedProblem;
use super::reaction::Reaction;
use crate::cloud::{Particle, VelocityField};
use crate::cutoff::CutOff;
use crate::domain::{Axis, Domain, Side};
use crate::error::Error;
use crate::scalar::Scalar;

/// One species between two walls or on a ring, in solver units, every number an `f64` that the
/// run's scalar rounds once. For the direct form and the stabilised method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab<'a> {
    /// The domain is from minus this to plus this.
    pub half_length: f64,
    /// What is at its ends.
    pub sides: [Side; 2],
    /// Diffusivity, reaction and walls.
    pub problem: NamedProblem<'a, f64, 1, 1>,
    /// Of the diffusivities of two particles.
    pub mean: Mean,
    /// The particles at the start.
    pub cloud: &'a [Particle<f64, 1, 1>],
    /// ε.
    pub epsilon: f64,
    /// Factor of the stable time step, in (0, 1].
    pub courant: f64,
    /// For how many stages a step is made.
    pub stages: u32,
    /// The longest step that is made without being given.
    pub longest: f64,
    /// The time step, where it is given: at most the stable one.
    pub step: Option<f64>,
    /// Duration.
    pub end: f64,
}

/// Room for the lists of a slab's problem in the run's scalar: `POINTS`, those of the series of both
/// walls, and `LAYERS`, those of a layered conductor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lists<S, const POINTS: usize, const LAYERS: usize> {
    points: [(S, S); POINTS],
    bounds: [S; LAYERS],
    factors: [S; LAYERS],
}

impl<S: Scalar, const POINTS: usize, const LAYERS: usize> Lists<S, POINTS, LAYERS> {
    /// Nothing in them yet.
    pub const fn new() -> Self {
        Self {
            points: [(S::ZERO, S::ZERO); POINTS],
            bounds: [S::ZERO; LAYERS],
            factors: [S::ZERO; LAYERS],
        }
    }
}

impl<S: Scalar, const POINTS: usize, const LAYERS: usize> Default for Lists<S, POINTS, LAYERS> {
    fn default() -> Self {
        Self::new()
    }
}

impl Slab<'_> {
    /// The solver, with the cut-off and the motion of the caller's choice; its problem is
    /// [`Slab::problem`].
    pub fn dynamics<'m, S, C, A>(
        &self,
        cut_off: C,
        problem: NamedProblem<'m, S, 1, 1>,
        field: A,
    ) -> DiffusionDynamics<S, C, NamedProblem<'m, S, 1, 1>, A, 1, 1>
    where
        S: Scalar,
        C: CutOff,
        A: VelocityField<S, 1>,
    {
        DiffusionDynamics {
            domain: Domain {
                axes: [Axis {
                    lower: S::from_f64(-self.half_length),
                    upper: S::from_f64(self.half_length),
                    sides: self.sides,
                }],
            },
            cut_off,
            epsilon: S::from_f64(self.epsilon),
            problem,
            field,
            form: Form::Direct,
            mean: self.mean,
            courant: S::from_f64(self.courant),
        }
    }

    /// The problem, rounded to the scalar. Error: lists without room for it.
    pub fn problem<'m, S: Scalar, const POINTS: usize, const LAYERS: usize>(
        &self,
        lists: &'m mut Lists<S, POINTS, LAYERS>,
    ) -> Result<NamedProblem<'m, S, 1, 1>, Error> {
        let of = &self.problem;
        let number = S::from_f64;
        let [[[lower], [upper]]] = &of.walls;
        let mut points = lists.points.as_mut_slice();
        Ok(NamedProblem {
            diffusivity: of.diffusivity.map(number),
            conductor: match of.conductor {
                Conductor::Uniform => Conductor::Uniform,
                Conductor::Parabola { center, radius } => Conductor::Parabola {
                    center: number(center),
                    radius: number(radius),
                },
                Conductor::Layers { bounds, factors } => Conductor::Layers {
                    bounds: rounded(bounds, &mut lists.bounds.as_mut_slice(), number)?,
                    factors: rounded(factors, &mut lists.factors.as_mut_slice(), number)?,
                },
            },
            modulation: Modulation {
                amplitude: number(of.modulation.amplitude),
                frequency: number(of.modulation.frequency),
            },
            tensor: of.tensor.map(|rows| rows.map(|row| row.map(number))),
            reaction: reaction(&of.reaction),
            walls: [[[wall(lower, &mut points)?], [wall(upper, &mut points)?]]],
        })
    }

    /// The particles of the first state, rounded to the scalar.
    pub fn particles<S: Scalar>(&self) -> impl Iterator<Item = Particle<S, 1, 1>> {
        self.cloud.iter().map(Particle::rounded)
    }

    /// The time step, where it is given.
    pub fn step<S: Scalar>(&self) -> Option<S> {
        self.step.map(S::from_f64)
    }

    /// The longest step that is made without being given.
    pub fn longest<S: Scalar>(&self) -> S {
        S::from_f64(self.longest)
    }

    /// The duration of the run.
    pub fn duration<S: Scalar>(&self) -> S {
        S::from_f64(self.end)
    }
}

/// A list, rounded into the first part of a room; the rest stays room.
fn rounded<'m, T: Copy, U>(
    list: &[T],
    room: &mut &'m mut [U],
    round: impl Fn(T) -> U,
) -> Result<&'m [U], Error> {
    let parts = take(room).split_at_mut_checked(list.len());
    let (made, rest) = parts.ok_or(Error::Lengths)?;
    for (made, &number) in made.iter_mut().zip(list) {
        *made = round(number);
    }
    *room = rest;
    Ok(made)
}

fn wall<'m, S: Scalar>(
    of: &DrivenCondition<'_, f64>,
    points: &mut &'m mut [(S, S)],
) -> Result<DrivenCondition<'m, S>, Error> {
    let mut driven = |drive: &Drive<'_, f64>| match *drive {
        Drive::Constant(value) => Ok(Drive::Constant(S::from_f64(value))),
        Drive::Series(series) => {
            let point = |(time, value)| (S::from_f64(time), S::from_f64(value));
            rounded(series, points, point).map(Drive::Series)
        }
    };
    Ok(match of {
        DrivenCondition::NoFlux => DrivenCondition::NoFlux,
        DrivenCondition::Value(value) => DrivenCondition::Value(driven(value)?),
        DrivenCondition::Flux(flux) => DrivenCondition::Flux(driven(flux)?),
        DrivenCondition::Exchange { rate, outside } => DrivenCondition::Exchange {
            rate: S::from_f64(*rate),
            outside: driven(outside)?,
        },
    })
}

fn reaction<S: Scalar>(of: &Reaction<f64, 1>) -> Reaction<S, 1> {
    let number = S::from_f64;
    match *of {
        Reaction::None => Reaction::None,
        Reaction::Linear { matrix, source } => Reaction::Linear {
            matrix: matrix.map(|row| row.map(number)),
            source: source.map(number),
        },
        Reaction::Logistic { rate, capacity } => Reaction::Logistic {
            rate: number(rate),
            capacity: number(capacity),
        },
        Reaction::GrayScott { feed, kill, unit } => Reaction::GrayScott {
            feed: number(feed),
            kill: number(kill),
            unit: number(unit),
        },
    }
}
