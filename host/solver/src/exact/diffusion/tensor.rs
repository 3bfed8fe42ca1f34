//! The tensor T of `div(b T grad u)`.

use super::super::linear::error::{SolutionError, check, finite};

/// Rounding that a product of numbers given as decimals may leave in a determinant of 0.
const ROUNDING: f64 = 1e-14;

/// 1 in all directions.
pub(super) const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// That T is symmetric, without negative eigenvalues, and zero beyond a dimension. All
/// principal minors of such a matrix, and of no other symmetric one, are >= 0.
pub(super) fn check_tensor(t: &[[f64; 3]; 3], dimension: usize) -> Result<(), SolutionError> {
    let name = "tensor";
    for row in 0..3 {
        for column in 0..3 {
            let value = t[row][column];
            let inside = row < dimension && column < dimension;
            check(&[
                finite(name, value),
                (name, value, "symmetric", value == t[column][row]),
                (
                    name,
                    value,
                    "zero beyond the dimension",
                    inside || value == 0.0,
                ),
            ])?;
        }
    }
    let minor = |i: usize, j: usize| t[i][i] * t[j][j] - t[i][j] * t[i][j];
    let determinant = t[0][0] * minor(1, 2) - t[0][1] * (t[0][1] * t[2][2] - t[1][2] * t[0][2])
        + t[0][2] * (t[0][1] * t[1][2] - t[1][1] * t[0][2]);
    let need = "without negative eigenvalues";
    let not_negative = |value: f64, size: f64| (name, value, need, value >= -ROUNDING * size);
    let [x, y, z] = [t[0][0], t[1][1], t[2][2]];
    check(&[
        not_negative(x, 0.0),
        not_negative(y, 0.0),
        not_negative(z, 0.0),
        not_negative(minor(0, 1), x * y),
        not_negative(minor(0, 2), x * z),
        not_negative(minor(1, 2), y * z),
        not_negative(determinant, x * y * z),
    ])
}
