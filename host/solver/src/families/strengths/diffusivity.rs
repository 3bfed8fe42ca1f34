//! Diffusivities that formulas give: what a plan needs to know of them.

use super::frame::{all_over, times};
use crate::families::PlanError;
use crate::scenario::Extent;
use crate::scenario::formula::Formula;
use crate::scenario::linear::{Conductor, ConvectionDiffusion};

/// The formulas of a problem; none where numbers give its diffusivities.
fn formulas(of: &ConvectionDiffusion) -> &[Formula] {
    match &of.profile {
        Conductor::Formula { diffusivity } => diffusivity,
        _ => &[],
    }
}

/// Refuses diffusivities that are negative or no numbers somewhere in the domain, up to the end.
pub(super) fn check(
    of: &ConvectionDiffusion,
    extent: &Extent,
    duration: f64,
) -> Result<(), PlanError> {
    let mut found = None;
    for (formula, species) in formulas(of).iter().zip(&of.species) {
        for time in times(duration) {
            all_over(extent, time, |point| {
                let value = formula.at(point);
                let holds = value.is_finite() && value >= 0.0;
                if !holds && found.is_none() {
                    found = Some(PlanError::Diffusivity {
                        species: species.clone(),
                        value,
                        position: point[..extent.lower.len()].to_vec(),
                        time,
                    });
                }
            });
        }
    }
    match found {
        Some(error) => Err(error),
        None => Ok(()),
    }
}

/// The largest diffusivity of a problem at the start.
pub(super) fn largest(of: &ConvectionDiffusion, extent: &Extent) -> f64 {
    let mut largest = of.diffusivity.iter().copied().fold(0.0, f64::max);
    for formula in formulas(of) {
        all_over(extent, 0.0, |point| {
            largest = largest.max(formula.at(point))
        });
    }
    largest * of.profile.largest()
}
