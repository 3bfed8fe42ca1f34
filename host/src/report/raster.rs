//! Values of particles on the cells of a picture.

/// Values of particles on `n[0]` x `n[1]` cells between a lower and an upper corner, row by row from
/// below.
///
/// The reconstruction (1.13) with the cut-off M4, normalised (Shepard 1968), at the centre of every
/// cell:
///
/// `f(x) = Σ_l f_l w_l ζ_l(x - x_l) / Σ_l w_l ζ_l(x - x_l)`, `ζ_l = ε_l^-2 z(|x - x_l|/ε_l)`,
/// `z(q) = 1/4 (2-q)₊³ - (1-q)₊³`, `ε_l = 1.3 w_l^(1/2)`
///
/// so that `w_l ζ_l` is `z` but for a factor that cancels: where particles are sparse they are wide,
/// and leave no holes. Between the least and the largest value, exact for constants, O(ε) at an edge
/// and where particles lie unevenly, O(ε²) elsewhere: for pictures, not for errors. Particles that
/// are not finite are left out. Cost: the cells within 2ε of each particle.
#[derive(Clone, Debug)]
pub struct Raster {
    lower: [f64; 2],
    size: [f64; 2],
    n: [usize; 2],
    sums: Vec<(f64, f64)>,
}

impl Raster {
    /// A raster of no particles.
    pub fn new((lower, upper): ([f64; 2], [f64; 2]), n: [usize; 2]) -> Self {
        Self {
            lower,
            size: [0, 1].map(|d| (upper[d] - lower[d]) / n[d] as f64),
            n,
            sums: vec![(0.0, 0.0); n[0] * n[1]],
        }
    }

    /// Adds a particle with its share of the plane.
    pub fn add(&mut self, [x, y]: [f64; 2], volume: f64, value: f64) {
        let eps = WIDTH * volume.sqrt();
        if !(x.is_finite() && y.is_finite() && value.is_finite() && eps.is_finite()) {
            return;
        }
        let n = self.n;
        let centre = |d: usize, cell: usize| self.lower[d] + (cell as f64 + 0.5) * self.size[d];
        // Cells that may lie within 2ε, one more on each side against rounding: z decides.
        let reach = |d: usize, x: f64| {
            let place = |x: f64| (x - self.lower[d]) / self.size[d] - 0.5;
            let first = place(x - 2.0 * eps).floor().max(0.0) as usize;
            let end = place(x + 2.0 * eps).ceil() + 1.0;
            first..(end.max(0.0) as usize).min(n[d])
        };
        for j in reach(1, y) {
            for i in reach(0, x) {
                let distance = (centre(0, i) - x).hypot(centre(1, j) - y);
                let weight = cubic_spline(distance / eps);
                let (numerator, denominator) = &mut self.sums[j * n[0] + i];
                *numerator += weight * value;
                *denominator += weight;
            }
        }
    }

    /// The means; NaN where no particle reaches.
    pub fn means(self) -> Vec<f64> {
        let mean = |(numerator, denominator): (f64, f64)| match denominator > 0.0 {
            true => numerator / denominator,
            false => f64::NAN,
        };
        self.sums.into_iter().map(mean).collect()
    }
}

/// Width of a particle in its own spacings.
pub(super) const WIDTH: f64 = 1.3;

/// M4 without its factor, which cancels.
fn cubic_spline(q: f64) -> f64 {
    let (outer, inner) = ((2.0 - q).max(0.0), (1.0 - q).max(0.0));
    0.25 * outer.powi(3) - inner.powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOWER: [f64; 2] = [-1.0, 0.0];
    const UPPER: [f64; 2] = [1.0, 0.5];

    /// Particles strewn by the golden ratio over the picture and a little beyond.
    fn strewn(count: usize) -> Vec<[f64; 2]> {
        let strewn = |k: usize| {
            let k = k as f64;
            let across = (k * 0.618_033_988_749_895).fract();
            [2.4 * across - 1.2, 0.7 * k / count as f64 - 0.1]
        };
        (0..count).map(strewn).collect()
    }

    fn rasterised(
        positions: &[[f64; 2]],
        values: &[f64],
        eps: f64,
        lower: [f64; 2],
        upper: [f64; 2],
        n: [usize; 2],
    ) -> Vec<f64> {
        let mut raster = Raster::new((lower, upper), n);
        for (position, value) in positions.iter().zip(values) {
            raster.add(*position, (eps / WIDTH).powi(2), *value);
        }
        raster.means()
    }

    fn wave(positions: &[[f64; 2]]) -> Vec<f64> {
        positions.iter().map(|[x, y]| (9.0 * x * y).sin()).collect()
    }

    #[test]
    fn it_is_the_sum_over_all_particles() {
        let positions = strewn(300);
        let (values, n) = (wave(&positions), [23, 9]);
        for eps in [0.01, 0.04, 0.3, 3.0] {
            let cells = rasterised(&positions, &values, eps, LOWER, UPPER, n);
            assert_eq!(cells.len(), 23 * 9);
            for (cell, value) in cells.iter().enumerate() {
                let x = -1.0 + ((cell % 23) as f64 + 0.5) * (2.0 / 23.0);
                let y = ((cell / 23) as f64 + 0.5) * (0.5 / 9.0);
                let (mut numerator, mut denominator) = (0.0, 0.0);
                for (position, value) in positions.iter().zip(&values) {
                    let q = (x - position[0]).hypot(y - position[1]) / eps;
                    numerator += cubic_spline(q) * value;
                    denominator += cubic_spline(q);
                }
                let expected: f64 = numerator / denominator;
                // The width goes through a root and back.
                let same = (value - expected).abs() < 1e-9 || value.is_nan() && expected.is_nan();
                assert!(same, "{value}, not {expected}, in {cell} with {eps}");
            }
        }
    }

    #[test]
    fn no_cell_lies_beyond_the_values_and_a_constant_is_kept() {
        let positions = strewn(2000);
        let values = wave(&positions);
        let cells = rasterised(&positions, &values, 0.05, LOWER, UPPER, [40, 10]);
        assert!(cells.iter().all(|value| (-1.0..=1.0).contains(value)));
        let three = vec![3.0; 2000];
        let cells = rasterised(&positions, &three, 0.05, LOWER, UPPER, [40, 10]);
        // Both sums round at most once for each of some 100 particles in reach.
        assert!(cells.iter().all(|value| (value - 3.0).abs() < 1e-13));
    }

    #[test]
    fn sparse_particles_leave_no_holes_beside_dense_ones() {
        // Sixteen times sparser in the upper half.
        let mut raster = Raster::new(([0.0; 2], [16.0, 32.0]), [64, 128]);
        for k in 0..256 {
            let (x, y) = (f64::from(k % 16) + 0.5, f64::from(k / 16) + 0.5);
            raster.add([x, y], 1.0, 1.0);
            if k < 16 {
                let (x, y) = (f64::from(k % 4), f64::from(k / 4));
                raster.add([4.0 * x + 2.0, 4.0 * y + 18.0], 16.0, 2.0);
            }
        }
        let cells = raster.means();
        assert!(cells.iter().all(|value| (1.0..=2.0).contains(value)));
        assert_eq!((cells[5 * 64 + 30], cells[120 * 64 + 30]), (1.0, 2.0));
    }

    #[test]
    fn a_linear_field_on_a_lattice_is_kept_within() {
        let lattice = |k: usize| [(k % 20) as f64 + 0.5, (k / 20) as f64 + 0.5];
        let positions: Vec<[f64; 2]> = (0..400).map(lattice).collect();
        let values: Vec<f64> = positions.iter().map(|[x, y]| 2.0 * x - 3.0 * y).collect();
        let cells = rasterised(&positions, &values, 1.2, [0.0; 2], [20.0; 2], [20, 20]);
        for (cell, (value, exact)) in cells.iter().zip(&values).enumerate() {
            let within = |k: usize| (2..18).contains(&k);
            // By symmetry but for rounding; an edge at 2ε = 2.4 spoils two rows.
            if within(cell % 20) && within(cell / 20) {
                assert!((value - exact).abs() < 1e-12, "{value} for {exact}");
            }
        }
    }

    #[test]
    fn cells_out_of_reach_are_empty_and_bad_particles_are_left_out() {
        let positions = [[0.05, 0.025], [f64::NAN, 0.0], [0.8, 0.2], [1e300, 0.0]];
        let values = [7.0, 1.0, f64::INFINITY, 2.0];
        let cells = rasterised(&positions, &values, 0.02, LOWER, UPPER, [20, 10]);
        let filled: Vec<usize> = (0..200).filter(|&cell| !cells[cell].is_nan()).collect();
        assert_eq!(filled, [10]);
        assert_eq!(cells[10], 7.0);
    }
}
