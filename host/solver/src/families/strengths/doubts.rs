//! Why the results of a run may not mean what they say.

use crate::scenario::Side;
use crate::scenario::linear::{Arrangement, Initial, LinearScenario};

/// What a careful reader of the results should know of a scenario.
pub(super) fn doubts(scenario: &LinearScenario, spacing: f64, weights: &[f64]) -> Vec<String> {
    volume(scenario, spacing, weights)
        .into_iter()
        .chain(resolution(scenario, spacing))
        .collect()
}

/// The part of a state in waves of two spacings from which on the mixed form is told to be blind.
const UNDAMPED: f64 = 0.02;

/// A state with waves that the mixed form of diffusion does not see.
pub(super) fn undamped(part: f64) -> Option<String> {
    (part > UNDAMPED).then(|| {
        format!(
            "waves of two or three spacings make {:.1} % of the state at the end: the mixed form does \
             not damp them; set system.form = \"direct\", or resolve the state at t = 0",
            100.0 * part
        )
    })
}

/// Weights of a file that are no volumes.
fn volume(scenario: &LinearScenario, spacing: f64, weights: &[f64]) -> Option<String> {
    let Arrangement::File(_) = scenario.resolution.arrangement else {
        return None;
    };
    let whole = scenario.domain.extent.volume();
    // As the solver counts them.
    let cell = spacing.powi(scenario.dimension as i32);
    let sum = weights.iter().map(|w| w / cell).sum::<f64>() * cell;
    let sides = scenario.domain.sides.iter().flatten();
    let is_open = sides.filter(|&&side| side == Side::Free).count() > 0;
    let (low, high) = (0.95 * whole, 1.05 * whole);
    let fits = sum <= high && (is_open || sum >= low);
    (!fits).then(|| {
        format!(
            "the weights add up to {sum:e}, the domain to {whole:e}: weights are volumes, and \
             waves run at wrong speeds where they are not"
        )
    })
}

/// A state at t = 0 that the particles cannot show.
fn resolution(scenario: &LinearScenario, spacing: f64) -> Option<String> {
    let extent = &scenario.domain.extent;
    let (what, length, least) = match scenario.initial.as_ref()? {
        Initial::Gaussian { width, .. } => ("width of the Gaussian", *width, 2.0),
        Initial::ExpSine | Initial::Uniform { .. } | Initial::Legendre { .. } => return None,
        Initial::Band { width, .. } => ("width of an edge", *width, 2.0),
        Initial::Spots { width, .. } => ("width of a spot", *width, 2.0),
        Initial::PlaneWave { wave, .. }
        | Initial::StandingWave { wave, .. }
        | Initial::Modes { wave, .. } => {
            let sides = extent.lower.iter().zip(&extent.upper).zip(wave);
            let lengths = sides.map(|((lower, upper), &number)| {
                (upper - lower) / f64::from(number.unsigned_abs().max(1))
            });
            ("wavelength", lengths.fold(f64::INFINITY, f64::min), 4.0)
        }
    };
    (length < least * spacing).then(|| {
        format!(
            "the {what} is {:.2} spacings: the particles do not resolve the initial state",
            length / spacing
        )
    })
}
