//! Pictures of a result as SVG: particles as points, the exact solution as a
//! line, one panel for each quantity.

use miette::Diagnostic;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use thiserror::Error;

/// One quantity over x.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Panel {
    /// The quantity, with its unit.
    pub heading: String,
    /// Particles, (x, value); those that are not finite are left out.
    pub points: Vec<(f64, f64)>,
    /// The exact solution, (x, value) in ascending x; may be empty.
    pub curve: Vec<(f64, f64)>,
    /// More lines with names of their own, each in its colour.
    pub lines: Vec<Line>,
    /// Of how many particles each point is one; 0 and 1: of itself.
    pub stride: usize,
    /// The smallest and the largest (x, value) of all particles, where `points` are not all.
    pub bounds: Option<[(f64, f64); 2]>,
}

/// A line with a name.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Line {
    /// What the legend calls it.
    pub name: String,
    /// (x, value) in ascending x.
    pub points: Vec<(f64, f64)>,
}

impl Panel {
    /// Makes room for a point that may not be drawn.
    pub fn reach(&mut self, (x, y): (f64, f64)) {
        if x.is_finite() && y.is_finite() {
            let [lower, upper] = self.bounds.unwrap_or([(x, y); 2]);
            let (lower, upper) = (
                (lower.0.min(x), lower.1.min(y)),
                (upper.0.max(x), upper.1.max(y)),
            );
            self.bounds = Some([lower, upper]);
        }
    }

    /// The largest `|value|` of all particles that [`Panel::reach`] was called for.
    pub fn largest(&self) -> f64 {
        let values = self.bounds.iter().flatten().map(|(_, y)| y.abs());
        values.fold(0.0, f64::max)
    }
}

/// Why there is no picture.
#[derive(Debug, Error, Diagnostic)]
pub enum FigureError {
    /// Fewer or more panels than a picture holds.
    #[error("{count} panels do not fit a picture")]
    #[diagnostic(help("give 1 to {MOST_PANELS}"))]
    PanelCount {
        /// How many there are.
        count: usize,
    },
    /// Fewer or more maps than a picture holds.
    #[error("{count} maps do not fit a picture")]
    #[diagnostic(help("give 1 to 4"))]
    MapCount {
        /// How many there are.
        count: usize,
    },
    /// A map without cells, or with others than its sides say.
    #[error("the map {heading:?} has {cells} cells for {nx} x {ny}")]
    CellCount {
        /// Its heading.
        heading: String,
        /// The cells it has.
        cells: usize,
        /// Cells in x.
        nx: usize,
        /// Cells in y.
        ny: usize,
    },
    /// A map that covers nothing.
    #[error("the map {heading:?} from {lower:?} to {upper:?} is empty: need lower < upper")]
    Bounds {
        /// Its heading.
        heading: String,
        /// Its lower corner.
        lower: [f64; 2],
        /// Its upper corner.
        upper: [f64; 2],
    },
    /// The drawing library refused.
    #[error("cannot draw the picture")]
    Drawing(#[from] DrawingAreaErrorKind<std::io::Error>),
}

pub(super) const MOST_PANELS: usize = 6;

/// Canvas units per pixel of the picture: the drawing library rounds to whole
/// units, and lines of whole pixels would show steps.
pub(super) const UNIT: i32 = 4;

/// Width and height of a panel, in pixels.
const PANEL: (u32, u32) = (440, 300);

/// Height of the title and the legend, in pixels.
const HEAD: u32 = 80;

/// Points drawn in a panel at most, some 100 bytes each; of more, every second,
/// third ... is drawn.
pub(super) const MOST_POINTS: usize = 1500;

// Blue and vermilion of Okabe and Ito (2008), told apart by all kinds of colour vision.
pub(super) const PARTICLES: RGBColor = RGBColor(0, 114, 178);
pub(super) const EXACT: RGBColor = RGBColor(213, 94, 0);
// And sky blue, bluish green and black of the same.
const LINES: [RGBColor; 3] = [
    RGBColor(86, 180, 233),
    RGBColor(0, 158, 115),
    RGBColor(0, 0, 0),
];
pub(super) const INK: RGBColor = RGBColor(51, 51, 51);
pub(super) const GRID: RGBColor = RGBColor(225, 225, 225);

/// Radius of a particle, in canvas units: 1.5 pixels.
const RADIUS: i32 = 3 * UNIT / 2;

pub(super) const FONT: &str = "sans-serif";

pub(super) type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Draws 1 to 6 panels, two beside each other; a second line of the title is smaller. Returns the picture as SVG text.
///
/// # Errors
/// Another number of panels.
pub fn panels(title: &str, x_label: &str, panels: &[Panel]) -> Result<String, FigureError> {
    legended(title, x_label, ["particles", "exact"], panels)
}

/// The same with what the points and the lines are.
///
/// # Errors
/// Another number of panels.
pub fn legended(
    title: &str,
    x_label: &str,
    legend: [&str; 2],
    panels: &[Panel],
) -> Result<String, FigureError> {
    let count = panels.len();
    if !(1..=MOST_PANELS).contains(&count) {
        return Err(FigureError::PanelCount { count });
    }
    let columns = count.min(2);
    let rows = count.div_ceil(columns);
    let (width, height) = (PANEL.0 * columns as u32, HEAD + PANEL.1 * rows as u32);
    let panels: Vec<Panel> = panels.iter().map(finite).collect();
    let most = panels.iter().map(|panel| panel.points.len()).max();
    let stride = most.unwrap_or(0).div_ceil(MOST_POINTS).max(1);
    svg((width, height), |canvas| {
        let (head, body) = canvas.split_vertically(HEAD * UNIT.unsigned_abs());
        draw_head(&head, (title, legend), &panels, stride)?;
        let x_range = range(panels.iter().flat_map(all).map(|(x, _)| x), 0.02);
        for (index, area) in body
            .split_evenly((rows, columns))
            .iter()
            .take(count)
            .enumerate()
        {
            let lowest = index + columns >= count;
            let label = if lowest { x_label } else { "" };
            draw_panel(area, x_range.clone(), label, &panels[index], stride)?;
        }
        Ok(())
    })
}

/// The SVG text of a white picture of that width and height in pixels that `draw` fills.
pub(super) fn svg(
    (width, height): (u32, u32),
    draw: impl FnOnce(&Canvas<'_>) -> Result<(), FigureError>,
) -> Result<String, FigureError> {
    let unit = UNIT.unsigned_abs();
    let mut text = String::new();
    {
        let size = (width * unit, height * unit);
        let canvas = SVGBackend::with_string(&mut text, size).into_drawing_area();
        canvas.fill(&WHITE)?;
        draw(&canvas)?;
        canvas.present()?;
    }
    // The size on screen; the canvas keeps its finer units in `viewBox`.
    let canvas_size = format!("width=\"{}\" height=\"{}\"", width * unit, height * unit);
    let screen_size = format!("width=\"{width}\" height=\"{height}\"");
    Ok(text.replacen(&canvas_size, &screen_size, 1))
}

/// The title, and what points and line mean.
fn draw_head(
    head: &Canvas<'_>,
    (title, legend): (&str, [&str; 2]),
    panels: &[Panel],
    stride: usize,
) -> Result<(), FigureError> {
    let [points, line] = legend;
    let px = |pixels: i32| pixels * UNIT;
    let style = |size: i32| {
        let middle = Pos::new(HPos::Left, VPos::Center);
        TextStyle::from((FONT, px(size)).into_font())
            .color(&INK)
            .pos(middle)
    };
    let (mut x, y) = (px(18), px(66));
    let (first, second) = title.split_once('\n').unwrap_or((title, ""));
    head.draw(&Text::new(first.to_owned(), (x, px(22)), style(18)))?;
    if !second.is_empty() {
        head.draw(&Text::new(second.to_owned(), (x, px(43)), style(12)))?;
    }
    if panels.iter().any(|panel| !panel.points.is_empty()) {
        let before = panels.iter().map(|panel| panel.stride).max();
        let label = match stride * before.unwrap_or(1).max(1) {
            1 => points.to_owned(),
            stride => format!("{points} (1 in {stride})"),
        };
        head.draw(&Circle::new((x + px(6), y), px(3), PARTICLES.filled()))?;
        head.draw(&Text::new(label.clone(), (x + px(16), y), style(13)))?;
        // About 7 pixels a letter, and a gap.
        x += px(16 + 7 * label.len() as i32 + 24);
    }
    if panels.iter().any(|panel| !panel.curve.is_empty()) {
        let stroke = vec![(x, y), (x + px(20), y)];
        head.draw(&PathElement::new(
            stroke,
            EXACT.stroke_width(2 * UNIT.unsigned_abs()),
        ))?;
        head.draw(&Text::new(line.to_owned(), (x + px(27), y), style(13)))?;
        x += px(27 + 7 * line.len() as i32 + 20);
    }
    let lines = panels.iter().map(|panel| &panel.lines);
    let most = lines.max_by_key(|lines| lines.len());
    for (line, colour) in most.into_iter().flatten().zip(LINES) {
        let stroke = vec![(x, y), (x + px(20), y)];
        let style_of_line = colour.stroke_width(2 * UNIT.unsigned_abs());
        head.draw(&PathElement::new(stroke, style_of_line))?;
        head.draw(&Text::new(line.name.clone(), (x + px(27), y), style(13)))?;
        x += px(27 + 7 * line.name.len() as i32 + 20);
    }
    Ok(())
}

/// Axes, grid, points and line of one panel.
fn draw_panel(
    area: &Canvas<'_>,
    x_range: std::ops::Range<f64>,
    x_label: &str,
    panel: &Panel,
    stride: usize,
) -> Result<(), FigureError> {
    let y_range = range(all(panel).map(|(_, y)| y), 0.07);
    let font = |size: i32| (FONT, size * UNIT).into_font().color(&INK);
    let mut chart = ChartBuilder::on(area)
        .caption(&panel.heading, font(14))
        .margin(8 * UNIT)
        .margin_bottom(12 * UNIT)
        .margin_right(18 * UNIT)
        .x_label_area_size(42 * UNIT)
        .y_label_area_size(58 * UNIT)
        .build_cartesian_2d(x_range.clone(), y_range.clone())?;
    chart
        .configure_mesh()
        .max_light_lines(0)
        .bold_line_style(GRID.stroke_width(UNIT.unsigned_abs()))
        .axis_style(INK.stroke_width(UNIT.unsigned_abs()))
        .label_style(font(12))
        .axis_desc_style(font(13))
        .x_labels(6)
        .y_labels(6)
        .x_label_formatter(&|x| tick(*x, &x_range))
        .y_label_formatter(&|y| tick(*y, &y_range))
        .x_desc(x_label)
        .set_all_tick_mark_size(4 * UNIT)
        .draw()?;
    let points = panel.points.iter().step_by(stride);
    chart.draw_series(points.map(|&point| Circle::new(point, RADIUS, PARTICLES.filled())))?;
    for (line, colour) in panel.lines.iter().zip(LINES) {
        let style = colour.stroke_width(3 * UNIT.unsigned_abs() / 2);
        chart.draw_series(LineSeries::new(line.points.iter().copied(), style))?;
    }
    if !panel.curve.is_empty() {
        let style = EXACT.stroke_width(3 * UNIT.unsigned_abs() / 2);
        chart.draw_series(LineSeries::new(panel.curve.iter().copied(), style))?;
    }
    Ok(())
}

/// The panel without the points that are not finite.
fn finite(panel: &Panel) -> Panel {
    let finite = |points: &[(f64, f64)]| {
        let points = points.iter().copied();
        points
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .collect()
    };
    Panel {
        heading: panel.heading.clone(),
        points: finite(&panel.points),
        curve: finite(&panel.curve),
        lines: (panel.lines.iter())
            .map(|line| Line {
                name: line.name.clone(),
                points: finite(&line.points),
            })
            .collect(),
        ..*panel
    }
}

fn all(panel: &Panel) -> impl Iterator<Item = (f64, f64)> {
    let lines = panel.lines.iter().flat_map(|line| &line.points);
    let drawn = panel.points.iter().chain(&panel.curve).chain(lines);
    drawn.chain(panel.bounds.iter().flatten()).copied()
}

/// An axis that holds all values with a margin on both sides, given as a part of
/// their span. Values that differ by less than a billionth count as equal.
pub(super) fn range(values: impl Iterator<Item = f64>, margin: f64) -> std::ops::Range<f64> {
    let (lower, upper) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, u), value| {
        (l.min(value), u.max(value))
    });
    if lower > upper {
        return 0.0..1.0;
    }
    let size = lower.abs().max(upper.abs());
    let span = upper - lower;
    let margin = if span > 1e-9 * size {
        margin * span
    } else if size > 0.0 {
        0.1 * size
    } else {
        1.0
    };
    lower - margin..upper + margin
}

/// A number at a tick, with the digits that tell it from its neighbours.
pub(super) fn tick(value: f64, range: &std::ops::Range<f64>) -> String {
    let step = (range.end - range.start) / 6.0;
    let size = range.start.abs().max(range.end.abs());
    if value.abs() < 1e-6 * step {
        return "0".to_owned();
    }
    if size >= 1e5 || step < 1e-4 {
        let digits = (value.abs() / step).log10().ceil().clamp(0.0, 9.0);
        return format!("{value:.*e}", digits as usize);
    }
    let decimals = (-step.log10()).ceil().max(0.0);
    format!("{value:.*}", decimals as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(heading: &str, count: usize) -> Panel {
        let x = |k: usize| k as f64 / count as f64 - 0.5;
        Panel {
            heading: heading.to_owned(),
            points: (0..count).map(|k| (x(k), x(k).sin())).collect(),
            curve: (0..200).map(|k| (k as f64 / 200.0 - 0.5, 0.1)).collect(),
            ..Panel::default()
        }
    }

    fn circles(text: &str) -> usize {
        text.matches("<circle").count()
    }

    #[test]
    fn the_picture_is_whole_and_holds_headings_and_all_points() {
        let headings = [
            "density",
            "velocity",
            "pressure < 1 & more",
            "internal energy",
        ];
        let four: Vec<Panel> = headings.iter().map(|heading| panel(heading, 900)).collect();
        let text = panels("sod at t = 0.2", "x", &four).unwrap();
        assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"));
        for part in [
            "density",
            "velocity",
            "pressure &lt; 1 &amp; more",
            "sod at t = 0.2",
            "exact",
        ] {
            assert!(text.contains(part), "no {part:?}");
        }
        assert_eq!(
            circles(&text),
            4 * 900 + 1,
            "the points, and one in the legend"
        );
        assert!(text.len() < 500_000, "{} bytes", text.len());
    }

    #[test]
    fn what_is_not_finite_is_left_out() {
        let mut panel = panel("density", 10);
        panel.points.push((f64::NAN, 1.0));
        panel.points.push((0.0, f64::INFINITY));
        panel.curve.push((0.0, f64::NEG_INFINITY));
        let text = panels("title", "x", &[panel]).unwrap();
        assert_eq!(circles(&text), 10 + 1);
        assert!(!text.contains("NaN") && !text.contains("inf"));
    }

    #[test]
    fn empty_and_constant_panels_are_drawn() {
        let empty = Panel {
            heading: "empty".to_owned(),
            ..Panel::default()
        };
        let constant = |value: f64| Panel {
            points: vec![(0.0, value), (1.0, value * (1.0 + 1e-15))],
            ..empty.clone()
        };
        let all = [
            empty.clone(),
            constant(0.0),
            constant(3.0),
            constant(-1e-300),
        ];
        let text = panels("title", "x", &all).unwrap();
        assert_eq!(circles(&text), 6 + 1);
        assert!(!text.contains("exact"));
        assert!(!panels("t", "x", &[empty]).unwrap().contains("particles"));
    }

    #[test]
    fn very_many_points_are_thinned_and_the_legend_says_so() {
        let text = panels("title", "x", &[panel("density", 3 * MOST_POINTS)]).unwrap();
        assert_eq!(circles(&text), MOST_POINTS + 1);
        assert!(text.contains("particles (1 in 3)"));
    }

    #[test]
    fn no_panels_and_too_many_are_refused() {
        for count in [0, 7] {
            let some = vec![panel("density", 2); count];
            let error = panels("title", "x", &some).unwrap_err();
            assert!(error.to_string().starts_with(&format!("{count} panels")));
        }
        for count in 1..=6 {
            let some = vec![panel("density", 2); count];
            assert_eq!(
                circles(&panels("title", "x", &some).unwrap()),
                2 * count + 1
            );
        }
    }

    #[test]
    fn ticks_have_the_digits_that_tell_them_apart() {
        for (value, range, expected) in [
            (0.5, -0.5..0.5, "0.5"),
            (-0.0, -0.5..0.5, "0"),
            (0.30000000000000004, 0.0..0.6, "0.3"),
            (0.95, 0.9..1.1, "0.95"),
            (12.0, 0.0..60.0, "12"),
            (200000.0, 0.0..600000.0, "2.0e5"),
            (2e-6, 0.0..6e-6, "2.0e-6"),
        ] {
            assert_eq!(tick(value, &range), expected);
        }
    }
}
