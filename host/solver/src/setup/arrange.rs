//! Which arrangement fills a box.

use super::block::{Block, spacing};
use super::random::Random;
use super::{SetupError, close_packed, cubic, glass, hexagonal, line, square};
use crate::scenario::{Anchor, Arrangement, Resolution, Scenario};

/// Fills boxes with the points of a scenario's arrangement, one after the other: the random
/// numbers of one go on where those of the last one stopped.
pub(super) struct Arranger<'a> {
    resolution: &'a Resolution,
    random: Random,
}

/// How far the particles of a glass are moved before it is relaxed, in spacings.
const GLASS_JITTER: f64 = 0.45;

impl<'a> Arranger<'a> {
    pub(super) fn new(scenario: &'a Scenario) -> Self {
        Self {
            resolution: &scenario.resolution,
            random: Random::new(scenario.resolution.seed),
        }
    }

    /// Points in a box, of about this volume each; at least one. `asked`: about how many.
    pub(super) fn points(
        &mut self,
        block: &Block,
        volume: f64,
        asked: f64,
    ) -> Result<Vec<[f64; 3]>, SetupError> {
        let resolution = self.resolution;
        let mut points = match (&resolution.arrangement, block.dimension) {
            (_, 1) => line::points(block, volume, asked)?,
            (Arrangement::Hexagonal, _) => hexagonal::points(block, volume, asked)?,
            (Arrangement::ClosePacked, _) => close_packed::points(block, volume, asked)?,
            (_, 2) => match resolution.rotation {
                Some(rotation) => square::turned(block, volume, asked, rotation)?,
                None => square::points(block, volume, asked)?,
            },
            _ => cubic::points(block, volume, asked)?,
        };
        if resolution.anchor == Anchor::Corner {
            into_the_corner(block, &mut points);
        }
        let spacing = spacing(block.volume() / points.len() as f64, block.dimension);
        if resolution.arrangement == Arrangement::Glass {
            self.jitter(block, GLASS_JITTER * spacing, &mut points);
            glass::relax(block, spacing, &mut points)?;
        } else if resolution.jitter > 0.0 {
            self.jitter(block, resolution.jitter * spacing, &mut points);
        }
        Ok(points)
    }

    /// Moves every point by at most `most` along each direction.
    fn jitter(&mut self, block: &Block, most: f64, points: &mut [[f64; 3]]) {
        for point in points {
            let mut moved = *point;
            for x in moved.iter_mut().take(block.dimension) {
                *x += most * self.random.signed();
            }
            *point = block.inside(moved);
        }
    }
}

/// Moves a lattice until its lowest particles lie on the lower faces.
fn into_the_corner(block: &Block, points: &mut [[f64; 3]]) {
    for i in 0..block.dimension {
        let lowest = points.iter().map(|point| point[i]);
        let gap = lowest.fold(f64::INFINITY, f64::min) - block.lower[i];
        for point in &mut *points {
            // Not below the face where the difference rounds.
            point[i] = (point[i] - gap).max(block.lower[i]);
        }
    }
}
