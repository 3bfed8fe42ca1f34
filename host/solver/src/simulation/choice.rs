//! From a plan to the code that runs it: dimension, cut-off and law.

use motes_core::cutoff::{
    CubicSpline, CutOff, Named as NamedCutOff, QuinticSpline, WendlandC2, WendlandC6,
};

use super::limits::RunError;
use super::outcome::Outcome;
use super::plan::Plan;
use super::run::{Control, run_with};
use crate::engine::{HostScalar, Threads};

/// The cut-offs that scenarios of each dimension use most are compiled into the loops, others
/// are looked up for each pair: the same bits at less than half the speed.
///
/// # Errors
/// What [`RunError`] lists.
pub fn in_floats<S: HostScalar>(
    plan: &Plan,
    name: &str,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    match (plan.dimension, plan.cut_off) {
        (1, NamedCutOff::CubicSpline) => with::<S, _, 1>(CubicSpline, plan, name, engine, control),
        (1, NamedCutOff::QuinticSpline) => {
            with::<S, _, 1>(QuinticSpline, plan, name, engine, control)
        }
        (2, NamedCutOff::WendlandC2) => with::<S, _, 2>(WendlandC2, plan, name, engine, control),
        (2, NamedCutOff::WendlandC6) => with::<S, _, 2>(WendlandC6, plan, name, engine, control),
        (3, NamedCutOff::WendlandC2) => with::<S, _, 3>(WendlandC2, plan, name, engine, control),
        (3, NamedCutOff::QuinticSpline) => {
            with::<S, _, 3>(QuinticSpline, plan, name, engine, control)
        }
        _ => in_dimensions::<S>(plan, name, engine, control),
    }
}

/// Every cut-off is looked up for each pair.
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
        1 => with::<S, _, 1>(plan.cut_off, plan, name, engine, control),
        2 => with::<S, _, 2>(plan.cut_off, plan, name, engine, control),
        _ => with::<S, _, 3>(plan.cut_off, plan, name, engine, control),
    }
}

fn with<S: HostScalar, C: CutOff, const D: usize>(
    cut_off: C,
    plan: &Plan,
    name: &str,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    let (viscosity, options) = (plan.viscosity::<S>(), plan.options::<S, D>());
    if options.need_exchange() {
        run_with(plan, name, (cut_off, viscosity, options), engine, control)
    } else {
        let law = (cut_off, viscosity, options.plain);
        run_with(plan, name, law, engine, control)
    }
}
