//! The picture of a convergence study: the error over the spacing, both logarithmic.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::figure::{Canvas, EXACT, FONT, FigureError, GRID, INK, PARTICLES, UNIT, svg};
use super::log_axis::Axis;
use crate::study::{PowerLaw, Study};

/// Width and height, and height of the title and the legend, in pixels.
const SIZE: (u32, u32) = (560, 460);
const HEAD: u32 = 84;

const GREY: RGBColor = RGBColor(120, 120, 120);

/// Draws the measured errors, the line through them and one of a slope to compare with: that of
/// theory, else the whole number next to the measured one.
///
/// # Errors
/// The drawing library refuses.
pub(super) fn picture(title: &str, error: &str, study: &Study) -> Result<String, FigureError> {
    let points: Vec<(f64, f64)> = study
        .levels
        .iter()
        .map(|level| (level.h, level.error(study.norm)))
        .filter(|&(h, error)| h > 0.0 && h.is_finite() && error > 0.0 && error.is_finite())
        .collect();
    let lines = lines(study);
    let ends = ends(&points);
    let curves: Vec<Curve<'_>> = lines.iter().map(|line| line.curve(ends)).collect();
    svg(SIZE, |canvas| {
        let (head, body) = canvas.split_vertically(HEAD * UNIT.unsigned_abs());
        draw_head(&head, title, &lines)?;
        draw_chart(&body, error, &points, &curves)
    })
}

/// A straight line of the picture.
struct Line {
    law: PowerLaw,
    label: String,
    color: RGBColor,
}

struct Curve<'a> {
    ends: [(f64, f64); 2],
    line: &'a Line,
}

impl Line {
    /// From the smallest to the largest h.
    fn curve(&self, (first, last): (f64, f64)) -> Curve<'_> {
        Curve {
            ends: [first, last].map(|h| (h, self.law.at(h))),
            line: self,
        }
    }
}

/// The line through the errors, and half of it below, at its middle, the one to compare with.
fn lines(study: &Study) -> Vec<Line> {
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
        Line {
            law: fit,
            label: measured,
            color: EXACT,
        },
        Line {
            law: compared,
            label: format!("order {slope}, {why}"),
            color: GREY,
        },
    ]
}

fn ends(points: &[(f64, f64)]) -> (f64, f64) {
    let places = points.iter().map(|point| point.0);
    places.fold((f64::INFINITY, 0.0), |(lower, upper), h| {
        (f64::min(lower, h), f64::max(upper, h))
    })
}

fn style(size: i32) -> TextStyle<'static> {
    let middle = Pos::new(HPos::Left, VPos::Center);
    let font = (FONT, size * UNIT).into_font();
    TextStyle::from(font).color(&INK).pos(middle)
}

/// The title, and what points and lines mean.
fn draw_head(head: &Canvas<'_>, title: &str, lines: &[Line]) -> Result<(), FigureError> {
    let px = |pixels: i32| pixels * UNIT;
    head.draw(&Text::new(title.to_owned(), (px(18), px(22)), style(16)))?;
    let y = px(50);
    head.draw(&Circle::new((px(28), y), px(4), PARTICLES.filled()))?;
    head.draw(&Text::new("measured", (px(45), y), style(13)))?;
    // Below each other: the widths of letters are not known here.
    for (row, line) in lines.iter().enumerate() {
        let (x, y) = (px(150), px(50 + 20 * row as i32));
        let stroke = line.color.stroke_width(2 * UNIT.unsigned_abs());
        head.draw(&PathElement::new(vec![(x, y), (x + px(20), y)], stroke))?;
        head.draw(&Text::new(line.label.clone(), (x + px(27), y), style(13)))?;
    }
    Ok(())
}

fn draw_chart(
    area: &Canvas<'_>,
    error: &str,
    points: &[(f64, f64)],
    curves: &[Curve<'_>],
) -> Result<(), FigureError> {
    let log = |(h, error): &(f64, f64)| (h.log10(), error.log10());
    let corners = || curves.iter().flat_map(|curve| &curve.ends);
    let seen = || points.iter().chain(corners()).map(log);
    let font = |size: i32| (FONT, size * UNIT).into_font().color(&INK);
    let mut chart = ChartBuilder::on(area)
        .margin(8 * UNIT)
        .margin_bottom(12 * UNIT)
        .margin_right(18 * UNIT)
        .x_label_area_size(42 * UNIT)
        .y_label_area_size(64 * UNIT)
        .build_cartesian_2d(
            Axis::new(seen().map(|point| point.0)),
            Axis::new(seen().map(|point| point.1)),
        )?;
    chart
        .configure_mesh()
        .max_light_lines(0)
        .bold_line_style(GRID.stroke_width(UNIT.unsigned_abs()))
        .axis_style(INK.stroke_width(UNIT.unsigned_abs()))
        .label_style(font(12))
        .axis_desc_style(font(13))
        .x_desc("mean spacing h")
        .y_desc(error)
        .set_all_tick_mark_size(4 * UNIT)
        .draw()?;
    for curve in curves {
        let stroke = curve.line.color.stroke_width(3 * UNIT.unsigned_abs() / 2);
        chart.draw_series(LineSeries::new(curve.ends.iter().map(log), stroke))?;
    }
    let dot = |point| Circle::new(log(point), 4 * UNIT, PARTICLES.filled());
    chart.draw_series(points.iter().map(dot))?;
    Ok(())
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
