//! Whether what is made of sums over pairs stays in the range of a format that wraps.

use crate::cloud::Register;
use crate::error::{Error, Quantity};
use crate::numbered::numbered;
use crate::pairs::{Engine, holds};
use crate::scalar::Scalar;

/// A Runge-Kutta method adds up to six rates in a step, and the proof is a power of two.
const ADDED: f64 = 8.0;

/// The largest of some numbers in magnitude, and where it is; they are compared as they are.
fn largest<S: Scalar>(numbers: impl Iterator<Item = (usize, S)>) -> (usize, f64) {
    let (mut low, mut high) = ((0, S::ZERO), (0, S::ZERO));
    for (place, number) in numbers {
        if number < low.1 {
            low = (place, number);
        }
        if number > high.1 {
            high = (place, number);
        }
    }
    let (below, above) = (-low.1.to_f64(), high.1.to_f64());
    if below > above {
        (low.0, below)
    } else {
        (high.0, above)
    }
}

/// That rates that have been made leave room for what a method adds up of them.
pub(crate) fn prove_rates<S: Scalar, const D: usize, const P: usize>(
    engine: &mut impl Engine<S, D>,
    last: &[Register<S, D, P>],
) -> Result<(), Error> {
    if !S::WRAPS {
        return Ok(());
    }
    let of = |(place, rates): (usize, &Register<S, D, P>)| rates.strength.map(|rate| (place, rate));
    let (place, bound) = largest(numbered(last).flat_map(of));
    holds::<S>(Quantity::Rate, place as u32, ADDED * bound).or_else(|error| engine.unproven(error))
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
    let of = |(place, values): (usize, &[S; P])| values.map(|u| (place, u));
    let (place, value) = largest(numbered(values).flat_map(of));
    let weight = largest(numbered(weights.iter().copied())).1;
    let made = bound(value) * weight.max(1.0) * scale.to_f64().max(1.0);
    holds::<S>(Quantity::Rate, place as u32, made).or_else(|error| engine.unproven(error))
}
