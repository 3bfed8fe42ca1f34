//! A problem whose numbers are constants of a program, in the scalar of a run.

use core::mem::take;

use super::conductor::{Conductor, Modulation};
use super::drive::{Drive, DrivenCondition};
use super::named::NamedProblem;
use super::reaction::Reaction;
use crate::error::Error;
use crate::scalar::Scalar;

/// Room for the lists of a problem in the run's scalar: `POINTS`, those of the series of all walls, and
/// `LAYERS`, those of a layered conductor.
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

impl<const D: usize, const P: usize> NamedProblem<'_, f64, D, P> {
    /// The problem in another scalar: every number rounded once. Error: lists without room for it.
    pub fn rounded<'m, S: Scalar, const POINTS: usize, const LAYERS: usize>(
        &self,
        lists: &'m mut Lists<S, POINTS, LAYERS>,
    ) -> Result<NamedProblem<'m, S, D, P>, Error> {
        let number = S::from_f64;
        let mut points = lists.points.as_mut_slice();
        let mut walls = [[[DrivenCondition::NoFlux; P]; 2]; D];
        let to = walls.iter_mut().flatten().flatten();
        for (to, of) in to.zip(self.walls.iter().flatten().flatten()) {
            *to = wall(of, &mut points)?;
        }
        Ok(NamedProblem {
            diffusivity: self.diffusivity.map(number),
            conductor: match self.conductor {
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
                amplitude: number(self.modulation.amplitude),
                frequency: number(self.modulation.frequency),
            },
            tensor: self.tensor.map(|rows| rows.map(|row| row.map(number))),
            reaction: reaction(&self.reaction),
            walls,
        })
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

/// A wall, its series in the first part of a room.
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

fn reaction<S: Scalar, const P: usize>(of: &Reaction<f64, P>) -> Reaction<S, P> {
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
