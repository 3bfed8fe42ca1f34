//! The elapsed time against its integral.

use super::*;

/// By Simpson's rule: error `2.3 h^4/180` times the fourth derivative, below 3e-11 (0.8 3^4).
#[test]
fn the_elapsed_time_is_the_integral() {
    for rate in [0.0, 1e-9, 3.0] {
        let swing = Modulation {
            amplitude: 0.8,
            rate,
        };
        let weight = |i: i32| if i % 2 == 1 { 4.0 } else { 2.0 };
        let sum = (1..1000).map(|i| weight(i) * swing.factor(2.3e-3 * f64::from(i)));
        let sum = sum.sum::<f64>() + swing.factor(0.0) + swing.factor(2.3);
        let error = swing.elapsed(2.3) - sum * 2.3e-3 / 3.0;
        assert!(error.abs() < 3e-11, "{rate}: {error:e}");
    }
}
