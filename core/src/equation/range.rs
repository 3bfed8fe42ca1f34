//! Whether what is made of sums over pairs stays in the range of a format that wraps.

use crate::cloud::Register;
use crate::error::{Error, Quantity};
use crate::numbered::numbered;
use crate::pairs::{Engine, holds};
use crate::scalar::Scalar;

/// A Runge-Kutta method adds up to six rates in a step, and the proof is a power of two.
const ADDED: f64 = 8.0;
/// Below this part of the range nothing has to be looked at more closely.
const ROOM: f64 = 0.99;

/// The largest magnitude of some numbers; they are compared as they are.
#[inline(always)]
fn largest<'a, S: Scalar>(numbers: impl Iterator<Item = &'a S>) -> S {
    let (mut low, mut high) = (S::ZERO, S::ZERO);
    for &number in numbers {
        (low, high) = (low.lesser(number), high.greater(number));
    }
    high.greater(-low)
}

/// Who has the largest of these.
#[cold]
fn who<'a, S: Scalar, const P: usize>(rows: impl Iterator<Item = &'a [S; P]>) -> u32 {
    let (mut who, mut most) = (0, S::ZERO);
    for (place, row) in numbered(rows) {
        let size = largest(row.iter());
        if size > most {
            (who, most) = (place, size);
        }
    }
    who as u32
}

/// That rates that have been made leave room for what a method adds up of them.
pub(crate) fn prove_rates<S: Scalar, const D: usize, const P: usize>(
    engine: &mut impl Engine<S, D>,
    last: &[Register<S, D, P>],
) -> Result<(), Error> {
    if !S::WRAPS {
        return Ok(());
    }
    let rows = || last.iter().map(|rates| &rates.strength);
    let bound = ADDED * largest(rows().flatten()).to_f64();
    if bound < ROOM * S::LARGEST.to_f64() {
        return Ok(());
    }
    holds::<S>(Quantity::Rate, who(rows()), bound).or_else(|error| engine.unproven(error))
}

/// That what a particle loses and makes by itself, a function of its values, fits with its weight and
/// `scale`: `largest` bounds it and all on the way for values up to a magnitude.
pub(crate) fn prove_own<S: Scalar, const D: usize, const P: usize>(
    engine: &mut impl Engine<S, D>,
    (values, weights): (&[[S; P]], &[S]),
    scale: S,
    bound: impl FnOnce(f64) -> f64,
) -> Result<(), Error> {
    if !S::WRAPS {
        return Ok(());
    }
    let value = largest(values.iter().flatten()).to_f64();
    let weight = largest(weights.iter()).to_f64();
    let made = bound(value) * weight.max(1.0) * scale.to_f64().max(1.0);
    if made < ROOM * S::LARGEST.to_f64() {
        return Ok(());
    }
    holds::<S>(Quantity::Rate, who(values.iter()), made).or_else(|error| engine.unproven(error))
}
