//! Runs of any scenario with any scalar of this build.

pub use motes_solver::run::*;

use crate::engine::Threads;
use crate::families::{Plan, PlanError};
pub use crate::scalars::{ScalarName, UnknownScalar};
use crate::scenario::AnyScenario;

/// Why a scenario is no simulation.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum StartError {
    /// It cannot be planned.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Plan(#[from] PlanError),
    /// It cannot be begun.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Run(#[from] RunError),
}

/// A scenario at its start, in a scalar.
///
/// # Errors
/// What [`StartError`] lists.
pub fn start(
    scenario: &AnyScenario,
    scalar: ScalarName,
    engine: &mut Threads,
) -> Result<Box<dyn Simulation>, StartError> {
    Ok(start_plan(Plan::new(scenario)?, (scalar, false), engine)?)
}

/// A plan at its start; `checked` marks overflow in fixed point and stops at the first.
///
/// # Errors
/// What [`RunError`] lists.
pub fn start_plan(
    plan: Plan,
    (scalar, checked): (ScalarName, bool),
    engine: &mut Threads,
) -> Result<Box<dyn Simulation>, RunError> {
    (scalar.compiled(checked).start)(plan, scalar.name(), engine)
}
