//! `motes export`.

use super::Failure;
use super::arguments::{ExportArguments, any_scenario};
use crate::export;

/// Prints the scenario as Rust source.
pub(super) fn export(arguments: &ExportArguments) -> Result<(), Failure> {
    let scenario = any_scenario(
        &arguments.scenario,
        arguments.particles.as_deref(),
        &arguments.overrides,
    )?;
    let mut command = format!("motes export {}", arguments.scenario);
    if let Some(particles) = &arguments.particles {
        command += &format!(" -n {particles}");
    }
    for change in &arguments.overrides {
        command += &format!(" --set '{change}'");
    }
    let text = export::source(&scenario, &command).map_err(Failure::input)?;
    super::print(&text)
}
