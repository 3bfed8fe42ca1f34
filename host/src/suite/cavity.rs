//! The cavity under a lid against the values of others.
//!
//! Velocities along the middle lines of the unit square under a lid of velocity 1, steady: U. Ghia, K. N.
//! Ghia and C. T. Shin, J. Comput. Phys. 48, 387 (1982), tables I and II, from 129 x 129 points. At Reynolds
//! number 400 their value at x = 0.9063 is left out: it does not lie on the curve of its neighbours.

/// A place on a middle line, and the velocity across it there.
type Value = (f64, f64);

/// `u(1/2, y)` at Reynolds number 100.
const ACROSS_X_100: &[Value] = &[
    (0.9766, 0.84123),
    (0.9688, 0.78871),
    (0.9609, 0.73722),
    (0.9531, 0.68717),
    (0.8516, 0.23151),
    (0.7344, 0.00332),
    (0.6172, -0.13641),
    (0.5000, -0.20581),
    (0.4531, -0.21090),
    (0.2813, -0.15662),
    (0.1719, -0.10150),
    (0.1016, -0.06434),
    (0.0703, -0.04775),
    (0.0625, -0.04192),
    (0.0547, -0.03717),
];

/// `v(x, 1/2)` at Reynolds number 100.
const ACROSS_Y_100: &[Value] = &[
    (0.9688, -0.05906),
    (0.9609, -0.07391),
    (0.9531, -0.08864),
    (0.9453, -0.10313),
    (0.9063, -0.16914),
    (0.8594, -0.22445),
    (0.8047, -0.24533),
    (0.5000, 0.05454),
    (0.2344, 0.17527),
    (0.2266, 0.17507),
    (0.1563, 0.16077),
    (0.0938, 0.12317),
    (0.0781, 0.10890),
    (0.0703, 0.10091),
    (0.0625, 0.09233),
];

/// `u(1/2, y)` at Reynolds number 400.
const ACROSS_X_400: &[Value] = &[
    (0.9766, 0.75837),
    (0.9688, 0.68439),
    (0.9609, 0.61756),
    (0.9531, 0.55892),
    (0.8516, 0.29093),
    (0.7344, 0.16256),
    (0.6172, 0.02135),
    (0.5000, -0.11477),
    (0.4531, -0.17119),
    (0.2813, -0.32726),
    (0.1719, -0.24299),
    (0.1016, -0.14612),
    (0.0703, -0.10338),
    (0.0625, -0.09266),
    (0.0547, -0.08186),
];

/// `v(x, 1/2)` at Reynolds number 400.
const ACROSS_Y_400: &[Value] = &[
    (0.9688, -0.12146),
    (0.9609, -0.15663),
    (0.9531, -0.19254),
    (0.9453, -0.22847),
    (0.8594, -0.44993),
    (0.8047, -0.38598),
    (0.5000, 0.05186),
    (0.2344, 0.30174),
    (0.2266, 0.30203),
    (0.1563, 0.28124),
    (0.0938, 0.22965),
    (0.0781, 0.20920),
    (0.0703, 0.19713),
    (0.0625, 0.18360),
];

/// A particle: its place and its velocity.
pub(super) type Moving = ([f64; 2], [f64; 2]);

/// The deviation from the values at the Reynolds number next to this one, root of the mean square, in
/// velocities of the lid.
pub(super) fn deviation(particles: &[Moving], reynolds_number: f64) -> f64 {
    let (along_y, along_x) = match reynolds_number > 200.0 {
        true => (ACROSS_X_400, ACROSS_Y_400),
        false => (ACROSS_X_100, ACROSS_Y_100),
    };
    let spacing = 1.0 / (particles.len().max(1) as f64).sqrt();
    let of = |at: [f64; 2], i: usize, value: f64| {
        let deviation = velocity(particles, spacing, at)[i] - value;
        deviation * deviation
    };
    let first = along_y.iter().map(|&(y, u)| of([0.5, y], 0, u));
    let second = along_x.iter().map(|&(x, v)| of([x, 0.5], 1, v));
    let count = (along_y.len() + along_x.len()) as f64;
    (first.chain(second).sum::<f64>() / count).sqrt()
}

/// The velocity at a point: that of the linear field that fits the particles around best, by squares
/// weighed with `exp(-|r|²/h²)`.
fn velocity(particles: &[Moving], spacing: f64, at: [f64; 2]) -> [f64; 2] {
    let (mut matrix, mut sums) = ([[0.0; 3]; 3], [[0.0; 2]; 3]);
    for (x, u) in particles {
        let r = [0, 1].map(|i| (x[i] - at[i]) / spacing);
        let squared = r[0] * r[0] + r[1] * r[1];
        if squared > 9.0 {
            continue;
        }
        let (weight, terms) = ((-squared).exp(), [1.0, r[0], r[1]]);
        for (row, a) in terms.iter().enumerate() {
            for (entry, b) in matrix[row].iter_mut().zip(terms) {
                *entry += weight * a * b;
            }
            for (sum, u) in sums[row].iter_mut().zip(u) {
                *sum += weight * a * u;
            }
        }
    }
    // From the last row up, so that the first one is left: the value at the point.
    for last in [2, 1] {
        for row in 0..last {
            let factor = matrix[row][last] / matrix[last][last];
            for column in 0..last {
                matrix[row][column] -= factor * matrix[last][column];
            }
            for i in 0..2 {
                sums[row][i] -= factor * sums[last][i];
            }
        }
    }
    sums[0].map(|sum| sum / matrix[0][0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_field_is_found_as_it_is() {
        let place = |i: usize| [(i % 20) as f64 / 20.0 + 0.01, (i / 20) as f64 / 20.0 + 0.03];
        let field = |x: [f64; 2]| [0.3 + x[0] - 2.0 * x[1], 0.1 + 0.5 * x[1]];
        let all: Vec<Moving> = (0..400).map(|i| (place(i), field(place(i)))).collect();
        for at in [[0.5, 0.97], [0.5, 0.5], [0.06, 0.5]] {
            let found = velocity(&all, 0.05, at);
            let exact = field(at);
            for (found, exact) in found.iter().zip(exact) {
                assert!((found - exact).abs() < 1e-12, "{found} for {exact}");
            }
        }
        // Gas at rest is off by all of the values.
        let still: Vec<Moving> = (0..400).map(|i| (place(i), [0.0; 2])).collect();
        let rms = |tables: [&[Value]; 2]| {
            let count = (tables[0].len() + tables[1].len()) as f64;
            let squares = tables.into_iter().flatten().map(|(_, value)| value * value);
            (squares.sum::<f64>() / count).sqrt()
        };
        let exact = rms([ACROSS_X_100, ACROSS_Y_100]);
        assert!((deviation(&still, 100.0) - exact).abs() < 1e-12);
        let exact = rms([ACROSS_X_400, ACROSS_Y_400]);
        assert!((deviation(&still, 400.0) - exact).abs() < 1e-12);
    }
}
