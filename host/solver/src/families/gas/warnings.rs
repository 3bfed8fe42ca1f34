//! What a run of a gas shows of its own unsoundness.

use std::fmt::{Display, Formatter, Result};

use motes_core::cloud::Words;
use motes_core::error::Error;
use motes_core::scalar::Scalar;

use crate::run::Outcome;

/// A particle with fewer neighbours than a density can be trusted with.
pub(super) struct Lonely {
    pub particle: usize,
    pub time: f64,
    pub neighbours: f64,
}

impl Lonely {
    /// Passes one, where there is one.
    pub fn pass(
        lonely: &mut Option<Self>,
        words: &mut dyn Words,
    ) -> std::result::Result<(), Error> {
        let mut is_there = u64::from(lonely.is_some());
        words.count(&mut is_there)?;
        let told = lonely.take();
        let mut particle = told.as_ref().map_or(0, |told| told.particle as u64);
        let (mut time, mut neighbours) =
            told.map_or((0.0, 0.0), |told| (told.time, told.neighbours));
        words.count(&mut particle)?;
        words.scalar(&mut time)?;
        words.scalar(&mut neighbours)?;
        *lonely = (is_there != 0).then_some(Self {
            particle: particle as usize,
            time,
            neighbours,
        });
        Ok(())
    }
}

impl Display for Lonely {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(
            f,
            "particle {} had {} neighbour(s) at t = {:.6}: its density no longer feels the \
             spacing, and waves may move at wrong speeds; use eta, or a larger epsilon",
            self.particle, self.neighbours, self.time
        )
    }
}

/// The energy that a sound run may gain or lose: leap-frog and viscosity stay far below it.
const SOUND_DRIFT: f64 = 1e-3;

/// A warning where the energy has moved as it does not in a sound run.
pub(super) fn drifted<S: Scalar>(outcome: &Outcome) -> Option<String> {
    let drift = outcome.drift_of("energy");
    let cause = match S::HAS_EXACT_SUMS {
        true => {
            "numbers may have overflowed (--check-overflow tells), else the time step is too large \
             (time.courant)"
        }
        false => "the time step is too large: use a smaller time.courant",
    };
    (outcome.is_conserving && !(drift.abs() < SOUND_DRIFT)).then(|| {
        format!("the total energy moved by {drift:.1e} of kinetic, internal and external energy: {cause}")
    })
}
