//! Why a system has no symmetriser.

use nalgebra::{DMatrix, Schur};

use super::SymmetriserError;
use super::directions::{Directions, along};

/// Imaginary parts below this, over the size of the matrix, are those of a multiple real
/// eigenvalue: rounding moves one of multiplicity k by 1e-16^(1/k), 5e-6 for three.
const REAL: f64 = 1e-4;

/// Singular values of `A - λ I` below this, over the size, are 0 if λ is the mean of eigenvalues
/// that differ by less than [`REAL`].
const NO_RANK: f64 = 1e-3;

/// What is found along the directions: first an eigenvalue that is not real, where it is least
/// so, then a lack of eigenvectors.
pub(super) fn why(matrices: &[DMatrix<f64>], directions: &Directions) -> SymmetriserError {
    let mut worst = (REAL, None);
    for n in &directions.all {
        let matrix = along(n, matrices);
        let size = matrix.norm();
        for [real, imaginary] in eigenvalues(&matrix).unwrap_or_default() {
            if imaginary.abs() > worst.0 * size {
                worst = (imaginary.abs() / size, Some((n.clone(), [real, imaginary])));
            }
        }
    }
    if let Some((direction, eigenvalue)) = worst.1 {
        return SymmetriserError::NotHyperbolic {
            direction,
            eigenvalue,
        };
    }
    let lacking = |n: &&Vec<f64>| lacks_eigenvectors(&along(n, matrices));
    match directions.all.iter().find(lacking) {
        Some(direction) => SymmetriserError::NotDiagonalisable {
            direction: direction.clone(),
        },
        None => SymmetriserError::NotSymmetrisable,
    }
}

/// Real and imaginary parts; `None` if the iteration does not come to its end.
fn eigenvalues(matrix: &DMatrix<f64>) -> Option<Vec<[f64; 2]>> {
    let p = matrix.nrows();
    let schur = |matrix: DMatrix<f64>| Schur::try_new(matrix, f64::EPSILON, 1000);
    let schur = schur(matrix.clone()).or_else(|| {
        // The iteration stands still on some orthogonal matrices; a similar one is not.
        let entry = |i, j| {
            if i == j {
                1.0
            } else {
                0.3 / (1.0 + (i + 2 * j) as f64)
            }
        };
        let skew = DMatrix::from_fn(p, p, entry);
        let inverse = skew.clone().try_inverse()?;
        schur(inverse * matrix * skew)
    })?;
    let values = schur.complex_eigenvalues();
    Some(values.iter().map(|value| [value.re, value.im]).collect())
}

/// Whether some eigenvalue has fewer eigenvectors than its multiplicity, all being real.
fn lacks_eigenvectors(matrix: &DMatrix<f64>) -> bool {
    let p = matrix.nrows();
    let size = matrix.norm();
    let mut values: Vec<f64> = eigenvalues(matrix)
        .unwrap_or_default()
        .iter()
        .map(|value| value[0])
        .collect();
    values.sort_by(f64::total_cmp);
    let near = |a: &f64, b: &f64| (a - b).abs() <= REAL * size;
    values.chunk_by(near).any(|group| {
        let mean = group.iter().sum::<f64>() / group.len() as f64;
        let rest = matrix - DMatrix::identity(p, p) * mean;
        let zeros = rest.singular_values();
        let zeros = zeros.iter().filter(|value| **value <= NO_RANK * size);
        zeros.count() < group.len()
    })
}
