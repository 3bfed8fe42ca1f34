//! How the covariance of a Gaussian grows in a flow.
//!
//! `Sigma(t) = E(t) Sigma_0 E(t)^T + 2 b ∫_0^t E(s) T E(s)^T ds`, `E(s) = e^(A s)`.

use super::super::super::linear::transport::decaying_integral;
use super::super::super::linear::transport::field::Field;
use super::super::modulation::elapsed;
use super::GaussianProblem;

type Matrix = [[f64; 3]; 3];

impl GaussianProblem {
    /// Sigma at a time; beyond the dimension it means nothing.
    pub(super) fn covariance(&self, time: f64) -> Matrix {
        let variance = 0.5 * self.width * self.width;
        let tensor = self.tensor_or_identity();
        let (initial, spread) = match self.field {
            Field::Rotation { rate, .. } if self.tensor.is_some() => {
                (isotropic(variance), turned(&tensor, rate, time))
            }
            Field::Shear { rate, .. } => (
                sheared(variance, rate * time),
                sheared_on_the_way(&tensor, rate, time),
            ),
            Field::Compression { rate, .. } => (
                isotropic(variance * libm::exp(-2.0 * rate * time)),
                scaled(&tensor, decaying_integral(2.0 * rate, time)),
            ),
            _ => {
                let tau = elapsed(self.modulation, time);
                (isotropic(variance), scaled(&tensor, tau))
            }
        };
        let sum = |i: usize, j: usize| initial[i][j] + 2.0 * self.diffusivity * spread[i][j];
        std::array::from_fn(|i| std::array::from_fn(|j| sum(i, j)))
    }
}

fn isotropic(variance: f64) -> Matrix {
    scaled(&super::IDENTITY, variance)
}

fn scaled(matrix: &Matrix, factor: f64) -> Matrix {
    matrix.map(|row| row.map(|entry| factor * entry))
}

/// `E Sigma_0 E^T` for `E = [[1, s, 0], [0, 1, 0], [0, 0, 1]]`.
fn sheared(variance: f64, s: f64) -> Matrix {
    let mut matrix = isotropic(variance);
    matrix[0][0] += variance * s * s;
    matrix[0][1] = variance * s;
    matrix[1][0] = matrix[0][1];
    matrix
}

/// `∫_0^t E T E^T ds` for the same E with `rate s`: what had `T_xy` gains `rate s T_yy`, what had
/// `T_xx` gains `2 rate s T_xy + (rate s)^2 T_yy`.
fn sheared_on_the_way(t: &Matrix, rate: f64, time: f64) -> Matrix {
    let linear = 0.5 * rate * time;
    let square = rate * rate * time * time / 3.0;
    let mut matrix = *t;
    matrix[0][0] += 2.0 * linear * t[0][1] + square * t[1][1];
    matrix[0][1] += linear * t[1][1];
    matrix[0][2] += linear * t[1][2];
    matrix[1][0] = matrix[0][1];
    matrix[2][0] = matrix[0][2];
    scaled(&matrix, time)
}

/// The same for a rotation about z. In the plane `(T_xx - T_yy)/2 + i T_xy` turns by twice the
/// angle, `T_xz + i T_yz` by the angle, the rest stays;
/// `∫_0^t e^(i w s) ds = t e^(i w t/2) sin(w t/2)/(w t/2)`.
fn turned(t: &Matrix, rate: f64, time: f64) -> Matrix {
    let turn = |w: f64, [real, imaginary]: [f64; 2]| {
        let half = 0.5 * w * time;
        let (sine, cosine) = (libm::sin(half), libm::cos(half));
        let size = if half == 0.0 { 1.0 } else { sine / half };
        [
            size * (cosine * real - sine * imaginary),
            size * (sine * real + cosine * imaginary),
        ]
    };
    let mean = 0.5 * (t[0][0] + t[1][1]);
    let [along, cross] = turn(2.0 * rate, [0.5 * (t[0][0] - t[1][1]), t[0][1]]);
    let [xz, yz] = turn(rate, [t[0][2], t[1][2]]);
    let matrix = [
        [mean + along, cross, xz],
        [cross, mean - along, yz],
        [xz, yz, t[2][2]],
    ];
    scaled(&matrix, time)
}
