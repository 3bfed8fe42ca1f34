//! Values so small that a fixed-point format holds but a few digits of them.

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
