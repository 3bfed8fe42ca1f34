//! One dimension: stretches of equally spaced particles, their number exact.

use super::arrange::Arranger;
use super::block::{Block, room};
use super::regions::filled;
use super::{Placed, SetupError, apportion};
use crate::scenario::{Extent, Region, Scenario, Share};

/// The middles of equal cells of about this length.
pub(super) fn points(block: &Block, length: f64, asked: f64) -> Result<Vec<[f64; 3]>, SetupError> {
    let n = block.fitted(0, length);
    let mut points = room([n, 1, 1], asked)?;
    let spacing = block.length(0) / n as f64;
    let at = |k: usize| [block.lower[0] + spacing * (k as f64 + 0.5), 0.0, 0.0];
    points.extend((0..n).map(at));
    Ok(points)
}

/// The particles of the regions of a scenario.
pub(super) fn place(scenario: &Scenario) -> Result<Vec<Placed>, SetupError> {
    let stretches = stretches(scenario);
    let length = |ends: &[f64; 2]| ends[1] - ends[0];
    let parts: Vec<f64> = stretches
        .iter()
        .map(|(ends, region)| match scenario.resolution.share {
            Share::Mass => scenario.regions[*region].density * length(ends),
            Share::Volume => length(ends),
        })
        .collect();
    // Of a stretch without particles the user knows the region.
    let counts = apportion(&parts, scenario.resolution.particles).map_err(|error| match error {
        SetupError::EmptyRegion { region, share } => SetupError::EmptyRegion {
            region: stretches.get(region).map_or(region, |(_, region)| *region),
            share,
        },
        error => error,
    })?;
    let mut arranger = Arranger::new(scenario);
    let mut particles = Vec::with_capacity(scenario.resolution.particles);
    for ((ends, region), count) in stretches.iter().zip(counts) {
        let extent = Extent {
            lower: vec![ends[0]],
            upper: vec![ends[1]],
        };
        let block = Block::new(&extent, &scenario.domain);
        let count = f64::from(count);
        let points = arranger.points(&block, length(ends) / count, count)?;
        let region: &Region = &scenario.regions[*region];
        particles.extend(filled(scenario, region, length(ends), &points));
    }
    Ok(particles)
}

/// The domain without overlaps: of boxes what no ball lies on, of balls what no later one
/// does; each with the number of its region. Boxes first.
fn stretches(scenario: &Scenario) -> Vec<([f64; 2], usize)> {
    let domain = &scenario.domain.extent;
    let mut stretches: Vec<([f64; 2], usize)> = Vec::new();
    let (boxes, balls): (Vec<_>, Vec<_>) =
        (scenario.regions.iter().enumerate()).partition(|(_, region)| region.ball.is_none());
    for (number, region) in boxes.into_iter().chain(balls) {
        let lower = region.extent.lower[0].max(domain.lower[0]);
        let upper = region.extent.upper[0].min(domain.upper[0]);
        // Boxes touch at most: only balls cut anything.
        let cut = |&(ends, number): &([f64; 2], usize)| {
            let parts = [[ends[0], ends[1].min(lower)], [ends[0].max(upper), ends[1]]];
            parts
                .into_iter()
                .filter(|part| part[0] < part[1])
                .map(move |part| (part, number))
        };
        stretches = stretches.iter().flat_map(cut).collect();
        stretches.push(([lower, upper], number));
    }
    stretches
}
