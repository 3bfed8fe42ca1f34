//! The three registers of a Runge-Kutta step over a cloud of strengths.

use super::state::State;
use crate::domain::Domain;
use crate::error::Error;
use crate::numbered::numbered;
use crate::scalar::Scalar;

/// Rates of a particle, or a sum of them: `dx/dt`, `dw/dt`, `ε dq/dt`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Register<S, const D: usize, const P: usize> {
    /// Of the position: `a`.
    pub position: [S; D],
    /// Of the weight: `w div a`.
    pub weight: S,
    /// Of the strength, times ε.
    pub strength: [S; P],
}

impl<S: Scalar, const D: usize, const P: usize> Register<S, D, P> {
    /// No rates.
    pub const ZERO: Self = Self {
        position: [S::ZERO; D],
        weight: S::ZERO,
        strength: [S::ZERO; P],
    };

    /// Adds `n` times other rates, by repeated sums: exact in fixed point.
    pub(crate) fn add(&mut self, n: u32, rates: &Self) {
        for _ in 0..n {
            for (sum, &rate) in self.position.iter_mut().zip(&rates.position) {
                *sum += rate;
            }
            self.weight += rates.weight;
            for (sum, &rate) in self.strength.iter_mut().zip(&rates.strength) {
                *sum += rate;
            }
        }
    }
}

/// What a particle was at the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<S: Scalar, const D: usize, const P: usize> {
    /// Its position.
    pub position: [S; D],
    /// Its weight.
    pub weight: S,
    /// Its strength.
    pub strength: [S::Wide; P],
}

/// Remembers a state as the start of a step.
pub(crate) fn remember<S: Scalar, const D: usize, const P: usize>(
    state: &State<'_, S, D, P>,
    start: &mut [Start<S, D, P>],
) -> Result<(), Error> {
    let Some(start) = start.get_mut(..state.len()) else {
        return Err(Error::Lengths);
    };
    let rows = start.iter_mut().zip(state.position.iter());
    let rows = rows.zip(state.weight.iter());
    for (((start, &position), &weight), &strength) in rows.zip(state.strength.iter()) {
        *start = Start {
            position,
            weight,
            strength,
        };
    }
    Ok(())
}

/// Remembers the strengths of a state as those of the start of a step; where its particles were then
/// stays what it is.
pub(crate) fn remember_strengths<S: Scalar, const D: usize, const P: usize>(
    state: &State<'_, S, D, P>,
    start: &mut [Start<S, D, P>],
) -> Result<(), Error> {
    let start = start.get_mut(..state.len()).ok_or(Error::Lengths)?;
    for (start, &strength) in start.iter_mut().zip(state.strength.iter()) {
        start.strength = strength;
    }
    Ok(())
}

/// Empties the sum of the rates of a step for so many particles.
pub(crate) fn clear<S: Scalar, const D: usize, const P: usize>(
    particles: usize,
    sum: &mut [Register<S, D, P>],
) -> Result<(), Error> {
    let sum = sum.get_mut(..particles).ok_or(Error::Lengths)?;
    sum.fill(Register::ZERO);
    Ok(())
}

/// Adds `n` times the last rates to the sum.
pub(crate) fn accumulate<S: Scalar, const D: usize, const P: usize>(
    sum: &mut [Register<S, D, P>],
    last: &[Register<S, D, P>],
    n: u32,
) {
    for (sum, last) in sum.iter_mut().zip(last) {
        sum.add(n, last);
    }
}

/// Puts a state at the start of its step plus `dt` times some rates; those of strengths, which
/// are carried times a power of ε, times `per_power` (rates times `1/ε` would lose digits).
pub(crate) fn put<S: Scalar, const D: usize, const P: usize>(
    state: &mut State<'_, S, D, P>,
    (start, rates): (&[Start<S, D, P>], &[Register<S, D, P>]),
    moved: Option<(&Domain<S, D>, S)>,
    per_power: S,
) -> Result<(), Error> {
    for (id, (start, rates)) in numbered(start.iter().zip(rates)) {
        let Some(row) = state.row(id) else { break };
        if let Some((domain, dt)) = moved {
            *row.position = start.position;
            let step = rates.position.map(|a| dt * a);
            domain.drift(row.position, &step, id as u32)?;
            *row.weight = start.weight + dt * rates.weight;
        }
        let components = row.strength.iter_mut().zip(&start.strength);
        for ((strength, &q), &rate) in components.zip(&rates.strength) {
            *strength = S::wide_sum(q, S::product(per_power, rate));
        }
        row.revalue();
    }
    Ok(())
}
