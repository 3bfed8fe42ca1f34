//! A scenario as Rust source for a device: numbers in solver units, written with the digits that
//! read back to the same bits.

mod line;
mod slab;
mod tube;

pub use line::NoLine;
pub use slab::NoSlab;
pub use tube::NoTube;

use crate::families::gas::{self, ExactError, ExactSolution};
use crate::families::{Plan, PlanError};
use crate::scenario::AnyScenario;
use crate::scenario::linear::System;

/// A scenario that is not written.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error(transparent)]
#[diagnostic(transparent)]
pub enum NoSource {
    /// It cannot be planned.
    Plan(#[from] PlanError),
    /// Its exact solution, which is written too, does not exist.
    Exact(#[from] ExactError),
    /// A gas.
    Tube(#[from] NoTube),
    /// A first-order system.
    Line(#[from] NoLine),
    /// Convection-diffusion.
    Slab(#[from] NoSlab),
}

/// The source of a module for a scenario: a `TUBE` of gas, a `LINE` of a first-order system or a
/// `SLAB` of convection-diffusion, and the capacities it needs.
///
/// `command`: what made it, for its first line.
///
/// # Errors
/// What is not of one dimension, and more: the help of the error lists what is written.
pub fn source(scenario: &AnyScenario, command: &str) -> Result<String, NoSource> {
    let scenario = match scenario {
        AnyScenario::Gas(scenario) => {
            let plan = gas::Plan::new(scenario)?;
            let exact = ExactSolution::of(scenario)?;
            return Ok(tube::tube(scenario, &plan, exact.as_ref(), command)?);
        }
        AnyScenario::Linear(_) => scenario,
    };
    let Plan::Strengths(plan) = Plan::new(scenario)? else {
        unreachable!("a scenario of [system] is planned as strengths");
    };
    Ok(match &plan.system {
        System::ConvectionDiffusion(of) => slab::slab(scenario.name(), (&plan, of), command)?,
        _ => line::line(scenario.name(), &plan, command)?,
    })
}

/// The command that made a file, fit for a line of comment.
fn one_line(command: &str) -> String {
    command.split_whitespace().collect::<Vec<_>>().join(" ")
}
