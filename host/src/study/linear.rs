//! A run of a linear system as a level.

use super::Level;
use crate::linear::Experiment;

/// The level of an experiment, in a component, the state or the reconstruction; `None` where there
/// are no errors.
pub fn linear_level(experiment: &Experiment, field: &str) -> Option<Level> {
    let norms = experiment.errors.as_ref()?.get(field)?;
    let spacing = experiment.plan.units.length;
    Some(Level {
        n: experiment.outcome.cloud.len(),
        h: spacing,
        eps: experiment.plan.epsilon * spacing,
        l1: norms.l1,
        l2: norms.l2,
        linf: norms.linf,
    })
}
