//! Symmetrisers of systems of physics, of random systems, and refusals.

mod found;
mod refused;

use nalgebra::DMatrix;

use super::{Symmetriser, SymmetriserError};

/// Matrices by their rows.
pub(super) fn flat<const P: usize>(rows: [[f64; P]; P]) -> Vec<f64> {
    rows.as_flattened().to_vec()
}

/// Checks P against its definition: the symmetry of each P A, entry by entry in units of
/// `√(P_ii P_jj)` (so that units do not matter), definite, trace p.
pub(super) fn assert_symmetrises(found: &Symmetriser, matrices: &[Vec<f64>], what: &str) {
    let n = matrices[0].len().isqrt();
    let p = DMatrix::from_row_slice(n, n, &found.matrix);
    assert_eq!(p, p.transpose(), "{what}");
    assert!(
        (p.trace() - n as f64).abs() < 1e-12 * n as f64,
        "{what}: {}",
        p.trace()
    );
    let root = |i: usize| p[(i, i)].sqrt();
    let even = DMatrix::from_fn(n, n, |i, j| p[(i, j)] / root(i) / root(j));
    let least = even.symmetric_eigenvalues().min();
    assert!(least > 1e-8, "{what}: {least:e}");
    for entries in matrices {
        let a = DMatrix::from_row_slice(n, n, entries);
        // A in the unknowns √P_ii u_i.
        let a = DMatrix::from_fn(n, n, |i, j| root(i) * a[(i, j)] / root(j));
        let product = &even * &a;
        let off = (&product - product.transpose()).norm();
        assert!(off <= 1e-11 * a.norm(), "{what}: {off:e}");
    }
}

/// A generator of even numbers in [-1, 1]: splitmix64.
pub(super) struct Random(pub u64);

impl Random {
    pub(super) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as i64 as f64 / 2f64.powi(63)
    }

    pub(super) fn matrix(&mut self, p: usize) -> DMatrix<f64> {
        DMatrix::from_fn(p, p, |_, _| self.next())
    }
}

/// Row by row.
pub(super) fn rows(matrix: &DMatrix<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

/// What is refused, and as what.
pub(super) fn refusal(matrices: &[Vec<f64>]) -> SymmetriserError {
    Symmetriser::of(matrices).unwrap_err()
}
