//! An experiment as a level.

use super::Level;
use crate::experiment::Experiment;

/// The level of an experiment in one of its fields; `None` where there are no errors.
pub fn level(experiment: &Experiment, field: &str) -> Option<Level> {
    let norms = experiment.errors.as_ref()?.get(field)?;
    let description = experiment.simulation.description();
    Some(Level {
        n: description.particles,
        h: description.spacing,
        eps: experiment.simulation.width(),
        l1: norms.l1,
        l2: norms.l2,
        linf: norms.linf,
    })
}
