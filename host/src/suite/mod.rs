//! The standard test suite: built-in scenarios and variants of them, what is measured of each,
//! and the bound it is held to.
//!
//! Errors against exact solutions are bounded in the scenario files (`[tolerance]`); what
//! else is measured is a row of [`CASES`].

mod cases;
mod cavity;
mod measure;

pub use cases::{CASES, Case};
pub use measure::Measure;

use crate::engine::Threads;
use crate::experiment::{Experiment, ExperimentError};
use crate::report::suite::{Check, SuiteRow};
use crate::run::{Control, ScalarName, Simulation};
use crate::scenario::{AnyScenario, ScenarioError, Source};
use crate::study::order;

/// Why a case has no row.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SuiteError {
    /// Its scenario cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scenario(#[from] ScenarioError),
    /// It cannot be run.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Experiment(#[from] ExperimentError),
}

/// The row of a case, and the run behind it.
pub struct Measured {
    /// The row, without a picture.
    pub row: SuiteRow,
    /// The run.
    pub experiment: Experiment,
}

impl Case {
    /// What the case is called: its scenario, and what is different.
    pub fn name(&self) -> String {
        match self.variant {
            "" => self.scenario.to_owned(),
            variant => format!("{} ({variant})", self.scenario),
        }
    }

    /// The name as that of a file: letters, digits and `-`.
    pub fn file_name(&self) -> String {
        let words = format!("{} {}", self.scenario, self.variant);
        let plain = |c: char| c.is_ascii_alphanumeric();
        let words = words.split(|c| !plain(c)).filter(|word| !word.is_empty());
        words.collect::<Vec<_>>().join("-")
    }

    /// Whether the case is run with a scalar of that name.
    pub fn takes(&self, scalar: &str) -> bool {
        let fixed = scalar.starts_with('q');
        !fixed || self.in_fixed_point
    }

    /// Why the case is not run with a scalar of that name, if it is not.
    pub fn unfit(&self, scalar: &str) -> Option<&'static str> {
        let row = self.unfit.iter().find(|(name, _)| *name == scalar);
        row.map(|(_, reason)| *reason)
    }

    /// Its scenario, with more changes.
    ///
    /// # Errors
    /// What keeps it from being one.
    pub fn scenario(&self, more: &[String]) -> Result<AnyScenario, ScenarioError> {
        let own = self.changes.iter().map(|change| (*change).to_owned());
        let changes: Vec<String> = own.chain(more.iter().cloned()).collect();
        AnyScenario::read(Source::BuiltIn(self.scenario.to_owned()), &changes)
    }

    /// Runs the case and what it needs beside, and measures it.
    ///
    /// # Errors
    /// A run that cannot be made, or that stopped.
    pub fn measure(
        &self,
        scalar: ScalarName,
        engine: &mut Threads,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Measured, SuiteError> {
        let mut growth = measure::Amplitudes::default();
        let wants_growth = self
            .measures
            .iter()
            .any(|measure| matches!(measure, Measure::Growth { .. }));
        let experiment = self.run(&[], scalar, engine, progress, &mut |simulation| {
            if wants_growth {
                growth.add(simulation);
            }
            Ok(())
        })?;
        let mut checks = tolerances(&experiment, scalar.name());
        for measure in self.measures {
            checks.extend(match *measure {
                Measure::Order {
                    field,
                    norm,
                    particles,
                    least,
                    reason,
                } if scalar == ScalarName::F64 => {
                    let mut errors = Vec::new();
                    for &count in particles {
                        let more = [format!("resolution.particles={count}")];
                        let run = self.run(&more, scalar, engine, progress, &mut |_| Ok(()))?;
                        let spacing =
                            1.0 / (count as f64).powf(1.0 / run.scenario.dimension() as f64);
                        let error = run.errors.map_or(f64::NAN, |errors| errors[field].of(norm));
                        errors.push((spacing, error));
                    }
                    Some(Check {
                        what: format!("{field} {} order", norm.name().to_uppercase()),
                        measured: order(&errors),
                        bound: least,
                        reason: reason.to_owned(),
                        lower: true,
                    })
                }
                // The order is one of the method; rounding would only hide it.
                Measure::Order { .. } => None,
                _ => measure.check(&experiment, &growth, scalar),
            });
        }
        let outcome = &experiment.outcome;
        let row = SuiteRow {
            scenario: self.name(),
            scalar: scalar.name().to_owned(),
            dimension: experiment.scenario.dimension(),
            particles: outcome.particles,
            steps: outcome.steps,
            seconds: outcome.seconds,
            smallest_step: outcome.smallest_step,
            checks,
            energy_drift: outcome.drift_of("energy"),
            momentum_drift: outcome.drift_of("momentum"),
            digest: outcome.digest.to_string(),
            note: self.note(&experiment),
            picture: None,
        };
        Ok(Measured { row, experiment })
    }

    fn note(&self, experiment: &Experiment) -> Option<String> {
        let changes = match self.changes {
            [] => None,
            changes => Some(format!("run with --set {}", changes.join(" --set "))),
        };
        let notes: Vec<String> = changes
            .into_iter()
            .chain(experiment.doubts.iter().cloned())
            .collect();
        (!notes.is_empty()).then(|| notes.join("; "))
    }

    fn run(
        &self,
        more: &[String],
        scalar: ScalarName,
        engine: &mut Threads,
        progress: &mut dyn FnMut(f64) -> bool,
        look: &mut dyn FnMut(&dyn Simulation) -> Result<(), String>,
    ) -> Result<Experiment, SuiteError> {
        let scenario = self.scenario(more)?;
        let mut control = Control {
            samples: scenario.samples(),
            progress,
            look,
            keep: None,
            from: None,
        };
        Ok(Experiment::run(
            scenario,
            (scalar, false),
            engine,
            &mut control,
        )?)
    }
}

/// By how much the errors in fixed point may exceed the bounds: with 19 digits behind the point
/// a step of a strong shock rounds away some of them.
const IN_FIXED_POINT: f64 = 2.0;

/// The errors that a scenario bounds.
fn tolerances(experiment: &Experiment, scalar: &str) -> Vec<Check> {
    let factor = match scalar.starts_with('q') {
        true => IN_FIXED_POINT,
        false => 1.0,
    };
    let reason = |reason: String| match factor == 1.0 {
        true => reason,
        false => format!("{reason}; {factor} times that of floating point: digits lost in steps"),
    };
    let check = |tolerance: crate::scenario::Tolerance<String>| {
        let (field, norm) = (tolerance.field, tolerance.norm);
        let errors = experiment.errors.as_ref();
        Check {
            what: format!("{field} {}", norm.name().to_uppercase()),
            measured: errors.map_or(f64::NAN, |errors| errors[&field].of(norm)),
            bound: factor * tolerance.value,
            reason: reason(tolerance.reason),
            lower: false,
        }
    };
    experiment
        .scenario
        .tolerances()
        .into_iter()
        .map(check)
        .collect()
}
