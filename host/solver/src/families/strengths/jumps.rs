//! Coefficients given by formulas that change too much from one particle to the next.

use crate::scenario::Extent;
use crate::scenario::formula::Formula;
use crate::scenario::linear::{Conductor, LinearScenario, System};

/// The part of its largest value by which a coefficient may change over one spacing.
const MOST: f64 = 0.25;
/// Lines along each direction that are walked along.
const LINES: usize = 5;
/// The most points of a line.
const LONGEST: f64 = 1e5;

/// What is told of coefficients that jump: a pair of (1.18) takes `B_k u_l + B_l u_k`, which is the
/// equation where `B` is smooth only, and a diffusivity is met at the particles only.
pub(super) fn doubts(scenario: &LinearScenario, spacing: f64) -> Option<String> {
    let (formulas, what, cure): (Vec<&Formula>, _, _) = match &scenario.system {
        System::VariableMatrices { flux, .. } => (
            flux.iter().flatten().collect(),
            "an entry of system.flux",
            "waves at a jump grow without bound: make it smoother, as by tanh, or use more particles",
        ),
        System::ConvectionDiffusion(of) => match &of.profile {
            Conductor::Formula { diffusivity } => (
                diffusivity.iter().collect(),
                "system.diffusivity",
                "what it is between particles is not seen: use profile = { kind = \"layers\", .. }, which \
                 carries layers as resistances, make it smoother, or use more particles",
            ),
            _ => return None,
        },
        _ => return None,
    };
    let found = formulas
        .iter()
        .map(|of| steepest(of, &scenario.domain.extent, spacing));
    let (part, x) = found.max_by(|a, b| a.0.total_cmp(&b.0))?;
    (part > MOST).then(|| {
        format!(
            "{what} changes by {:.0} % of its largest value over one spacing at x = {x:?}: {cure}",
            100.0 * part
        )
    })
}

/// The largest change of a formula over one spacing at t = 0, in its largest value, and where it is.
fn steepest(formula: &Formula, extent: &Extent, spacing: f64) -> (f64, Vec<f64>) {
    let dimension = extent.lower.len();
    let length = |i: usize| extent.upper[i] - extent.lower[i];
    let (mut largest, mut change, mut place) = (0.0f64, 0.0f64, extent.lower.clone());
    for axis in 0..dimension {
        let steps = (length(axis) / spacing).clamp(1.0, LONGEST) as usize;
        for mut line in 0..LINES.pow(dimension as u32 - 1) {
            let mut point = [0.0; 4];
            for i in (0..dimension).filter(|&i| i != axis) {
                let part = ((line % LINES) as f64 + 0.5) / LINES as f64;
                point[i] = extent.lower[i] + part * length(i);
                line /= LINES;
            }
            let mut before = None;
            for step in 0..=steps {
                point[axis] = extent.lower[axis] + length(axis) * step as f64 / steps as f64;
                let value = formula.at(&point);
                largest = largest.max(value.abs());
                let found = before.map_or(0.0, |before: f64| (value - before).abs());
                if found > change {
                    change = found;
                    place = point[..dimension].to_vec();
                }
                before = Some(value);
            }
        }
    }
    match largest > 0.0 {
        true => (change / largest, place),
        false => (0.0, place),
    }
}
