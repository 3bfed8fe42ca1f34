//! How large what formulas say becomes, over the domain and the run.

use super::frame::{all_over, times};
use crate::families::PlanError;
use crate::scenario::formula::Formula;
use crate::scenario::linear::{Field, LinearScenario, System};

/// The largest magnitudes of fields and sources that are formulas, in the scenario's units; 0 of others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sizes {
    /// Of a component of a velocity.
    pub velocity: f64,
    /// Of a source.
    pub source: f64,
}

impl Sizes {
    /// Those of a scenario.
    ///
    /// # Errors
    /// A place and a time at which one is no number.
    pub fn of(scenario: &LinearScenario) -> Result<Self, PlanError> {
        let flow = match &scenario.system {
            System::Transport { velocity, .. } => velocity,
            System::ConvectionDiffusion(of) => &of.velocity,
            _ => &Field::Still,
        };
        let mut sizes = Self::default();
        for field in [&scenario.motion, flow] {
            if let Field::Formula(field) = field {
                for formula in field.velocity.iter().chain(&field.slopes) {
                    largest(scenario, formula, "a velocity or its slope")?;
                }
                for formula in &field.velocity {
                    let found = largest(scenario, formula, "a velocity")?;
                    sizes.velocity = sizes.velocity.max(found);
                }
            }
        }
        for formula in scenario.source.iter().flatten() {
            let found = largest(scenario, formula, "system.source")?;
            sizes.source = sizes.source.max(found);
        }
        Ok(sizes)
    }
}

/// The largest magnitude of a formula.
fn largest(
    scenario: &LinearScenario,
    formula: &Formula,
    what: &'static str,
) -> Result<f64, PlanError> {
    let (mut largest, mut fault) = (0.0f64, None);
    for time in times(scenario.time.end) {
        all_over(&scenario.domain.extent, time, |point| {
            let value = formula.at(point);
            largest = largest.max(value.abs());
            if !value.is_finite() && fault.is_none() {
                fault = Some(PlanError::NotFinite {
                    what,
                    value,
                    position: point[..scenario.dimension].to_vec(),
                    time,
                });
            }
        });
    }
    match fault {
        Some(fault) => Err(fault),
        None => Ok(largest),
    }
}
