//! The picture of a convergence study: the error over the spacing, both logarithmic.

use crate::report::figure::{EXACT, FigureError, PARTICLES};
use crate::report::log_log::{GREY, LogLog, Marks, Straight};
use crate::study::{PowerLaw, Study};

/// Draws the measured errors, the line through them and one of a slope to compare with: that of
/// theory, else the whole number next to the measured one.
///
/// # Errors
/// The drawing library refuses.
pub(super) fn picture(title: &str, error: &str, study: &Study) -> Result<String, FigureError> {
    let levels = study.levels.iter();
    let points = levels.map(|level| ((level.h, level.error(study.norm)), String::new()));
    LogLog {
        title,
        axes: ["mean spacing h", error],
        groups: vec![Marks {
            label: "measured".to_owned(),
            color: PARTICLES,
            points: points.collect(),
        }],
        lines: lines(study),
    }
    .svg()
}

/// The line through the errors, and half of it below, at its middle, the one to compare with.
fn lines(study: &Study) -> Vec<Straight> {
    let Some(fit) = study.fit() else {
        return Vec::new();
    };
    let (slope, why) = match &study.theory {
        Some(theory) => (theory.predicted_order(), "predicted"),
        None => (fit.exponent.round().max(1.0), "to compare with"),
    };
    let logarithms = study.levels.iter().map(|level| level.h.ln());
    let middle = (logarithms.sum::<f64>() / study.levels.len() as f64).exp();
    let compared = PowerLaw {
        factor: 0.5 * fit.at(middle) / middle.powf(slope),
        exponent: slope,
    };
    let measured = format!("order {:.2}, least squares", fit.exponent);
    // 2, not 2.00; 1.46, not 1.4600000000000002.
    let slope = (100.0 * slope).round() / 100.0;
    vec![
        Straight {
            law: fit,
            label: measured,
            color: EXACT,
        },
        Straight {
            law: compared,
            label: format!("order {slope}, {why}"),
            color: GREY,
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::{ErrorNorm, Level, Theory};

    fn study(theory: Option<Theory>, error: impl Fn(f64) -> f64) -> Study {
        let level = |n: usize| {
            let h = 1.0 / n as f64;
            Ok::<_, ()>(Level {
                n,
                h,
                eps: h,
                l1: error(h),
                l2: error(h),
                linf: error(h),
            })
        };
        Study::run(&[32, 64, 128, 256], ErrorNorm::L2, theory, level).unwrap()
    }

    #[test]
    fn the_picture_holds_the_points_and_both_lines() {
        let theory = Theory {
            order_r: 2,
            smoothness: 5,
            theta: 0.73,
        };
        let text = picture("a < b", "error", &study(Some(theory), |h| h * h)).unwrap();
        assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"));
        assert_eq!(text.matches("<circle").count(), 4 + 1);
        for part in [
            "a &lt; b",
            "order 2.00, least",
            "order 1.46, predicted",
            "0.01",
            "mean spacing",
        ] {
            assert!(text.contains(part), "no {part:?}");
        }
        let text = picture("gas", "error", &study(None, |h| h.powf(0.9))).unwrap();
        assert!(text.contains("order 1, to compare with"));
    }

    #[test]
    fn errors_of_zero_and_without_number_are_left_out() {
        for bad in [0.0, f64::NAN, f64::INFINITY] {
            let some = study(None, |h| if h < 0.01 { bad } else { h });
            let text = picture("title", "error", &some).unwrap();
            assert_eq!(text.matches("<circle").count(), 2 + 1);
            assert!(!text.contains("NaN") && !text.contains("inf"));
            picture("title", "error", &study(None, |_| bad)).unwrap();
        }
    }
}
