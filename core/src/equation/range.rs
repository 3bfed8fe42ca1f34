//! Whether what is made of sums over pairs stays in the range of a format that wraps.

use crate::cloud::Register;
use crate::error::{Error, Quantity};
use crate::pairs::{Engine, Largest, holds};
use crate::scalar::Scalar;

/// A Runge-Kutta method adds up to six rates in a step, and the proof is a power of two.
const ADDED: f64 = 8.0;

/// That rates that have been made leave room for what a method adds up of them.
pub(crate) fn prove_rates<S: Scalar, const D: usize, const P: usize>(
    engine: &mut impl Engine<S, D>,
    last: &[Register<S, D, P>],
) -> Result<(), Error> {
    if !S::WRAPS {
        return Ok(());
    }
    let rates = Largest::of(last.iter().flat_map(|rates| &rates.strength).copied());
    fits::<S, P>(rates.times(ADDED)).or_else(|error| engine.unproven(error))
}

/// That what a particle loses and makes by itself, a function of its values, fits with its weight and
/// `scale`: `bound` bounds it and all on the way for values up to a magnitude.
pub(crate) fn prove_own<S: Scalar, const D: usize, const P: usize>(
    engine: &mut impl Engine<S, D>,
    (values, weights): (&[[S; P]], &[S]),
    scale: S,
    bound: impl Fn(f64) -> f64,
) -> Result<(), Error> {
    // As a rule there is nothing of the kind, whatever the values.
    if !S::WRAPS || bound(S::LARGEST.to_f64()) == 0.0 {
        return Ok(());
    }
    let value = Largest::of(values.iter().flatten().copied());
    let weight = Largest::of(weights.iter().copied()).bound;
    let made = Largest {
        bound: bound(value.bound) * weight.max(1.0) * scale.to_f64().max(1.0),
        ..value
    };
    fits::<S, P>(made).or_else(|error| engine.unproven(error))
}

/// A rate of one of the `P` components of a particle.
fn fits<S: Scalar, const P: usize>(rate: Largest) -> Result<(), Error> {
    let particle = rate.place.checked_div(P).unwrap_or(0) as u32;
    holds::<S>(Quantity::Rate, particle, rate.bound)
}

/// `scale w (f - a)`: what a particle gains and loses by itself; in fixed point the largest number where
/// there is no such rate, which [`prove_rates`] then sees.
#[inline(always)]
pub(crate) fn own_rate<S: Scalar>(scale: S, weight: S, [gain, loss]: [S; 2]) -> S {
    if !S::WRAPS {
        return scale * (weight * (gain - loss));
    }
    let made = S::wide_sum(S::product(weight, gain), S::product(-weight, loss));
    S::saturated(S::product(scale, S::saturated(made)))
}

/// The rate from pairs and what a particle makes by itself; in fixed point the largest number where
/// there is no such rate, which [`prove_rates`] then sees.
#[inline(always)]
pub(crate) fn with_own<S: Scalar>(pairs: S, own: S) -> S {
    match own == S::ZERO {
        true => pairs,
        false => S::saturated(S::wide_sum(
            S::product(S::ONE, pairs),
            S::product(S::ONE, own),
        )),
    }
}
