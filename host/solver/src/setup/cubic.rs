//! The cubic lattice.

use super::SetupError;
use super::block::{Block, room, spacing};

/// Points at the middle of equal cells, nearly cubes, of about this volume.
pub(super) fn points(block: &Block, volume: f64, asked: f64) -> Result<Vec<[f64; 3]>, SetupError> {
    let edge = spacing(volume, 3);
    let n = [0, 1, 2].map(|i| block.fitted(i, edge));
    let mut points = room(n, asked)?;
    for i in 0..n[0] {
        for j in 0..n[1] {
            for k in 0..n[2] {
                let cell = [i, j, k].map(|i| i as f64 + 0.5);
                points.push([0, 1, 2].map(|a| block.at(a, cell[a], n[a])));
            }
        }
    }
    Ok(points)
}
