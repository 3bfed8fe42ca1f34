//! A number format and what became of the run in it.

use std::collections::BTreeMap;

use super::difference::Difference;
use super::rounding::Loss;
use crate::experiment::Experiment;
use crate::run::{Norms, ScalarName};

/// A row of the comparison.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct FormatRow {
    /// Name of the format.
    pub scalar: String,
    /// Its bits behind the point at 1.
    pub fraction_bits: u32,
    /// What became of it.
    #[serde(flatten)]
    pub outcome: FormatOutcome,
}

/// What became of a format.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(untagged)]
pub enum FormatOutcome {
    /// A run to its end.
    Ran(Box<Ran>),
    /// None.
    Refused(Refusal),
}

/// Why a format cannot hold a scenario, or did not to the end.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Refusal {
    /// The reason.
    pub refused: String,
    /// What to do about it, where that is known.
    pub cure: Option<String>,
}

/// What a run in a format came to.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Ran {
    /// `proven`: every sum over pairs was proven to stay in the range of the format before it was
    /// made. `float`: the exponent has the range.
    pub range: &'static str,
    /// Errors against the exact solution by field; `None` without one.
    pub errors: Option<BTreeMap<String, Norms>>,
    /// Difference from the reference by field; `None` of the reference itself, and where particles have
    /// no partners.
    pub difference: Option<BTreeMap<String, Difference>>,
    /// Drift of each sum of which it is known what it should be.
    pub drift: Option<BTreeMap<String, f64>>,
    /// Time reached.
    pub time: f64,
    /// Steps made.
    pub steps: u64,
    /// Wall-clock seconds of the stepping, beside the other runs.
    pub seconds: f64,
    /// Steps over seconds.
    pub steps_per_second: f64,
    /// Bytes of a particle that the next step starts from.
    pub bytes_per_particle: usize,
    /// Digest of the last state: that of `motes run` in this format.
    pub digest: String,
    /// What a careful reader should know of it.
    pub warnings: Vec<String>,
}

impl Ran {
    /// Of an experiment, without its difference.
    pub fn of(experiment: &mut Experiment) -> Self {
        let outcome = &experiment.outcome;
        let per_second = outcome.steps as f64 / outcome.seconds;
        Self {
            range: match experiment.scalar.is_fixed() {
                true => "proven",
                false => "float",
            },
            errors: experiment.errors.clone(),
            difference: None,
            drift: experiment.drift().map(|drift| drift.into_iter().collect()),
            time: outcome.time,
            steps: outcome.steps,
            seconds: outcome.seconds,
            steps_per_second: if per_second.is_finite() {
                per_second
            } else {
                0.0
            },
            digest: outcome.digest.to_string(),
            warnings: experiment.warnings(),
            bytes_per_particle: experiment.simulation.state_bytes(),
        }
    }
}

impl FormatRow {
    /// Of a format.
    pub fn new(scalar: ScalarName, outcome: FormatOutcome) -> Self {
        Self {
            scalar: scalar.name().to_owned(),
            fraction_bits: scalar.fraction_bits(),
            outcome,
        }
    }

    /// Its run; `None` where there is none.
    pub fn ran(&self) -> Option<&Ran> {
        match &self.outcome {
            FormatOutcome::Ran(ran) => Some(ran),
            FormatOutcome::Refused(_) => None,
        }
    }

    /// Why it did not run; `None` where it did.
    pub fn refusal(&self) -> Option<&Refusal> {
        match &self.outcome {
            FormatOutcome::Ran(_) => None,
            FormatOutcome::Refused(refusal) => Some(refusal),
        }
    }

    /// Its errors in a field.
    pub fn error(&self, field: &str) -> Option<&Norms> {
        self.ran()?.errors.as_ref()?.get(field)
    }

    /// Its difference in a field.
    pub fn difference(&self, field: &str) -> Option<&Difference> {
        self.ran()?.difference.as_ref()?.get(field)
    }

    /// The L2 norm of its error over a size.
    pub fn relative_error(&self, field: &str, size: Option<f64>) -> Option<f64> {
        let size = size.filter(|size| *size > 0.0)?;
        Some(self.error(field)?.l2 / size)
    }

    /// What it loses of a field.
    pub(super) fn loss(&self, field: &str) -> Option<Loss> {
        Some(Loss {
            scalar: self.scalar.clone(),
            is_fixed: self.scalar.starts_with('q'),
            bits: self.fraction_bits,
            difference: self.difference(field)?.relative_l2?,
        })
    }
}

/// The format with the most bits behind the point at 1; of several the one that [`ScalarName::ALL`] has
/// first.
pub fn finest(scalars: impl Iterator<Item = ScalarName>) -> Option<ScalarName> {
    let place = |scalar: ScalarName| ScalarName::ALL.iter().position(|row| row.0 == scalar);
    scalars.max_by_key(|scalar| (scalar.fraction_bits(), std::cmp::Reverse(place(*scalar))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_finest_format_has_the_most_bits_behind_the_point() {
        let of = |names: &[&str]| {
            let scalars = names.iter().map(|name| name.parse::<ScalarName>().unwrap());
            finest(scalars).map(ScalarName::name)
        };
        assert_eq!(of(&["f32", "f64"]), Some("f64"));
        assert_eq!(of(&[]), None);
        assert_eq!(ScalarName::F32.fraction_bits(), 23);
        #[cfg(feature = "fixed-point")]
        {
            assert_eq!(of(&["q15.16", "q12.19"]), Some("q12.19"));
            assert_eq!(of(&["q31.32", "f32"]), Some("q31.32"));
            // Its roots are approximate.
            assert_eq!(of(&["micromath", "f32"]), Some("f32"));
            assert_eq!(of(&["f32", "micromath"]), Some("f32"));
        }
    }
}
