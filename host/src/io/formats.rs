//! A comparison of number formats as a table.

use std::path::Path;

use super::table::{WriteError, whole};
use crate::precision::{Comparison, FormatOutcome, FormatRow};

/// Writes a row a format and field, the formats in their order; of a format without a run one row, with
/// the reason. What there is not stays empty.
///
/// # Errors
/// A file that cannot be written.
pub fn write_formats(path: &Path, comparison: &Comparison) -> Result<(), WriteError> {
    whole(path, |file| {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record([
            "scalar",
            "fraction_bits",
            "range",
            "steps",
            "seconds",
            "bytes_per_particle",
            "field",
            "error_l1",
            "error_l2",
            "error_linf",
            "difference_l1",
            "difference_l2",
            "difference_linf",
            "relative_l2",
            "bits",
            "refused",
        ])?;
        for row in &comparison.rows {
            for record in records(row) {
                writer.write_record(record)?;
            }
        }
        writer.flush()
    })
}

/// The rows of a format.
fn records(row: &FormatRow) -> Vec<Vec<String>> {
    let head = [row.scalar.clone(), row.fraction_bits.to_string()];
    let ran = match &row.outcome {
        FormatOutcome::Ran(ran) => ran,
        FormatOutcome::Refused(refusal) => {
            let empty = std::iter::repeat_n(String::new(), 13);
            let reason = std::iter::once(refusal.refused.clone());
            return vec![head.into_iter().chain(empty).chain(reason).collect()];
        }
    };
    let errors = ran.errors.iter().flat_map(|errors| errors.keys());
    let differences = ran.difference.iter().flat_map(|all| all.keys());
    let mut fields: Vec<&str> = errors.chain(differences).map(String::as_str).collect();
    fields.sort_unstable();
    fields.dedup();
    if fields.is_empty() {
        fields.push("");
    }
    let number = |x: Option<f64>| {
        x.filter(|x| x.is_finite())
            .map_or(String::new(), |x| x.to_string())
    };
    let record = |field: &str| {
        let (error, difference) = (row.error(field), row.difference(field));
        let mut record = head.to_vec();
        record.extend([
            ran.range.to_owned(),
            ran.steps.to_string(),
            number(Some(ran.seconds)),
            ran.bytes_per_particle.to_string(),
            field.to_owned(),
        ]);
        record.extend([
            number(error.map(|norms| norms.l1)),
            number(error.map(|norms| norms.l2)),
            number(error.map(|norms| norms.linf)),
            number(difference.map(|norms| norms.l1)),
            number(difference.map(|norms| norms.l2)),
            number(difference.map(|norms| norms.linf)),
            number(difference.and_then(|norms| norms.relative_l2)),
            number(difference.and_then(|norms| norms.bits)),
            String::new(),
        ]);
        record
    };
    fields.into_iter().map(record).collect()
}
