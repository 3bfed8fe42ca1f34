//! What a comparison says, as tables and sentences.

use std::collections::BTreeMap;

use super::table::Table;
use crate::precision::{Comparison, FormatRow, Refusal, Rounding};

/// A number that may not be there.
fn told(number: Option<f64>, text: impl Fn(f64) -> String) -> String {
    number.map_or_else(|| "-".to_owned(), text)
}

/// Two digits of a number; 0 as such, where a sum is as it was to the bit.
fn small(number: f64) -> String {
    match number == 0.0 {
        true => "0".to_owned(),
        false => format!("{number:.1e}"),
    }
}

/// Four digits of a number.
fn digits(number: f64) -> String {
    format!("{number:.3e}")
}

/// What each format takes and loses of the field.
pub(super) fn formats(comparison: &Comparison) -> Table {
    let field = comparison.field.as_str();
    let heading = [
        "format",
        "range",
        "steps",
        "steps/s",
        "bytes",
        "error L1",
        "error L2",
        "difference L2",
        "bits kept",
    ];
    let row = |row: &FormatRow| {
        let ran = row.ran()?;
        let (error, difference) = (row.error(field), row.difference(field));
        Some(vec![
            row.scalar.clone(),
            ran.range.to_owned(),
            ran.steps.to_string(),
            format!("{:.0}", ran.steps_per_second),
            ran.bytes_per_particle.to_string(),
            told(error.map(|norms| norms.l1), digits),
            told(error.map(|norms| norms.l2), digits),
            told(difference.map(|norms| norms.l2), digits),
            told(difference.and_then(|norms| norms.bits), |bits| {
                format!("{bits:.1}")
            }),
        ])
    };
    Table {
        heading: heading.map(String::from).to_vec(),
        names: 2,
        rows: comparison.rows.iter().filter_map(row).collect(),
    }
}

/// The difference of every field from the reference; without rows where there is none.
pub(super) fn differences(comparison: &Comparison) -> Table {
    let heading = ["difference", "format", "L1", "L2", "Linf", "bits kept"];
    let ran = || comparison.rows.iter();
    let mut fields: Vec<&String> = ran()
        .filter_map(|row| row.ran()?.difference.as_ref())
        .flat_map(|all| all.keys())
        .collect();
    fields.sort();
    fields.dedup();
    let mut rows = Vec::new();
    for field in fields {
        for row in ran() {
            if let Some(norms) = row.difference(field) {
                rows.push(vec![
                    field.clone(),
                    row.scalar.clone(),
                    digits(norms.l1),
                    digits(norms.l2),
                    digits(norms.linf),
                    told(norms.bits, |bits| format!("{bits:.1}")),
                ]);
            }
        }
    }
    Table {
        heading: heading.map(String::from).to_vec(),
        names: 2,
        rows,
    }
}

/// The drift of each sum; without rows where there is none to tell.
pub(super) fn drifts(comparison: &Comparison) -> Table {
    let all = || {
        let ran = comparison
            .rows
            .iter()
            .filter_map(|row| Some((row, row.ran()?)));
        ran.filter_map(|(row, ran)| Some((&row.scalar, ran.drift.as_ref()?)))
    };
    let mut sums: Vec<&String> = all().flat_map(|(_, drift)| drift.keys()).collect();
    sums.sort();
    sums.dedup();
    let row = |(scalar, drift): (&String, &BTreeMap<String, f64>)| {
        let sums = sums.iter().map(|&sum| told(drift.get(sum).copied(), small));
        std::iter::once(scalar.clone()).chain(sums).collect()
    };
    let names = sums.iter().map(|sum| sum.replace('_', " "));
    Table {
        heading: std::iter::once("drift".to_owned()).chain(names).collect(),
        names: 1,
        rows: all().map(row).collect(),
    }
}

/// The formats without a run, with the reason and the cure.
pub(super) fn refusals(comparison: &Comparison) -> Vec<(&str, &Refusal)> {
    let rows = comparison.rows.iter();
    rows.filter_map(|row| Some((row.scalar.as_str(), row.refusal()?)))
        .collect()
}

/// What the line and the floor say, in sentences.
pub(super) fn conclusions(comparison: &Comparison) -> Vec<(&'static str, String)> {
    let Comparison {
        field, reference, ..
    } = comparison;
    let Rounding {
        formats,
        slope,
        off,
        floor,
        enough_bits,
        enough,
        ..
    } = &comparison.rounding;
    let mut all = Vec::new();
    if let Some((slope, off)) = slope.zip(*off) {
        all.push((
            "slope",
            format!(
                "{slope:.2} bits of difference a bit behind the point, over {}, which lie up to {off:.1} \
                 bits off the line",
                formats.join(", ")
            ),
        ));
    }
    let Some(floor) = floor else {
        return all;
    };
    all.push((
        "floor",
        format!("{floor:.3e}: the error of {reference} in {field} (L2, relative), which is that of the method"),
    ));
    if let Some(bits) = enough_bits {
        all.push((
            "rounding",
            format!(
                "below a tenth of the floor from {bits:.1} bits behind the point on, by the line"
            ),
        ));
    }
    let is_any = comparison
        .rows
        .iter()
        .any(|row| row.difference(field).is_some());
    if is_any {
        all.push((
            "enough",
            match enough.is_empty() {
                true => "none: all differences are above a tenth of the floor".to_owned(),
                false => format!(
                    "{}: differences below a tenth of the floor",
                    enough.join(", ")
                ),
            },
        ));
    }
    all
}

/// The first line.
pub(super) fn title(comparison: &Comparison) -> String {
    let Comparison {
        scenario,
        particles,
        time,
        field,
        reference,
        ..
    } = comparison;
    format!("{scenario}: {particles} particles at t = {time:?}, {field}, compared with {reference}")
}
