//! Levels of gas dynamics.

use std::sync::atomic::Ordering;

use miette::Report;

use super::super::Failure;
use super::super::run::failure;
use super::{Runs, Subject, within};
use crate::comparison::{ExactSolution, FIELDS};
use crate::experiment::Experiment;
use crate::report::summary::Summary;
use crate::scenario::Scenario;
use crate::simulation::{Control, Plan};
use crate::study::{ErrorNorm, Level, gas_level};

/// What is studied of a gas unless told, and the fields that it has. There is no theorem to
/// compare with.
pub(super) fn subject(scenario: &Scenario) -> (Subject, Vec<String>) {
    let bounded = scenario.tolerances.first();
    let field = bounded.map_or(FIELDS[0], |tolerance| tolerance.field.name());
    let subject = Subject {
        name: scenario.name.clone(),
        dimension: scenario.dimension,
        particles: scenario.resolution.particles,
        least: 0,
        has_exact: scenario.output.exact.is_some(),
        field: field.to_owned(),
        norm: ErrorNorm::L1,
        theory: None,
    };
    (subject, FIELDS.map(String::from).to_vec())
}

/// Runs a level.
pub(super) fn level(
    runs: &mut Runs<'_>,
    scenario: Scenario,
    count: usize,
) -> Result<Option<Level>, Failure> {
    let input = |error: Report| within(count, Failure::Input(error));
    let exact = ExactSolution::of(&scenario).map_err(|error| input(error.into()))?;
    let plan = Plan::new(&scenario).map_err(|error| input(error.into()))?;
    runs.progress.begin(count);
    let (progress, interrupted) = (&runs.progress, &runs.interrupted);
    let mut control = Control {
        samples: scenario.output.samples,
        progress: &mut |done| {
            progress.show(done);
            !interrupted.load(Ordering::Relaxed)
        },
        look: &mut |_| Ok(()),
    };
    let (how, engine) = ((runs.scalar, false), &mut runs.engine);
    let experiment = Experiment::run(scenario, &plan, exact, how, engine, &mut control)
        .map_err(|error| within(count, failure(error)))?;
    let summary = Summary::new(&experiment, runs.scalar.name(), runs.engine.threads());
    runs.warn(count, summary.warnings, &experiment.doubts);
    Ok(gas_level(&experiment, &plan, runs.field))
}
