//! `dc/dt = G c` with a constant matrix G.

use std::sync::{Mutex, PoisonError};

use super::super::linear::error::{SolutionError, check, check_length, finite};
use super::super::linear::modes::exponential::{exponential, product};

/// The most components: as in [`super::super::linear::system::System`].
const MOST_COMPONENTS: usize = 8;

/// c(t). The values are wrong by some `1e-16 (1 + |G| t)` of the largest ones in between.
#[derive(Debug)]
pub(super) struct Reaction {
    /// Row by row; empty if it is zero.
    generator: Vec<f64>,
    initial: Vec<f64>,
    latest: Mutex<Values>,
}

/// c at the last time asked for: points are asked for at the same time by the thousand.
#[derive(Debug)]
struct Values {
    time: f64,
    values: Vec<f64>,
}

impl Reaction {
    pub(super) fn new(mut generator: Vec<f64>, initial: Vec<f64>) -> Self {
        if generator.iter().all(|entry| *entry == 0.0) {
            generator.clear();
        }
        let latest = Mutex::new(Values {
            time: 0.0,
            values: initial.clone(),
        });
        Self {
            generator,
            initial,
            latest,
        }
    }

    /// How many.
    pub(super) fn components(&self) -> usize {
        self.initial.len()
    }

    /// Writes `factor c(t)`.
    pub(super) fn write(&self, time: f64, factor: f64, state: &mut [f64]) {
        // A thread that panicked leaves values of one time or of the other, never of both.
        let mut latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner);
        if latest.time != time {
            *latest = Values {
                time,
                values: self.values(time),
            };
        }
        for (slot, value) in state.iter_mut().zip(&latest.values) {
            *slot = factor * value;
        }
    }

    fn values(&self, time: f64) -> Vec<f64> {
        if self.generator.is_empty() {
            return self.initial.clone();
        }
        let exponent: Vec<f64> = self.generator.iter().map(|entry| entry * time).collect();
        let n = self.components();
        product(&exponential(&exponent, n), &self.initial, n)
    }
}

/// That there are 1 to 8 components, and as many numbers in `M` as they need, or none.
pub(super) fn check_reaction(reaction: &[f64], state: &[f64]) -> Result<(), SolutionError> {
    let p = state.len();
    let holds = (1..=MOST_COMPONENTS).contains(&p);
    check(&[("components", p as f64, "1 to 8", holds)])?;
    if !reaction.is_empty() {
        check_length("reaction", reaction.len(), p * p)?;
    }
    for value in state {
        check(&[finite("state", *value)])?;
    }
    for value in reaction {
        check(&[finite("reaction", *value)])?;
    }
    Ok(())
}
