//! From a plan to the code that runs it: dimension and law.

use super::limits::RunError;
use super::outcome::Outcome;
use super::plan::Plan;
use super::run::{Control, run_with};
use crate::engine::{HostScalar, Threads};

/// Runs a plan in its dimension.
///
/// # Errors
/// What [`RunError`] lists.
pub fn in_dimensions<S: HostScalar>(
    plan: &Plan,
    name: &str,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    match plan.dimension {
        1 => with::<S, 1>(plan, name, engine, control),
        2 => with::<S, 2>(plan, name, engine, control),
        _ => with::<S, 3>(plan, name, engine, control),
    }
}

fn with<S: HostScalar, const D: usize>(
    plan: &Plan,
    name: &str,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    let cut_off = plan.cut_off;
    let (viscosity, options) = (plan.viscosity::<S>(), plan.options::<S, D>());
    if options.need_exchange() {
        run_with(plan, name, (cut_off, viscosity, options), engine, control)
    } else {
        let law = (cut_off, viscosity, options.plain);
        run_with(plan, name, law, engine, control)
    }
}
