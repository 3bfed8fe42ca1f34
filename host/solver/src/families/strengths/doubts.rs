//! Why the results of a run may not mean what they say.

use motes_core::cutoff::{CutOff as _, Named};

use crate::scenario::Side;
use crate::scenario::linear::{Arrangement, Initial, LinearScenario};

/// What a careful reader of the results should know of a scenario.
pub(super) fn doubts(
    scenario: &LinearScenario,
    spacing: f64,
    (epsilon, lengths): (f64, &[f64]),
    shares: &[f64],
) -> Vec<String> {
    let largest = shares.iter().copied().fold(0.0, f64::max);
    volume(scenario, shares)
        .into_iter()
        .chain(resolution(scenario, spacing))
        .chain(series(scenario))
        .chain(width(scenario, epsilon, lengths, largest))
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
fn volume(scenario: &LinearScenario, shares: &[f64]) -> Option<String> {
    let Arrangement::File(_) = scenario.resolution.arrangement else {
        return None;
    };
    let whole = scenario.domain.extent.volume();
    let sum = shares.iter().sum::<f64>() / shares.len() as f64 * whole;
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

/// A series of which a run meets next to nothing: most often its times are in another unit.
fn series(scenario: &LinearScenario) -> Vec<String> {
    let end = scenario.time.end;
    let driven = scenario.system.driven();
    let mut doubts: Vec<String> = driven
        .into_iter()
        .filter_map(|(_, series)| {
            let (&first, &last) = (series.times.first()?, series.times.last()?);
            let met = series.times.iter().filter(|time| (0.0..=end).contains(*time));
            let met = met.count();
            (last > 20.0 * end && met < 4).then(|| {
                format!(
                    "the run from 0 to {end} meets {met} of the {} rows of `{}`, whose times go from \
                     {first} to {last}: are they in another unit of time?",
                    series.times.len(),
                    series.file
                )
            })
        })
        .collect();
    doubts.dedup();
    doubts
}

/// The part of the shortest side of the domain from which on a cut-off is as wide as the problem.
const WIDE: f64 = 0.5;

/// The least reach in spacings with which sums over neighbours are integrals: below, the error of a
/// lattice at rest grows tenfold from tenth to tenth of a spacing (a wall, M6: 5e-4 at 2.7, 9e-3 at
/// 2.4), and on a cloud drawn apart the quadrature governs. Cut-offs of higher order have narrower
/// cores.
fn least_reach(shape: Named) -> f64 {
    match shape.order() {
        2 => 2.7,
        4 => 2.85,
        _ => 3.3,
    }
}

/// A cut-off that sees too few particles where they are the fewest, or smears the whole domain.
///
/// `lengths`: of the domain, in spacings; `largest`: weight, in the mean volume of a particle.
fn width(scenario: &LinearScenario, epsilon: f64, lengths: &[f64], largest: f64) -> Option<String> {
    let shape = scenario.cut_off.shape;
    let support = f64::from(shape.support());
    let shortest = lengths.iter().copied().filter(|&length| length > 1.0);
    let most = WIDE * shortest.fold(f64::INFINITY, f64::min);
    if support * epsilon > most {
        return Some(format!(
            "the cut-off `{}` reaches {:.1} spacings, more than half of the shortest side of the domain: \
             it smears what happens there; use a smaller cut-off.eta or epsilon, or more particles",
            shape.name(),
            support * epsilon
        ));
    }
    thin(shape, epsilon, (largest, scenario.dimension), "the start")
}

/// A cloud so thin somewhere that the cut-off sees too few particles there.
///
/// `largest`: weight, in the mean volume of a particle, and the dimension.
pub(super) fn thin(
    shape: Named,
    epsilon: f64,
    (largest, dimension): (f64, usize),
    when: &str,
) -> Option<String> {
    let spacing = libm::pow(largest, 1.0 / dimension as f64);
    let reach = f64::from(shape.support()) * epsilon / spacing;
    let least = least_reach(shape);
    (reach < least).then(|| {
        format!(
            "the cut-off `{}` reaches {reach:.2} spacings at {when} where particles are the fewest: below \
             {least:.1} its sums are no integrals; use a larger cut-off.eta or epsilon, {:.2} times as large \
             at least",
            shape.name(),
            least / reach
        )
    })
}

/// A state at t = 0 that the particles cannot show.
fn resolution(scenario: &LinearScenario, spacing: f64) -> Option<String> {
    let extent = &scenario.domain.extent;
    let (what, length, least) = match scenario.initial.as_ref()? {
        Initial::Gaussian { width, .. } => ("width of the Gaussian", *width, 2.0),
        // What a formula varies over is not known.
        Initial::ExpSine
        | Initial::Uniform { .. }
        | Initial::Legendre { .. }
        | Initial::Formula { .. }
        | Initial::Manufactured { .. } => return None,
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
