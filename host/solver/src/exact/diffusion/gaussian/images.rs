//! The sum of the periodic images of a Gaussian with any covariance.
//!
//! With the directions without a period first, `Sigma = L L^T` parts into the Gaussian in
//! these and, for a given place in them, a Gaussian in the others with the covariance
//! `S = K K^T`, K the last block of L. Its images are summed directly if it is narrow, and by
//! Poisson's formula, with q periodic directions, if it is wide:
//!
//! `Σ_n exp(-(y + n P).S^-1 (y + n P)/2) = (2 pi)^(q/2) det K/ΠP Σ_m exp(-k.S k/2) cos(k.y)`,
//! `k = 2 pi m/P`

#[cfg(test)]
mod tests;

use std::f64::consts::PI;

/// Where a term is nothing: `exp(-9^2/2) = 3e-18`.
const REACH: f64 = 9.0;

/// A Gaussian and its periods.
pub(super) struct Images {
    /// How many rows and columns count.
    pub(super) dimension: usize,
    /// Sigma, positive definite.
    pub(super) covariance: [[f64; 3]; 3],
    /// None for infinite space.
    pub(super) periods: [Option<f64>; 3],
}

type Matrix = [[f64; 3]; 3];

impl Images {
    /// `(deviation^d / sqrt(det Sigma)) Σ exp(-y.Sigma^-1 y/2)` for y, and all its images.
    pub(super) fn sum(&self, y: [f64; 3], deviation: f64) -> f64 {
        let n = self.dimension;
        let mut order = [0, 1, 2];
        // Stable: keeps the axes of either kind in their order.
        order[..n].sort_by_key(|axis| self.periods[*axis].is_some());
        let free = (0..n).filter(|axis| self.periods[*axis].is_none()).count();
        let at = |i: usize, j: usize| self.covariance[order[i]][order[j]];
        let factor = cholesky(n, at);
        let (mut square, mut peak) = (0.0, 1.0);
        let mut parts = [0.0; 3];
        let mut rest = [0.0; 3];
        for i in 0..n {
            peak *= deviation / factor[i][i];
            let known = (0..i.min(free))
                .map(|j| factor[i][j] * parts[j])
                .sum::<f64>();
            rest[i] = y[order[i]] - known;
            if i < free {
                parts[i] = rest[i] / factor[i][i];
                square += parts[i] * parts[i];
            }
        }
        let outer = peak * libm::exp(-0.5 * square);
        if free == n {
            return outer;
        }
        let from = |i: usize| (free + i).min(2);
        let periodic = Periodic {
            axes: n - free,
            factor: std::array::from_fn(|i| std::array::from_fn(|j| factor[from(i)][from(j)])),
            periods: std::array::from_fn(|i| self.periods[order[from(i)]].unwrap_or(1.0)),
        };
        outer * periodic.sum(std::array::from_fn(|i| rest[from(i)]))
    }
}

/// A Gaussian with a period in each of its directions.
struct Periodic {
    axes: usize,
    /// K.
    factor: Matrix,
    /// P.
    periods: [f64; 3],
}

impl Periodic {
    fn sum(&self, y: [f64; 3]) -> f64 {
        let (mut size, mut height) = (1.0, 1.0);
        for i in 0..self.axes {
            size *= self.factor[i][i] / self.periods[i];
            height *= (2.0 * PI).sqrt();
        }
        // As many terms on either side.
        if size * height <= 1.0 {
            let images = Lattice {
                axes: self.axes,
                factor: inverse(self.axes, &self.factor),
                spacing: self.periods,
                origin: y,
                turns: [0.0; 3],
            };
            images.sum()
        } else {
            // |K^T k|^2 = k.S k with the axes in reverse, which makes K^T lower triangular.
            let back = |i: usize| self.axes - 1 - i.min(self.axes - 1);
            let waves = Lattice {
                axes: self.axes,
                factor: std::array::from_fn(|i| {
                    std::array::from_fn(|j| self.factor[back(j)][back(i)])
                }),
                spacing: std::array::from_fn(|i| 2.0 * PI / self.periods[back(i)]),
                origin: [0.0; 3],
                turns: std::array::from_fn(|i| y[back(i)] * 2.0 * PI / self.periods[back(i)]),
            };
            size * height * waves.sum()
        }
    }
}

/// `Σ_n exp(-|R x|^2/2) cos(n.turns)`, `x = origin + n spacing`, over all n with `|R x|` up to
/// [`REACH`].
struct Lattice {
    axes: usize,
    /// R, lower triangular.
    factor: Matrix,
    spacing: [f64; 3],
    origin: [f64; 3],
    turns: [f64; 3],
}

impl Lattice {
    fn sum(&self) -> f64 {
        self.descend(0, [0.0; 3], 0.0, 0.0)
    }

    /// The terms that share the places along the axes before.
    fn descend(&self, axis: usize, mut x: [f64; 3], square: f64, phase: f64) -> f64 {
        if axis == self.axes {
            return libm::exp(-0.5 * square) * libm::cos(phase);
        }
        let row = &self.factor[axis];
        let known = (0..axis).map(|j| row[j] * x[j]).sum::<f64>();
        let left = (REACH * REACH - square).max(0.0).sqrt();
        let (origin, spacing) = (self.origin[axis], self.spacing[axis]);
        let index = |part: f64| ((part - known) / row[axis] - origin) / spacing;
        let first = libm::ceil(index(-left)) as i64;
        let last = libm::floor(index(left)) as i64;
        let mut sum = 0.0;
        for n in first..=last {
            x[axis] = origin + n as f64 * spacing;
            let part = known + row[axis] * x[axis];
            let phase = phase + n as f64 * self.turns[axis];
            sum += self.descend(axis + 1, x, square + part * part, phase);
        }
        sum
    }
}

/// L of `L L^T`, of n rows.
fn cholesky(n: usize, entry: impl Fn(usize, usize) -> f64) -> Matrix {
    let mut l = [[0.0; 3]; 3];
    for i in 0..n {
        for j in 0..=i {
            let known = (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            let left = entry(i, j) - known;
            l[i][j] = if i == j { left.sqrt() } else { left / l[j][j] };
        }
    }
    l
}

/// The inverse of a lower triangular matrix of n rows.
fn inverse(n: usize, l: &Matrix) -> Matrix {
    let mut inverse = [[0.0; 3]; 3];
    for column in 0..n {
        for row in column..n {
            let unit = if row == column { 1.0 } else { 0.0 };
            let known = (column..row)
                .map(|k| l[row][k] * inverse[k][column])
                .sum::<f64>();
            inverse[row][column] = (unit - known) / l[row][row];
        }
    }
    inverse
}
