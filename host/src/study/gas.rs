//! A run of gas dynamics as a level.

use super::Level;
use crate::experiment::Experiment;
use crate::simulation::{Plan, Spread};

/// The level of an experiment, in one of [`FIELDS`](crate::comparison::FIELDS); `None` where there
/// are no errors.
pub fn gas_level(experiment: &Experiment, plan: &Plan, field: &str) -> Option<Level> {
    let norms = experiment.errors.as_ref()?.get(field)?;
    let widths = experiment.outcome.particles.iter().map(|p| p.epsilon);
    Some(Level {
        n: plan.particles.len(),
        h: plan.units.length,
        eps: Spread::of(widths).mean,
        l1: norms.l1,
        l2: norms.l2,
        linf: norms.linf,
    })
}
