//! What errors may be: `[tolerance.FIELD]`.

use super::bound::POSITIVE;
use super::error::Fault;
use super::output::Output;
use super::section::Section;

/// The largest error that a field may have.
#[derive(Debug, Clone, PartialEq)]
pub struct Tolerance {
    /// Of which field.
    pub field: Field,
    /// In which norm.
    pub norm: Norm,
    /// > 0.
    pub value: f64,
    /// Where the value comes from; not empty.
    pub reason: String,
}

/// A field that is compared with the exact solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Field {
    /// Mass / length^dimension.
    Density,
    /// Length / time.
    Velocity,
    /// Density * velocity^2.
    Pressure,
    /// Internal energy per mass.
    Energy,
}

/// A norm of an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Norm {
    /// Mean over the volume.
    L1,
    /// Root of the mean square.
    L2,
    /// Largest.
    Linf,
    /// Mean over the particles.
    Mean,
    /// Root of the mean square over the particles.
    Rms,
}

impl Field {
    /// Its name in a scenario.
    pub fn name(self) -> &'static str {
        FIELDS
            .iter()
            .find(|(_, field)| *field == self)
            .map_or("", |(name, _)| name)
    }
}

impl Norm {
    /// Its name in a scenario.
    pub fn name(self) -> &'static str {
        NORMS
            .iter()
            .find(|(_, norm)| *norm == self)
            .map_or("", |(name, _)| name)
    }
}

const FIELDS: [(&str, Field); 4] = [
    ("density", Field::Density),
    ("velocity", Field::Velocity),
    ("pressure", Field::Pressure),
    ("energy", Field::Energy),
];

const NORMS: [(&str, Norm); 5] = [
    ("l1", Norm::L1),
    ("l2", Norm::L2),
    ("linf", Norm::Linf),
    ("mean", Norm::Mean),
    ("rms", Norm::Rms),
];

/// `[tolerance]`: those of each field in the order of [`FIELDS`] and [`NORMS`].
pub(super) fn tolerances(root: &Section<'_>, output: &Output) -> Result<Vec<Tolerance>, Fault> {
    let Some(entry) = root.optional("tolerance") else {
        return Ok(Vec::new());
    };
    let section = entry.section()?;
    if output.exact.is_none() {
        let reason = "there is no output.exact to be compared with".to_owned();
        return Err(entry.does_not_fit(reason, "add `exact` to [output], or take it out"));
    }
    let mut tolerances = Vec::new();
    for (name, field) in FIELDS {
        let Some(entry) = section.optional(name) else {
            continue;
        };
        let section = entry.section()?;
        let reason_entry = section.required("reason")?;
        let reason = reason_entry.text()?.to_owned();
        if reason.trim().is_empty() {
            let cure = "say where the number comes from, as in reason = \"1.05 of the value \
                        measured at 900 particles\"";
            return Err(reason_entry.does_not_fit("it is empty".to_owned(), cure));
        }
        let before = tolerances.len();
        for (name, norm) in NORMS {
            if let Some(entry) = section.optional(name) {
                tolerances.push(Tolerance {
                    field,
                    norm,
                    value: entry.number(POSITIVE)?,
                    reason: reason.clone(),
                });
            }
        }
        if tolerances.len() == before {
            return Err(section.missing("l1"));
        }
    }
    Ok(tolerances)
}
