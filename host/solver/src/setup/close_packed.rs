//! Hexagonal close packing in three dimensions.

use super::SetupError;
use super::block::{Block, room};

/// Triangular layers, stacked A B A B along z `sqrt(2/3)` spacings apart: each B stands over
/// the holes of A. Rows and layers are stretched to fit and even in number where their
/// direction is periodic.
pub(super) fn points(block: &Block, volume: f64, asked: f64) -> Result<Vec<[f64; 3]>, SetupError> {
    // Two particles in a cell of a * sqrt(3) a / 2 * 2 sqrt(2/3) a: each has a^3 / sqrt(2).
    let a = libm::cbrt(2f64.sqrt() * volume);
    let columns = block.fitted(0, a);
    let rows = block.fitted_layers(1, a * 3f64.sqrt() / 2.0);
    let layers = block.fitted_layers(2, a * (2.0 / 3f64).sqrt());
    let mut points = room([columns, rows, layers], asked)?;
    for i in 0..columns {
        for j in 0..rows {
            for k in 0..layers {
                // B is moved by half a spacing along x and a third of a row along y.
                let x = i as f64 + if (j + k) % 2 == 0 { 0.25 } else { 0.75 };
                let y = j as f64 + if k % 2 == 0 { 1.0 / 3.0 } else { 2.0 / 3.0 };
                let z = k as f64 + 0.5;
                points.push([
                    block.at(0, x, columns),
                    block.at(1, y, rows),
                    block.at(2, z, layers),
                ]);
            }
        }
    }
    Ok(points)
}
