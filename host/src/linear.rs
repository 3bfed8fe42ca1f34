//! Linear systems and convection-diffusion: plans, and runs with any scalar of this build.

mod experiment;

pub use motes_solver::linear::*;

use crate::engine::Threads;
use crate::scalars::ScalarName;
pub use experiment::Experiment;

/// Runs `plan` to its end; `checked` marks overflow in fixed point and stops at the first.
///
/// # Errors
/// What [`LinearError`] lists.
pub fn run(
    plan: &Plan,
    scalar: ScalarName,
    checked: bool,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, LinearError> {
    (scalar.runs(checked).linear)(plan, scalar.name(), engine, control)
}
