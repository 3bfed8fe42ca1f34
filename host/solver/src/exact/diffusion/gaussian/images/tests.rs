//! Both sums against the plain one.

use super::*;

/// Both ways of summing against the plain sum of all images within 12 periods, with what
/// is correlated, before and after the change from one to the other.
#[test]
fn the_sum_of_images_is_the_plain_sum() {
    for periods in [[Some(1.0), None], [None, Some(0.9)], [Some(1.0), Some(0.9)]] {
        for size in [0.01, 0.1, 0.15, 0.3, 1.0] {
            let [xx, xy, yy] = [1.2 * size, 0.5 * size, 0.7 * size];
            let images = Images {
                dimension: 2,
                covariance: [[xx, xy, 0.0], [xy, yy, 0.0], [0.0; 3]],
                periods: [periods[0], periods[1], None],
            };
            let determinant = xx * yy - xy * xy;
            for (x, y) in [(0.1, 0.2), (-0.4, 0.45), (7.3, -0.2)] {
                let reach = |period: Option<f64>| if period.is_some() { 20 } else { 0 };
                let mut plain = 0.0;
                for i in -reach(periods[0])..=reach(periods[0]) {
                    for j in -reach(periods[1])..=reach(periods[1]) {
                        let x = x + f64::from(i) * periods[0].unwrap_or(0.0);
                        let y = y + f64::from(j) * periods[1].unwrap_or(0.0);
                        let square = yy * x * x - 2.0 * xy * x * y + xx * y * y;
                        plain += libm::exp(-0.5 * square / determinant);
                    }
                }
                let expected = plain * 0.3 * 0.3 / determinant.sqrt();
                let sum = images.sum([x, y, 0.0], 0.3);
                let error = (sum - expected).abs();
                assert!(error < 1e-14 * (1.0 + expected), "{size}: {sum} {expected}");
            }
        }
    }
}
