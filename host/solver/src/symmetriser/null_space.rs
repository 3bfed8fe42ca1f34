//! All symmetric matrices, definite or not, that make the products symmetric.

use nalgebra::{DMatrix, SVD};

/// Singular values below this are 0: the conditions have coefficients of size one, and
/// rounding leaves 1e-15.
const ZERO: f64 = 1e-9;

/// A basis, orthonormal in the scalar product `tr(P Q)`, of the symmetric p x p P with
/// `P A - A^T P = 0` for all matrices A, which are of size one. `None` if the decomposition does not
/// come to its end.
pub(super) fn symmetrisers(p: usize, matrices: &[DMatrix<f64>]) -> Option<Vec<DMatrix<f64>>> {
    let basis = symmetric_basis(p);
    // A row for each entry above the diagonal of each P A - A^T P, a column for each P; at least
    // as many rows as columns, else the decomposition leaves a part of the null space out.
    let above: Vec<(usize, usize)> = (0..p).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
    let rows = (matrices.len() * above.len()).max(basis.len());
    let mut conditions = DMatrix::zeros(rows, basis.len());
    for (column, element) in basis.iter().enumerate() {
        for (number, a) in matrices.iter().enumerate() {
            let product = element * a;
            for (place, &(i, j)) in above.iter().enumerate() {
                conditions[(number * above.len() + place, column)] =
                    product[(i, j)] - product[(j, i)];
            }
        }
    }
    let decomposition = SVD::try_new(conditions, false, true, f64::EPSILON, 10_000)?;
    let vectors = decomposition.v_t?;
    let values = decomposition.singular_values.iter().enumerate();
    let element = |row: usize| {
        let parts = basis.iter().zip(vectors.row(row));
        parts.fold(DMatrix::zeros(p, p), |sum, (part, &x)| sum + part * x)
    };
    Some(
        values
            .filter(|(_, value)| **value <= ZERO)
            .map(|(row, _)| element(row))
            .collect(),
    )
}

/// The orthonormal basis of the symmetric p x p matrices.
fn symmetric_basis(p: usize) -> Vec<DMatrix<f64>> {
    let pairs = (0..p).flat_map(|j| (0..=j).map(move |i| (i, j)));
    let element = |(i, j): (usize, usize)| {
        let mut element = DMatrix::zeros(p, p);
        let entry = if i == j { 1.0 } else { libm::sqrt(0.5) };
        element[(i, j)] = entry;
        element[(j, i)] = entry;
        element
    };
    pairs.map(element).collect()
}
