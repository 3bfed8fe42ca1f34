//! The best conditioned positive definite matrix of a space of symmetric matrices.

use nalgebra::{DMatrix, DVector};

/// Smallest eigenvalues below this, at trace p, are those of no definite matrix.
const LEAST: f64 = 1e-8;

/// How far below the best the smallest eigenvalue may stay, relative.
const GAP: f64 = 1e-3;

/// Newton steps at one weight of the barrier at most; five are usual.
const STEPS: usize = 50;

/// The matrix of trace p with the largest smallest eigenvalue, to [`GAP`]; `None` if the space,
/// given by an orthonormal basis, has no definite one.
///
/// Maximises `t + μ ln det(P - t I)` over the P of trace p and t, for a falling μ, from the
/// projection of the identity (Boyd and Vandenberghe, Convex Optimization (2004), 11.6). At
/// the maximum t is at most `μ p` below the best.
pub(super) fn best(space: &[DMatrix<f64>]) -> Option<DMatrix<f64>> {
    let p = space.first()?.nrows();
    let (start, moves) = through_identity(space)?;
    let lowest = start.symmetric_eigenvalues().min();
    if moves.is_empty() {
        return (lowest >= LEAST).then_some(start);
    }
    let mut point = Point {
        matrix: start,
        level: lowest - 1.0,
    };
    let mut weight = 1.0;
    loop {
        point = point.centred(&moves, weight);
        let gap = weight * p as f64;
        if gap <= GAP * point.level {
            return (point.level >= LEAST).then_some(point.matrix);
        }
        // The centre is met to a tenth: half a gap for that.
        if point.level + 1.5 * gap < LEAST || gap < GAP * LEAST {
            return None;
        }
        weight *= 0.25;
    }
}

/// The projection of the identity, of trace p, and an orthonormal basis of what in the space
/// has trace 0. `None` if all of it has, or nearly: a definite matrix of trace p makes an angle
/// with the identity whose cosine is at least `1/√p`.
fn through_identity(space: &[DMatrix<f64>]) -> Option<(DMatrix<f64>, Vec<DMatrix<f64>>)> {
    let p = space[0].nrows();
    let zero = DMatrix::zeros(p, p);
    let projection = space.iter().fold(zero, |sum, q| sum + q * q.trace());
    let size = projection.norm_squared();
    if size < 0.5 {
        return None;
    }
    let start = &projection * (p as f64 / size);
    // Gram and Schmidt, twice for round-off; of n elements n - 1 are left.
    let mut kept = vec![projection.unscale(libm::sqrt(size))];
    let mut candidates: Vec<DMatrix<f64>> = space.to_vec();
    while kept.len() < space.len() {
        for candidate in &mut candidates {
            for _ in 0..2 {
                for q in &kept {
                    *candidate -= q * q.dot(candidate);
                }
            }
        }
        let longest = (0..candidates.len())
            .max_by(|&a, &b| candidates[a].norm().total_cmp(&candidates[b].norm()))?;
        kept.push(candidates.swap_remove(longest).normalize());
    }
    kept.remove(0);
    Some((start, kept))
}

/// P and t, with `P - t I` definite.
struct Point {
    matrix: DMatrix<f64>,
    level: f64,
}

impl Point {
    /// Goes to the maximum for a weight μ by damped Newton steps, which stay in the definite
    /// matrices (Boyd and Vandenberghe 9.6): `1/(1 + δ)` of a step, δ its length in the metric of
    /// the barrier.
    fn centred(mut self, moves: &[DMatrix<f64>], weight: f64) -> Self {
        for _ in 0..STEPS {
            let Some((step, rise, length)) = self.newton(moves, weight) else {
                break;
            };
            let share = if length > 0.25 {
                1.0 / (1.0 + length)
            } else {
                1.0
            };
            for (change, along) in step.iter().zip(moves) {
                self.matrix += along * (share * change);
            }
            self.level += share * rise;
            if length < 0.1 {
                break;
            }
        }
        self
    }

    /// The step along each move, that of the level, and the length of both together.
    fn newton(&self, moves: &[DMatrix<f64>], weight: f64) -> Option<(Vec<f64>, f64, f64)> {
        let p = self.matrix.nrows();
        let above = &self.matrix - DMatrix::identity(p, p) * self.level;
        let lower = above.cholesky()?.l();
        let identity = DMatrix::identity(p, p) * -1.0;
        // L^-1 B L^-T of each move; of the level too, which takes away the identity.
        let seen = |b: &DMatrix<f64>| {
            let half = lower.solve_lower_triangular(b)?;
            lower.solve_lower_triangular(&half.transpose())
        };
        let seen: Vec<DMatrix<f64>> = moves
            .iter()
            .chain([&identity])
            .map(seen)
            .collect::<Option<_>>()?;
        let n = seen.len();
        let mut gradient = DVector::from_fn(n, |i, _| seen[i].trace());
        gradient[n - 1] += 1.0 / weight;
        let curvature = DMatrix::from_fn(n, n, |i, j| seen[i].dot(&seen[j]));
        let step = curvature.cholesky()?.solve(&gradient);
        let length = libm::sqrt(gradient.dot(&step).max(0.0));
        Some((step.as_slice()[..n - 1].to_vec(), step[n - 1], length))
    }
}
