//! A symmetric matrix without negative eigenvalues, one row a direction.

use super::matrices::matrix;
use crate::entry::Entry;
use crate::error::Fault;
use crate::geometry::AXES;
use crate::{Domain, Side};

/// By how much a minor may be below 0, as a part of its terms: what rounding can make of one
/// that is 0, as of a matrix `v vᵀ`.
const ROUNDING: f64 = 1e-12;

/// `system.tensor`.
pub(super) fn tensor(entry: &Entry<'_>, domain: &Domain) -> Result<Vec<Vec<f64>>, Fault> {
    let dimension = domain.sides.len();
    if dimension == 1 {
        let reason = "dimension = 1: there is one direction".to_owned();
        return Err(entry.does_not_fit(reason, "take `tensor` out: `diffusivity` says all"));
    }
    let numbers = matrix(entry, dimension, "dimension")?;
    let rows: Vec<Vec<f64>> = numbers
        .chunks_exact(dimension)
        .map(<[f64]>::to_vec)
        .collect();
    for i in 0..dimension {
        for j in 0..i {
            let (below, above) = (rows[i][j], rows[j][i]);
            if below != above {
                let reason =
                    format!("row {i} has {below} in column {j}, row {j} has {above} in column {i}");
                let cure = "make it symmetric; rows and columns are numbered from 0";
                return Err(entry.does_not_fit(reason, cure));
            }
        }
    }
    if has_negative(&rows) {
        let reason = "it has a negative eigenvalue: diffusion would run backwards".to_owned();
        let cure = "make the off-diagonal entries smaller: a pair may be sqrt(a_ii a_jj) at most";
        return Err(entry.does_not_fit(reason, cure));
    }
    let walls = domain
        .sides
        .iter()
        .map(|sides| sides.contains(&Side::Mirror));
    for (i, is_wall) in walls.enumerate() {
        let slanted = (0..dimension).any(|j| j != i && rows[i][j] != 0.0);
        if is_wall && slanted {
            let reason = format!(
                "row {i} has off-diagonals, and there is a wall across {}: behind a mirror they \
                 would change sign",
                AXES[i]
            );
            let cure = "set them to 0, or the sides of that direction to \"periodic\" or \"free\"";
            return Err(entry.does_not_fit(reason, cure));
        }
    }
    Ok(rows)
}

/// Whether an eigenvalue is below 0: exactly if a principal minor is.
fn has_negative(rows: &[Vec<f64>]) -> bool {
    let entry = |i: usize, j: usize| rows[i][j];
    let size = rows.len();
    let pairs = (0..size).flat_map(|i| (0..i).map(move |j| (i, j)));
    let single = (0..size).any(|i| entry(i, i) < 0.0);
    let double = pairs.into_iter().any(|(i, j)| {
        let (main, other) = (entry(i, i) * entry(j, j), entry(i, j) * entry(i, j));
        main - other < -ROUNDING * (main + other)
    });
    single
        || double
        || size == 3 && {
            let main = entry(0, 0) * entry(1, 1) * entry(2, 2);
            let cross = 2.0 * entry(0, 1) * entry(1, 2) * entry(2, 0);
            let squares: f64 = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
                .map(|(i, j, k)| entry(i, i) * entry(j, k) * entry(j, k))
                .iter()
                .sum();
            main + cross - squares < -ROUNDING * (main + cross.abs() + squares)
        }
}
