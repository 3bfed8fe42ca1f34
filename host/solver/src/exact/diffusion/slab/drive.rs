//! What is given at an end of a slab, as it changes in time, and how a mode follows it.

use super::super::super::linear::error::{SolutionError, check, finite};

/// Values joined by straight lines.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Times, each above the one before, and values. Before the first and after the last the
    /// value stays.
    pub points: Vec<(f64, f64)>,
}

/// Where `e^-x` is nothing: 3e-20.
const FADED: f64 = 45.0;

impl Drive {
    /// The same value always.
    pub fn constant(value: f64) -> Self {
        Self {
            points: vec![(0.0, value)],
        }
    }

    /// The value at a time.
    pub fn at(&self, time: f64) -> f64 {
        let after = self.points.partition_point(|(t, _)| *t <= time);
        let before = after.checked_sub(1).and_then(|i| self.points.get(i));
        match (before, self.points.get(after)) {
            (Some(&(t, u)), Some(&(next, v))) => u + (v - u) * ((time - t) / (next - t)),
            (Some((_, value)), None) | (None, Some((_, value))) => *value,
            (None, None) => 0.0,
        }
    }

    /// That there are points, at times that ascend, with lines that are not upright.
    pub(super) fn check(&self) -> Result<(), SolutionError> {
        let count = self.points.len() as f64;
        check(&[("number of points of a drive", count, "> 0", count > 0.0)])?;
        for (time, value) in &self.points {
            check(&[
                finite("time of a drive", *time),
                finite("value of a drive", *value),
            ])?;
        }
        for (slope, time, before) in self.lines() {
            let need = "above the one before";
            check(&[
                ("time of a drive", time, need, time > before),
                finite("slope of a drive", slope),
            ])?;
        }
        Ok(())
    }

    /// Slope, end and start of each line.
    fn lines(&self) -> impl Iterator<Item = (f64, f64, f64)> {
        let pairs = self.points.iter().zip(self.points.iter().skip(1));
        pairs.map(|((t, u), (next, v))| ((v - u) / (next - t), *next, *t))
    }
}

/// A line of a drive that is not level, after t = 0.
#[derive(Debug)]
struct Line {
    start: f64,
    end: f64,
    slope: f64,
}

/// g: a drive less a constant, from t = 0; before, g = 0.
#[derive(Debug)]
pub(super) struct Course {
    drive: Drive,
    less: f64,
    lines: Vec<Line>,
}

impl Course {
    pub(super) fn new(drive: Drive, less: f64) -> Self {
        let lines = drive.lines().map(|(slope, end, start)| Line {
            start: start.max(0.0),
            end,
            slope,
        });
        let there = |line: &Line| line.end > 0.0 && line.slope != 0.0;
        let lines = lines.filter(there).collect();
        Self { drive, less, lines }
    }

    /// g.
    pub(super) fn at(&self, time: f64) -> f64 {
        self.drive.at(time) - self.less
    }

    /// When g changes for the last time.
    pub(super) fn end(&self) -> f64 {
        self.lines.last().map_or(0.0, |line| line.end)
    }

    /// `g(0) e^(-rate t)`, what is left of the jump at t = 0.
    pub(super) fn start(&self, rate: f64, time: f64) -> f64 {
        self.at(0.0) * libm::exp(-rate * time)
    }

    /// `rate ∫_0^t g'(s) e^(-rate (t - s)) ds`, the slope of late; g'(t) for a fast rate.
    pub(super) fn slope(&self, rate: f64, time: f64) -> f64 {
        let begun = self.lines.partition_point(|line| line.start < time);
        let mut slope = 0.0;
        for line in self.lines[..begun].iter().rev() {
            let end = line.end.min(time);
            let since = rate * (time - end);
            if since > FADED {
                break;
            }
            // The difference of the exponentials of both ends.
            let gained = -libm::expm1(-rate * (end - line.start));
            slope += line.slope * libm::exp(-since) * gained;
        }
        slope
    }

    /// `∫_0^t g ds`.
    pub(super) fn integral(&self, time: f64) -> f64 {
        let inside = |t: &f64| 0.0 < *t && *t < time;
        let corners = self.drive.points.iter().map(|(t, _)| *t).filter(inside);
        let (mut sum, mut before) = (0.0, 0.0);
        for corner in corners.chain([time]) {
            sum += 0.5 * (corner - before) * (self.at(before) + self.at(corner));
            before = corner;
        }
        sum
    }
}
