//! The square lattice of two dimensions, upright or turned.

use super::SetupError;
use super::block::{Block, room};

/// Points at the middle of equal cells, nearly squares, of about this volume.
pub(super) fn points(block: &Block, volume: f64, asked: f64) -> Result<Vec<[f64; 3]>, SetupError> {
    let n = [0, 1].map(|i| block.fitted(i, volume.sqrt()));
    let mut points = room([n[0], n[1], 1], asked)?;
    for i in 0..n[0] {
        for j in 0..n[1] {
            let x = block.at(0, i as f64 + 0.5, n[0]);
            points.push([x, block.at(1, j as f64 + 0.5, n[1]), 0.0]);
        }
    }
    Ok(points)
}

/// The same, turned by `atan(p/q)`, `p` and `q` without a common factor.
///
/// The lattice of `(q, p)` and `(-p, q)` has the period `n = p^2 + q^2` along both axes, and
/// in a period one point in each of the columns 0..n: that of column `i` in row `p q^-1 i
/// mod n`. The box holds a whole number of periods in each direction, so a periodic one has
/// no seam.
pub(super) fn turned(
    block: &Block,
    volume: f64,
    asked: f64,
    [p, q]: [u32; 2],
) -> Result<Vec<[f64; 3]>, SetupError> {
    let (wide_p, wide_q) = (u64::from(p), u64::from(q));
    let n = wide_p * wide_p + wide_q * wide_q;
    // A period is sqrt(n) spacings.
    let period = (volume * n as f64).sqrt();
    let periods = [0, 1].map(|i| (block.length(i) / period).round() as usize);
    if periods.contains(&0) {
        return Err(SetupError::Rotation { p, q, cell: n });
    }
    // In whole periods: a point a column and period.
    let columns = periods[0].saturating_mul(usize::try_from(n).unwrap_or(usize::MAX));
    let mut points = room([columns, periods[1], 1], asked)?;
    let inverse = (1..=n).find(|inverse| wide_q * inverse % n == 1 % n);
    let slope = wide_p * inverse.unwrap_or(1) % n;
    let cells = periods.map(|periods| periods * n as usize);
    for column in 0..cells[0] {
        let row = column as u64 % n * slope % n;
        for period in 0..periods[1] {
            let x = block.at(0, column as f64 + 0.5, cells[0]);
            let row = period as u64 * n + row;
            points.push([x, block.at(1, row as f64 + 0.5, cells[1]), 0.0]);
        }
    }
    Ok(points)
}
