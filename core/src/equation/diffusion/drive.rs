//! Walls whose numbers change in time.

use super::wall::Condition;
use crate::scalar::Scalar;

/// A number that may change in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive<'a, S> {
    /// The same at all times.
    Constant(S),
    /// `(time, value)`, times ascending: linear between two points, constant before the first and
    /// after the last; 0 without any.
    Series(&'a [(S, S)]),
}

impl<S: Scalar> Drive<'_, S> {
    /// Its value at a time.
    pub fn at(&self, time: S) -> S {
        let points = match self {
            Self::Constant(value) => return *value,
            Self::Series(points) => *points,
        };
        let after = points.partition_point(|&(start, _)| start <= time);
        let before = after.checked_sub(1).and_then(|i| points.get(i));
        match (before, points.get(after)) {
            (Some(&(start, from)), Some(&(end, to))) => {
                from + (to - from) * ((time - start) / (end - start))
            }
            (Some(&(_, value)), None) | (None, Some(&(_, value))) => value,
            (None, None) => S::ZERO,
        }
    }
}

/// A [`Condition`] whose numbers may change in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DrivenCondition<'a, S> {
    /// See [`Condition::NoFlux`].
    NoFlux,
    /// See [`Condition::Value`].
    Value(Drive<'a, S>),
    /// See [`Condition::Flux`].
    Flux(Drive<'a, S>),
    /// See [`Condition::Exchange`].
    Exchange {
        /// How well the wall conducts, length/time, >= 0.
        rate: S,
        /// `u` beyond it.
        outside: Drive<'a, S>,
    },
}

impl<S: Scalar> DrivenCondition<'_, S> {
    /// What holds at a time.
    pub fn at(&self, time: S) -> Condition<S> {
        match self {
            Self::NoFlux => Condition::NoFlux,
            Self::Value(value) => Condition::Value(value.at(time)),
            Self::Flux(flux) => Condition::Flux(flux.at(time)),
            Self::Exchange { rate, outside } => Condition::Exchange {
                rate: *rate,
                outside: outside.at(time),
            },
        }
    }
}
