//! The directions that are searched.

use nalgebra::DMatrix;

/// Unit vectors, one of each pair `n, -n`: through the points of a square grid on the faces of
/// the cube [-1, 1]^D. The axes come first.
pub(super) struct Directions {
    /// The unit vectors.
    pub all: Vec<Vec<f64>>,
    /// A norm on R^D is nowhere on the unit sphere larger than its largest value in `all` times
    /// this: with m the middle of a cell of the grid and α the largest angle to its corners v,
    /// any `n = Σ c_v v` in the cell has `1 >= n·m >= Σ c_v cos α`, so the norm of n is at
    /// most `Σ c_v <= 1/cos α` times that in the corners.
    pub margin: f64,
}

impl Directions {
    /// In that dimension of space: 1 to 3.
    pub(super) fn new(dimension: usize) -> Self {
        // Cells along an edge of the cube. In three dimensions the square of it counts.
        let cells: i32 = match dimension {
            1 => 1,
            2 => 128,
            _ => 16,
        };
        let axis = |i: usize| {
            (0..dimension)
                .map(|j| f64::from(u8::from(i == j)))
                .collect()
        };
        let mut all: Vec<Vec<f64>> = (0..dimension).map(axis).collect();
        for face in 0..dimension {
            let points = (cells as usize + 1).pow(dimension as u32 - 1);
            for mut point in 0..points {
                let mut vector: Vec<f64> = Vec::new();
                for direction in 0..dimension {
                    if direction == face {
                        vector.push(1.0);
                    } else {
                        let place = (point % (cells as usize + 1)) as i32;
                        vector.push(f64::from(2 * place - cells) / f64::from(cells));
                        point /= cells as usize + 1;
                    }
                }
                let length = libm::sqrt(vector.iter().map(|x| x * x).sum());
                all.push(vector.iter().map(|x| x / length).collect());
            }
        }
        // The cell in the middle of a face is seen under the largest angle:
        // tan α = (1/cells) √(D - 1).
        let tangent_squared = (dimension - 1) as f64 / f64::from(cells * cells);
        Self {
            all,
            margin: libm::sqrt(1.0 + tangent_squared),
        }
    }
}

/// `n·A`.
pub(super) fn along(n: &[f64], matrices: &[DMatrix<f64>]) -> DMatrix<f64> {
    let zero = DMatrix::zeros(matrices[0].nrows(), matrices[0].ncols());
    let terms = n.iter().zip(matrices);
    terms.fold(zero, |sum, (&n, a)| sum + n * a)
}
