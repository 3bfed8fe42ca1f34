//! What particles lie in the regions of a start.

use crate::scenario::{Region, Scenario};
use crate::setup::Placed;

/// Spacings across a region below which its waves are not resolved.
pub(super) const LEAST: f64 = 10.0;

/// The mass of a particle of a region.
pub(super) fn mass(scenario: &Scenario, placed: &[Placed], region: &Region) -> Option<f64> {
    let inside = |particle: &&Placed| holds(region, &particle.position[..scenario.dimension]);
    // What lies in several is that of the last of them, as its density tells.
    let mine = |particle: &&Placed| inside(particle) && particle.density == region.density;
    placed.iter().find(mine).map(|particle| particle.mass)
}

fn holds(region: &Region, point: &[f64]) -> bool {
    match &region.ball {
        Some(ball) => ball.distance_squared(point) < ball.radius * ball.radius,
        None => {
            let bounds = region.extent.lower.iter().zip(&region.extent.upper);
            (point.iter().zip(bounds)).all(|(x, (lower, upper))| (lower..=upper).contains(&x))
        }
    }
}
