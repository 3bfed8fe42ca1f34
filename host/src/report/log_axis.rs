//! An axis whose numbers are logarithms.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::Ranged;

use super::figure::range;

/// Decades on an axis up to which all digits have a tick, and 1, 2 and 5.
const DENSE: f64 = 0.7;
const FEW: f64 = 2.5;

/// An axis of logarithms to the base 10.
pub(super) struct Axis(RangedCoordf64, Range<f64>);

impl Axis {
    /// That holds these logarithms, with a margin.
    pub(super) fn new(values: impl Iterator<Item = f64>) -> Self {
        let range = range(values, 0.06);
        Self(range.clone().into(), range)
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        self.0.map(value, limit)
    }

    /// Powers of ten; where these are few also other one-digit numbers.
    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        let range = &self.1;
        let span = range.end - range.start;
        let (first, last) = (range.start.floor() as i32, range.end.ceil() as i32);
        let digits: &[f64] = match span {
            ..DENSE => &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0],
            ..FEW => &[1.0, 2.0, 5.0],
            _ => &[1.0],
        };
        // Seven to twelve decades: every second one.
        let stride = (span / 6.0).ceil().max(1.0) as usize;
        let decades = (first..=last).step_by(stride);
        decades
            .flat_map(|decade| {
                digits
                    .iter()
                    .map(move |digit| f64::from(decade) + digit.log10())
            })
            .filter(|tick| range.contains(tick))
            .collect()
    }

    fn range(&self) -> Range<f64> {
        self.1.clone()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format(value: &f64) -> String {
        tick(*value)
    }
}

/// The number whose logarithm that is: ticks are at one-digit numbers.
fn tick(logarithm: f64) -> String {
    let decade = (logarithm + 1e-9).floor();
    let digit = 10f64.powf(logarithm - decade).round();
    if (-3.0..4.0).contains(&decade) {
        let decimals = (-decade).max(0.0) as usize;
        format!("{:.decimals$}", digit * 10f64.powf(decade))
    } else {
        format!("{digit}e{decade}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_one_digit_numbers() {
        for (value, expected) in [
            (0.001, "0.001"),
            (0.02, "0.02"),
            (0.5, "0.5"),
            (1.0, "1"),
            (2000.0, "2000"),
            (5e-4, "5e-4"),
            (1e-12, "1e-12"),
            (2e5, "2e5"),
        ] {
            assert_eq!(tick(f64::log10(value)), expected);
        }
    }
}
