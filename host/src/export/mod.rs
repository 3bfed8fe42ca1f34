//! A scenario as Rust source for a device: numbers in solver units, written with the digits that
//! read back to the same bits, and formulas as expressions.
//!
//! | files | hold |
//! |---|---|
//! | `module` | a module of Rust source, put together of its parts |
//! | `expressions` | formulas |
//! | `motion`, `viscosity`, `system`, `coefficients`, `problem`, `laws` | parts of an equation |
//! | `run`, `strengths` | what every run has, and every cloud of strengths |
//! | `first_order`, `diffusion`, `gas` | a whole run of each family |
//! | `line`, `slab`, `tube` | what the core sets up from numbers alone |

mod coefficients;
mod diffusion;
mod expressions;
mod first_order;
mod gas;
mod laws;
mod line;
mod module;
mod motion;
mod problem;
mod run;
mod slab;
mod strengths;
mod system;
mod tube;
mod viscosity;

use crate::families::gas::{self as gases, ExactError, ExactSolution};
use crate::families::{Plan, PlanError};
use crate::scenario::AnyScenario;
use crate::scenario::linear::System;
pub use gas::NoGas;
use module::Module;

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
    Gas(#[from] NoGas),
}

/// The source of a module for a scenario: a `TUBE` of gas, a `LINE` of a first-order system or a
/// `SLAB` of convection-diffusion, where it is one, else the whole run: its memory and how it is started.
///
/// `command`: what made it, for its first line.
///
/// # Errors
/// What cannot be planned, and a gas that a device cannot be given: see [`NoGas`].
pub fn source(scenario: &AnyScenario, command: &str) -> Result<String, NoSource> {
    let mut module = Module::new(command);
    if scenario.exact_times() {
        module.say("");
        module.say("`motes run` ends steps at the times of its output, as output.exact-times asks for: the");
        module.say("digest is that without it.");
    }
    let name = scenario.name();
    let of_gas = match scenario {
        AnyScenario::Gas(scenario) => scenario,
        AnyScenario::Linear(_) => return strengths_source(scenario, module),
    };
    let plan = gases::Plan::new(of_gas)?;
    let exact = ExactSolution::of(of_gas)?;
    match tube::tube(module.clone(), of_gas, &plan, exact.as_ref()) {
        Some(tube) => Ok(tube),
        None => Ok(gas::gas(module, name, &plan)?),
    }
}

/// The same of a first-order system and of convection-diffusion.
fn strengths_source(scenario: &AnyScenario, module: Module) -> Result<String, NoSource> {
    let Plan::Strengths(plan) = Plan::new(scenario)? else {
        unreachable!("a scenario of [system] is planned as strengths");
    };
    let name = scenario.name();
    Ok(match &plan.system {
        System::ConvectionDiffusion(of) => slab::slab(module.clone(), name, (&plan, of))
            .unwrap_or_else(|| diffusion::diffusion(module, name, (&plan, of))),
        _ => match line::line(module.clone(), name, &plan) {
            Some(line) => line,
            None => first_order::first_order(module, name, &plan)
                .unwrap_or_else(|| unreachable!("convection-diffusion is written above")),
        },
    })
}
