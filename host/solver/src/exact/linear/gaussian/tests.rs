//! The sum of images against Poisson's formula, and its period.

use super::*;
use std::f64::consts::PI;

/// `w sqrt(pi)/P (1 + 2 Σ_m exp(-(pi m w/P)^2) cos(2 pi m d/P))`: the same sum by Fourier series.
#[test]
fn the_sum_of_images_is_the_fourier_series() {
    for width in [0.05, 0.3, 1.0, 7.0, 100.0] {
        for i in -10..10 {
            let distance = 0.37 * f64::from(i);
            let term = |m: i32| {
                let turn = PI * f64::from(m);
                2.0 * (-(turn * width).powi(2)).exp() * (2.0 * turn * distance).cos()
            };
            let series = 1.0 + (1..60).map(term).sum::<f64>();
            let expected = width * PI.sqrt() * series;
            let sum = gaussian(distance, width, Some(1.0));
            // Up to 1300 terms, whose rounding adds up to some 1e-14 of the sum.
            assert!(
                (sum - expected).abs() < 2e-14 * width.max(1.0),
                "width {width}, distance {distance}: {sum} against {expected}"
            );
        }
    }
}

#[test]
fn a_period_far_off_changes_nothing() {
    for i in 0..10 {
        let distance = 0.2 * f64::from(i);
        assert_eq!(
            gaussian(distance, 0.5, Some(20.0)),
            gaussian(distance, 0.5, None)
        );
    }
}
