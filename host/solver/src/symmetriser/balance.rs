//! Unknowns scaled such that the matrices have rows and columns of one size.

use nalgebra::DMatrix;

/// Matrices `S^-1 A S` with a diagonal S of powers of two, so that no bit is lost: in units in
/// which densities are 1e3 and stresses 1e10 nothing could be told from rounding.
pub(super) struct Balanced {
    /// The scaled matrices.
    pub matrices: Vec<DMatrix<f64>>,
    /// The diagonal of S.
    scales: Vec<f64>,
}

/// Rounds of scaling at most; three or four are usual.
const ROUNDS: usize = 200;

impl Balanced {
    /// Balances all matrices together (Parlett and Reinsch, Numer. Math. 13 (1969) 293): row and
    /// column sums of `Σ_i |A^i|`, without diagonals. A zero sum is left as it is. Symmetric
    /// matrices are not changed.
    pub(super) fn new(matrices: &[DMatrix<f64>]) -> Self {
        let p = matrices[0].nrows();
        let mut matrices = matrices.to_vec();
        let mut scales = vec![1.0; p];
        for _ in 0..ROUNDS {
            let mut changed = false;
            for k in 0..p {
                let sum = |entry: &dyn Fn(&DMatrix<f64>, usize) -> f64| -> f64 {
                    let others = (0..p).filter(|&j| j != k);
                    others
                        .flat_map(|j| matrices.iter().map(move |a| (a, j)))
                        .map(|(a, j)| entry(a, j).abs())
                        .sum()
                };
                let (column, row) = (sum(&|a, j| a[(j, k)]), sum(&|a, j| a[(k, j)]));
                let factor = power_of_two(libm::sqrt(row) / libm::sqrt(column));
                // Only where it makes them smaller by a twentieth: else it might never end.
                let after = column * factor + row / factor;
                if !factor.is_finite() || factor == 0.0 || !(after < 0.95 * (column + row)) {
                    continue;
                }
                changed = true;
                scales[k] *= factor;
                for a in &mut matrices {
                    a.column_mut(k).scale_mut(factor);
                    a.row_mut(k).unscale_mut(factor);
                }
            }
            if !changed {
                break;
            }
        }
        Self { matrices, scales }
    }

    /// The matrices without the part that is a multiple of the identity, which any P makes
    /// symmetric, and each of size one. What is but such a multiple is left out.
    pub(super) fn shapes(&self) -> Vec<DMatrix<f64>> {
        let shape = |a: &DMatrix<f64>| {
            let p = a.nrows();
            let shape = a - DMatrix::identity(p, p) * (a.trace() / p as f64);
            let size = shape.norm();
            (size > 1e-14 * a.norm()).then(|| shape / size)
        };
        self.matrices.iter().filter_map(shape).collect()
    }

    /// `P` for the unknowns as they were: `S^-1 P S^-1`, of trace p.
    pub(super) fn unscaled(&self, scaled: &DMatrix<f64>) -> DMatrix<f64> {
        let p = scaled.nrows();
        let entry = |i, j| scaled[(i, j)] / self.scales[i] / self.scales[j];
        let matrix = DMatrix::from_fn(p, p, entry);
        &matrix * (p as f64 / matrix.trace())
    }

    /// The condition number of the same: the inverse is made in scaled unknowns, where it loses
    /// nothing.
    pub(super) fn condition(&self, scaled: &DMatrix<f64>) -> f64 {
        let p = scaled.nrows();
        let Some(inverse) = scaled.clone().cholesky().map(|factors| factors.inverse()) else {
            return f64::INFINITY;
        };
        let largest = |matrix: DMatrix<f64>| matrix.symmetric_eigenvalues().max();
        let entry = |i, j| scaled[(i, j)] / self.scales[i] / self.scales[j];
        let back = |i, j| inverse[(i, j)] * self.scales[i] * self.scales[j];
        largest(DMatrix::from_fn(p, p, entry)) * largest(DMatrix::from_fn(p, p, back))
    }
}

/// The power of two next to a positive number, in the logarithm; NaN and infinity stay.
fn power_of_two(x: f64) -> f64 {
    libm::exp2(libm::round(libm::log2(x)))
}
