//! `motes export`.

use super::Failure;
use super::arguments::{ExportArguments, scenario};
use crate::comparison::ExactSolution;
use crate::simulation::Plan;

/// Prints the scenario as Rust source.
pub(super) fn export(arguments: &ExportArguments) -> Result<(), Failure> {
    let scenario = scenario(
        &arguments.scenario,
        arguments.particles.as_deref(),
        &arguments.overrides,
    )?;
    let plan = Plan::new(&scenario).map_err(|error| Failure::Input(error.into()))?;
    let exact = ExactSolution::of(&scenario).map_err(|error| Failure::Input(error.into()))?;
    let mut command = format!("motes export {}", arguments.scenario);
    if let Some(particles) = &arguments.particles {
        command += &format!(" -n {particles}");
    }
    for change in &arguments.overrides {
        command += &format!(" --set '{change}'");
    }
    let tube = crate::export::tube(&scenario, &plan, exact.as_ref(), &command);
    super::print(&tube.map_err(|error| Failure::Input(error.into()))?)
}
