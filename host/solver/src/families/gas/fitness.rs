//! Whether a width and the solver units of a gas make sense at all.

use motes_core::cutoff::CutOff;

use crate::families::PlanError;
use crate::scenario::{self, Scenario};
use crate::setup::Placed;
use crate::sums::compensated;
use crate::units::SolverUnits;

/// Reaches in spacings between which a density sum makes sense: one neighbour on either side
/// with room to move, and no more than a solver wants to look at.
const REACH: [f64; 2] = [1.5, 40.0];

/// Refuses a width with which particles would see nobody, or everybody; of one that is the same for
/// all, most of them.
pub(super) fn check_reach(
    scenario: &Scenario,
    placed: &[Placed],
    fineness: f64,
) -> Result<(), PlanError> {
    let (given, width) = match scenario.cut_off.width {
        scenario::Width::Constant { epsilon } => {
            let volume = compensated(placed.iter().map(|p| p.mass / p.density));
            let volume = volume / placed.len().max(1) as f64;
            let spacings = epsilon / libm::pow(volume, 1.0 / scenario.dimension as f64);
            (format!("epsilon = {spacings} spacings"), spacings)
        }
        width @ scenario::Width::Adaptive { .. } => {
            let eta = width.spacings(fineness);
            (format!("eta = {eta}"), eta)
        }
    };
    let cut_off = scenario.cut_off.shape;
    let support = f64::from(cut_off.support());
    let ([least, most], reach) = (REACH, width * support);
    if (least..=most).contains(&reach) {
        return Ok(());
    }
    Err(PlanError::Reach {
        given,
        cut_off: cut_off.name(),
        support,
        reach,
        least,
        most,
    })
}

/// Refuses units that `f64` cannot hold with room around them.
pub(super) fn check_units(units: &SolverUnits) -> Result<(), PlanError> {
    let sizes = [
        ("length", units.length),
        ("mass", units.mass),
        ("velocity", units.velocity),
        ("time", units.time()),
        ("energy", units.energy()),
    ];
    match sizes
        .into_iter()
        .find(|(_, value)| !(1e-200..1e200).contains(value))
    {
        Some((unit, value)) => Err(PlanError::Extreme { unit, value }),
        None => Ok(()),
    }
}
