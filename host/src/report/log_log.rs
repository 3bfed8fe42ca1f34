//! A picture of points and straight lines over two logarithmic axes.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::figure::{Canvas, FONT, FigureError, GRID, INK, UNIT, svg};
use super::log_axis::Axis;
use crate::study::PowerLaw;

/// Width and height, and height of the title and the legend, in pixels.
const SIZE: (u32, u32) = (560, 460);
const HEAD: u32 = 84;

pub(super) const GREY: RGBColor = RGBColor(120, 120, 120);

/// A picture: up to two groups of points and two lines.
pub(super) struct LogLog<'a> {
    /// Its title.
    pub title: &'a str,
    /// What the axes are called, x first.
    pub axes: [&'a str; 2],
    /// Points; those that are not above 0 and finite are left out.
    pub groups: Vec<Marks>,
    /// Lines.
    pub lines: Vec<Straight>,
}

/// Points of one kind.
pub(super) struct Marks {
    /// What the legend calls them.
    pub label: String,
    /// Their colour.
    pub color: RGBColor,
    /// Places, and what stands beside each; nothing where that is empty.
    pub points: Vec<((f64, f64), String)>,
}

/// A straight line from the smallest to the largest x of the points.
pub(super) struct Straight {
    /// Where it runs.
    pub law: PowerLaw,
    /// What the legend calls it.
    pub label: String,
    /// Its colour.
    pub color: RGBColor,
}

impl LogLog<'_> {
    /// Draws it; SVG text.
    ///
    /// # Errors
    /// The drawing library refuses.
    pub(super) fn svg(mut self) -> Result<String, FigureError> {
        let usable = |x: f64| x > 0.0 && x.is_finite();
        for group in &mut self.groups {
            let points = &mut group.points;
            points.retain(|((x, y), _)| usable(*x) && usable(*y));
        }
        svg(SIZE, |canvas| {
            let (head, body) = canvas.split_vertically(HEAD * UNIT.unsigned_abs());
            self.head(&head)?;
            self.chart(&body)
        })
    }

    fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        let points = self.groups.iter().flat_map(|group| &group.points);
        points.map(|(point, _)| *point)
    }

    /// The ends of a line.
    fn curve(&self, line: &Straight) -> [(f64, f64); 2] {
        let (first, last) = self
            .points()
            .fold((f64::INFINITY, 0.0), |(lower, upper), (x, _)| {
                (f64::min(lower, x), f64::max(upper, x))
            });
        [first, last].map(|x| (x, line.law.at(x)))
    }

    /// The title, and what points and lines mean.
    fn head(&self, head: &Canvas<'_>) -> Result<(), FigureError> {
        let px = |pixels: i32| pixels * UNIT;
        let title = self.title.to_owned();
        head.draw(&Text::new(title, (px(18), px(22)), style(16)))?;
        let row = |row: usize| px(50 + 20 * row as i32);
        let longest = self.groups.iter().map(|group| group.label.len()).max();
        for (place, group) in self.groups.iter().enumerate() {
            let y = row(place);
            head.draw(&Circle::new((px(28), y), px(4), group.color.filled()))?;
            head.draw(&Text::new(group.label.clone(), (px(45), y), style(13)))?;
        }
        // Below each other: the widths of letters are not known here.
        let x = px((60 + 7 * longest.unwrap_or(0) as i32).max(150));
        for (place, line) in self.lines.iter().enumerate() {
            let y = row(place);
            let stroke = line.color.stroke_width(2 * UNIT.unsigned_abs());
            head.draw(&PathElement::new(vec![(x, y), (x + px(20), y)], stroke))?;
            head.draw(&Text::new(line.label.clone(), (x + px(27), y), style(13)))?;
        }
        Ok(())
    }

    fn chart(&self, area: &Canvas<'_>) -> Result<(), FigureError> {
        let log = |(x, y): (f64, f64)| (x.log10(), y.log10());
        let ends = self.lines.iter().flat_map(|line| self.curve(line));
        // Of no points a line has no ends.
        let ends = ends.filter(|(x, _)| x.is_finite() && *x > 0.0);
        let seen: Vec<_> = self.points().chain(ends).map(log).collect();
        let named = self.groups.iter().flat_map(|group| &group.points);
        let is_named = named.clone().any(|(_, name)| !name.is_empty());
        let abscissas = seen.iter().map(|point| point.0);
        // Room for the name of the last.
        let last = abscissas.clone().fold(f64::NEG_INFINITY, f64::max);
        let room = (is_named && last.is_finite()).then(|| {
            let first = abscissas.clone().fold(f64::INFINITY, f64::min);
            last + 0.12 * (last - first)
        });
        let font = |size: i32| (FONT, size * UNIT).into_font().color(&INK);
        let mut chart = ChartBuilder::on(area)
            .margin(8 * UNIT)
            .margin_bottom(12 * UNIT)
            .margin_right(18 * UNIT)
            .x_label_area_size(42 * UNIT)
            .y_label_area_size(64 * UNIT)
            .build_cartesian_2d(
                Axis::new(abscissas.chain(room)),
                Axis::new(seen.iter().map(|point| point.1)),
            )?;
        chart
            .configure_mesh()
            .max_light_lines(0)
            .bold_line_style(GRID.stroke_width(UNIT.unsigned_abs()))
            .axis_style(INK.stroke_width(UNIT.unsigned_abs()))
            .label_style(font(12))
            .axis_desc_style(font(13))
            .x_desc(self.axes[0])
            .y_desc(self.axes[1])
            .set_all_tick_mark_size(4 * UNIT)
            .draw()?;
        for line in &self.lines {
            let stroke = line.color.stroke_width(3 * UNIT.unsigned_abs() / 2);
            chart.draw_series(LineSeries::new(self.curve(line).map(log), stroke))?;
        }
        for group in &self.groups {
            let places = group.points.iter();
            let dot = |(point, _): &((f64, f64), String)| {
                Circle::new(log(*point), 4 * UNIT, group.color.filled())
            };
            chart.draw_series(places.clone().map(dot))?;
            let named = places.filter(|(_, name)| !name.is_empty());
            chart.draw_series(named.map(|(point, name)| {
                EmptyElement::at(log(*point))
                    + Text::new(name.clone(), (7 * UNIT, -7 * UNIT), style(11))
            }))?;
        }
        Ok(())
    }
}

fn style(size: i32) -> TextStyle<'static> {
    let middle = Pos::new(HPos::Left, VPos::Center);
    let font = (FONT, size * UNIT).into_font();
    TextStyle::from(font).color(&INK).pos(middle)
}
