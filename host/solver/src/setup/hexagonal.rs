//! The triangular lattice of two dimensions.

use super::SetupError;
use super::block::{Block, room};

/// Rows along x, every other one moved by half a spacing; rows `sqrt(3)/2` spacings apart,
/// both stretched to fit. Their number is even where y is periodic.
pub(super) fn points(block: &Block, volume: f64, asked: f64) -> Result<Vec<[f64; 3]>, SetupError> {
    // A rhombus of the lattice: a * a sqrt(3)/2.
    let a = (2.0 * volume / 3f64.sqrt()).sqrt();
    let columns = block.fitted(0, a);
    let rows = block.fitted_layers(1, a * 3f64.sqrt() / 2.0);
    let mut points = room([columns, rows, 1], asked)?;
    for i in 0..columns {
        for j in 0..rows {
            // A quarter from one side in even rows, from the other in odd ones.
            let x = i as f64 + if j % 2 == 0 { 0.25 } else { 0.75 };
            let y = j as f64 + 0.5;
            points.push([block.at(0, x, columns), block.at(1, y, rows), 0.0]);
        }
    }
    Ok(points)
}
