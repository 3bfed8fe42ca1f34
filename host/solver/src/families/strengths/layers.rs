//! Layers that a form of diffusion cannot carry as resistances.

use crate::families::PlanError;
use crate::scenario::linear::{Conductor, ConvectionDiffusion, Form, LinearScenario, Mean, System};

/// The part of the resistance along x from which on it is told that it is lost, and from which on
/// the run is refused.
const TOLD: f64 = 0.005;
const REFUSED: f64 = 0.02;

/// Refuses layers of which too much is jumped over; a warning where it is some.
///
/// # Errors
/// [`PlanError::Layers`].
pub(super) fn check(scenario: &LinearScenario, epsilon: f64) -> Result<Option<String>, PlanError> {
    let System::ConvectionDiffusion(problem) = &scenario.system else {
        return Ok(None);
    };
    let lost = lost(problem, scenario, epsilon);
    let (what, cure) = match problem.form {
        Form::Mixed => ("the mixed form", "set system.form = \"direct\""),
        Form::Direct => (
            "the arithmetic mean",
            "take system.mean out, or set it to \"harmonic\"",
        ),
    };
    if lost > REFUSED {
        return Err(PlanError::Layers {
            what,
            percent: 100.0 * lost,
            epsilon,
            cure,
        });
    }
    Ok((lost > TOLD).then(|| {
        format!(
            "{what} smooths layers over the width of its cut-off and loses some {:.1} % of what they \
             resist: {cure}, which loses nothing",
            100.0 * lost
        )
    }))
}

/// The part of the resistance along x, walls left out, that is lost where layers meet.
///
/// At a joint `c ε ln(b_high/b_low)` of the layer that conducts less counts as the other one: measured for
/// the steady flux through slabs with ratios of 10 and 1000, M6 with ε = 1.5 h. A layer that is no
/// thicker is lost.
fn lost(problem: &ConvectionDiffusion, scenario: &LinearScenario, epsilon: f64) -> f64 {
    let c = match (problem.form, problem.mean) {
        (Form::Direct, Mean::Harmonic) => return 0.0,
        (Form::Direct, Mean::Arithmetic) => 0.25,
        (Form::Mixed, _) => 0.17,
    };
    let Conductor::Layers { bounds, factors } = &problem.profile else {
        return 0.0;
    };
    let (lower, upper) = (
        scenario.domain.extent.lower[0],
        scenario.domain.extent.upper[0],
    );
    let (mut whole, mut lost) = (0.0, 0.0);
    for (i, &factor) in factors.iter().enumerate() {
        let end = |bound: Option<&f64>, side: f64| bound.map_or(side, |x| x.clamp(lower, upper));
        let start = end(i.checked_sub(1).and_then(|i| bounds.get(i)), lower);
        let thickness = end(bounds.get(i), upper) - start;
        // A joint at a side, or beyond, is none.
        let eaten = |bound: Option<&f64>, other: Option<&f64>| match (bound, other) {
            (Some(&x), Some(&other)) if lower < x && x < upper && other > factor => {
                c * epsilon * (other / factor).ln()
            }
            _ => 0.0,
        };
        let before = i.checked_sub(1);
        let eaten = eaten(
            before.and_then(|i| bounds.get(i)),
            before.and_then(|i| factors.get(i)),
        ) + eaten(bounds.get(i), factors.get(i + 1));
        whole += thickness / factor;
        lost += eaten.min(thickness) / factor;
    }
    if whole > 0.0 { lost / whole } else { 0.0 }
}
