//! `motes export`.

use super::Failure;
use super::arguments::{ExportArguments, any_scenario};
use crate::comparison::ExactSolution;
use crate::scenario::{AnyScenario, Scenario};
use crate::{export, linear, simulation};

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
    let text = match &scenario {
        AnyScenario::Gas(scenario) => gas(scenario, &command),
        AnyScenario::Linear(scenario) => linear::Plan::new(scenario)
            .map_err(miette::Report::from)
            .and_then(|plan| Ok(export::linear(&scenario.name, &plan, &command)?)),
    };
    super::print(&text.map_err(Failure::Input)?)
}

fn gas(scenario: &Scenario, command: &str) -> miette::Result<String> {
    let plan = simulation::Plan::new(scenario)?;
    let exact = ExactSolution::of(scenario)?;
    Ok(export::tube(scenario, &plan, exact.as_ref(), command)?)
}
