//! The picture of a comparison: difference and error over the step of the format, both logarithmic.

use crate::precision::{Comparison, FormatRow, step};
use crate::report::figure::{EXACT, FigureError, PARTICLES};
use crate::report::log_log::{GREY, LogLog, Marks, Straight};
use crate::study::PowerLaw;

/// Draws the relative differences of the field, its relative errors where there is an exact solution,
/// the line through the differences in fixed point and the floor.
///
/// # Errors
/// The drawing library refuses.
pub fn picture(comparison: &Comparison) -> Result<String, FigureError> {
    let Comparison {
        scenario,
        field,
        reference,
        rounding,
        ..
    } = comparison;
    let marks = |label: String, color, value: &dyn Fn(&FormatRow) -> Option<f64>, named: bool| {
        let point = |row: &FormatRow| {
            let name = if named {
                row.scalar.clone()
            } else {
                String::new()
            };
            Some(((step(row.fraction_bits), value(row)?), name))
        };
        Marks {
            label,
            color,
            points: comparison.rows.iter().filter_map(point).collect(),
        }
    };
    let difference = |row: &FormatRow| row.difference(field)?.relative_l2;
    let error = |row: &FormatRow| row.relative_error(field, comparison.size);
    let mut groups = vec![marks(
        format!("difference from {reference}"),
        PARTICLES,
        &difference,
        true,
    )];
    let mut lines = Vec::new();
    if let Some((law, slope)) = rounding.line().zip(rounding.slope) {
        lines.push(Straight {
            law,
            label: format!("slope {slope:.2} a bit, fixed point"),
            color: GREY,
        });
    }
    if let Some(floor) = rounding.floor {
        groups.push(marks(
            "error, exact solution".to_owned(),
            EXACT,
            &error,
            false,
        ));
        lines.push(Straight {
            law: PowerLaw {
                factor: floor,
                exponent: 0.0,
            },
            label: format!("floor: the error of {reference}"),
            color: EXACT,
        });
    }
    LogLog {
        title: &format!("{scenario}: {field} in several number formats"),
        axes: ["step of the format at 1: 2^-bits", "relative, L2"],
        groups,
        lines,
    }
    .svg()
}
