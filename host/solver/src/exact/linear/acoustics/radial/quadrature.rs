//! Gauss and Legendre's rule.

use std::f64::consts::PI;

/// How many points: exact for polynomials of degree 31.
pub(super) const RULE: usize = 16;

/// Nodes in (-1, 1) and weights.
pub(super) fn gauss_legendre() -> [(f64, f64); RULE] {
    let n = RULE as f64;
    std::array::from_fn(|i| {
        // Close enough for Newton's method to converge to this root, in 5 steps.
        let mut x = libm::cos(PI * (i as f64 + 0.75) / (n + 0.5));
        for _ in 0..8 {
            let (value, slope) = legendre(x);
            x -= value / slope;
        }
        let (_, slope) = legendre(x);
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// The Legendre polynomial of degree [`RULE`] and its derivative.
fn legendre(x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=RULE {
        let k = k as f64;
        (before, value) = (
            value,
            ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k,
        );
    }
    let slope = RULE as f64 * (before - x * value) / (1.0 - x * x);
    (value, slope)
}

/// `∫ x^m dx = 2/(m+1)` for even m: to some roundings of sums of 16.
#[test]
fn polynomials_of_degree_31_are_integrated_exactly() {
    for m in 0..=31 {
        let terms = gauss_legendre().map(|(x, weight)| weight * x.powi(m));
        let expected = if m % 2 == 0 {
            2.0 / f64::from(m + 1)
        } else {
            0.0
        };
        let error = terms.iter().sum::<f64>() - expected;
        assert!(error.abs() < 2e-15, "x^{m}: {error:e}");
    }
}
