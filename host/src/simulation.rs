//! Gas dynamics: plans, and runs with any scalar of this build.

pub use motes_solver::simulation::*;

use crate::engine::Threads;
pub use crate::scalars::{ScalarName, UnknownScalar};

/// Runs `plan` to its end; `checked` marks overflow in fixed point and stops at the first.
///
/// # Errors
/// What [`RunError`] lists.
pub fn run(
    plan: &Plan,
    scalar: ScalarName,
    checked: bool,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    (scalar.runs(checked).gas)(plan, scalar.name(), engine, control)
}
