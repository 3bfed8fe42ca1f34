//! Levels of a linear system.

use std::sync::atomic::Ordering;

use motes_core::cutoff::CutOff;

use super::super::Failure;
use super::super::run::linear_failure;
use super::{Runs, Subject, within};
use crate::linear::{Control, Experiment, RECONSTRUCTION, STATE};
use crate::report::linear_summary::LinearSummary;
use crate::scenario::linear::LinearScenario;
use crate::scenario::{Side, Width};
use crate::study::{ErrorNorm, Level, Theory, linear_level};

/// What is studied of a system unless told, and the fields that it has: its reconstruction where
/// particles carry their values exactly, else the state.
pub(super) fn subject(scenario: &LinearScenario) -> (Subject, Vec<String>) {
    let mut fields = scenario.system.names(scenario.dimension);
    fields.extend([STATE, RECONSTRUCTION].map(String::from));
    let usual = match scenario.is_carried() {
        true => RECONSTRUCTION,
        false => STATE,
    };
    let shape = scenario.cut_off.shape;
    let subject = Subject {
        name: scenario.name.clone(),
        dimension: scenario.dimension,
        particles: scenario.resolution.particles,
        least: least(scenario),
        has_exact: scenario.output.exact,
        field: usual.to_owned(),
        norm: ErrorNorm::L2,
        theory: Some(Theory {
            order_r: shape.order(),
            smoothness: match scenario.dimension {
                1 => shape.smoothness::<1>(),
                2 => shape.smoothness::<2>(),
                _ => shape.smoothness::<3>(),
            },
            theta: match scenario.cut_off.width {
                Width::Adaptive { theta, .. } => theta,
                Width::Constant { .. } => 0.0,
            },
        }),
    };
    (subject, fields)
}

/// The number of particles, to a factor of 2, from which on every period holds three reaches of
/// the cut-off.
fn least(scenario: &LinearScenario) -> usize {
    let (extent, dimension) = (&scenario.domain.extent, scenario.dimension as f64);
    let periods = scenario.domain.sides.iter().enumerate();
    let periods = periods.filter(|(_, sides)| sides[0] == Side::Periodic);
    let shortest = periods
        .map(|(axis, _)| extent.upper[axis] - extent.lower[axis])
        .fold(f64::INFINITY, f64::min);
    let support = f64::from(scenario.cut_off.shape.support());
    let fits = |&count: &usize| {
        let spacing = libm::pow(extent.volume() / count as f64, 1.0 / dimension);
        // The solver's reach is 1/64 longer than the support, and cells round.
        3.1 * support * scenario.cut_off.width.epsilon(spacing) <= shortest
    };
    (0..30).map(|i| 1 << i).find(fits).unwrap_or(0)
}

/// Runs a level.
pub(super) fn level(
    runs: &mut Runs<'_>,
    scenario: LinearScenario,
    count: usize,
) -> Result<Option<Level>, Failure> {
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
    let how = (runs.scalar, false);
    let experiment = Experiment::run(scenario, how, &mut runs.engine, &mut control)
        .map_err(|error| within(count, linear_failure(error)))?;
    let summary = LinearSummary::new(&experiment, runs.scalar.name(), runs.engine.threads());
    runs.warn(count, summary.warnings, &experiment.doubts);
    Ok(linear_level(&experiment, runs.field))
}
