//! Values and ways so small that a fixed-point format holds but a few digits of them.

use super::plan::Plan;
use crate::run::Series;

/// Units of the last place that the largest value of a component takes at least, for an error of about
/// a part in a thousand after a step.
const LEAST: f64 = 1000.0;

/// The part of the energy from which on a component matters; others may be 0 but for rounding.
const MATTERS: f64 = 1e-3;

/// Components that matter and of which the format holds but a few digits.
///
/// `tiniest`: a unit of the last place. `weights`: of the energy, `P x P`; none where components do not
/// share one, and each matters.
pub(super) fn few_digits(
    plan: &Plan,
    tiniest: f64,
    weights: &[f64],
    series: &Series,
) -> Option<String> {
    let components = plan.names.len();
    let largest = |name: &String| {
        let ends = ["min", "max"].map(|part| series.of(&format!("{name}_{part}")));
        let sizes = ends.iter().flatten().map(|value| value.abs());
        sizes.fold(0.0, f64::max)
    };
    let largest: Vec<f64> = plan.names.iter().map(largest).collect();
    let energy = |i: usize| match weights.get(i * components + i) {
        Some(weight) => weight * largest[i] * largest[i],
        None => f64::from(u8::from(largest[i] > 0.0)),
    };
    let most = (0..components).map(energy).fold(0.0, f64::max);
    let (i, units) = (0..components)
        .filter(|&i| energy(i) > MATTERS * most)
        .map(|i| (i, largest[i] / tiniest))
        .min_by(|a, b| a.1.total_cmp(&b.1))?;
    (units < LEAST).then(|| {
        format!(
            "{} is at most {:.3e}, {units:.0} units of the last place of this format: errors of {:.1} % and \
             more; give it in a unit in which it is of order 1, or use a format with more fractional bits",
            plan.names[i],
            largest[i],
            50.0 / units
        )
    })
}

/// Units of the last place that a step of the fastest particle takes at least, for an error of a per cent
/// of where it goes: each step is rounded to one.
const LEAST_STEP: f64 = 50.0;

/// Particles that a field carries by so few units of the last place a step, `tiniest`, that rounding tells where they
/// go; by less than half of one they stand still.
pub(super) fn short_steps(plan: &Plan, tiniest: f64, steps: u64) -> Option<String> {
    let units = plan.fastest * plan.end / steps as f64 / tiniest;
    (units > 0.0 && units < LEAST_STEP).then(|| {
        format!(
            "particles are carried by at most {units:.2} units of the last place of this format a step, and by less \
             than half of one not at all: they go up to {:.0} % astray; use a format with more fractional bits, or \
             longer steps",
            (50.0 / units).min(100.0)
        )
    })
}
