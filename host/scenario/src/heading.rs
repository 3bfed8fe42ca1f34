//! The keys above all sections, `[units]` and `[domain]`: what gases and linear systems have in common.

use crate::domain::Domain;
use crate::error::Fault;
use crate::geometry;
use crate::problem::Problem;
use crate::section::Section;

/// Labels of the units, `"1"` for none; nothing is converted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Units {
    /// Of lengths.
    pub length: String,
    /// Of masses.
    pub mass: String,
    /// Of times.
    pub time: String,
}

/// What gases and linear systems have in common.
pub(super) struct Heading {
    pub name: String,
    pub description: String,
    pub dimension: usize,
    pub units: Units,
    pub domain: Domain,
}

/// The keys above all sections, `[units]` and `[domain]`.
pub(super) fn heading(root: &Section<'_>) -> Result<Heading, Fault> {
    let name = plain_name(root)?;
    let description = label(root, "description", "")?;
    let dimension = root.required("dimension")?.count(
        3,
        "1, 2 or 3",
        "give the number of directions of space",
    )?;
    let domain = geometry::domain(&root.required("domain")?.section()?, dimension)?;
    Ok(Heading {
        name,
        description,
        dimension,
        units: units(root)?,
        domain,
    })
}

fn plain_name(root: &Section<'_>) -> Result<String, Fault> {
    let entry = root.required("name")?;
    let name = entry.text()?.to_owned();
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if name.is_empty() || !name.chars().all(plain) {
        return Err(entry.fault(Problem::NotPlain { name }));
    }
    Ok(name)
}

fn label(section: &Section<'_>, key: &'static str, default: &str) -> Result<String, Fault> {
    let text = section
        .optional(key)
        .map_or(Ok(default), |entry| entry.text())?;
    Ok(text.to_owned())
}

fn units(root: &Section<'_>) -> Result<Units, Fault> {
    let Some(entry) = root.optional("units") else {
        let one = || "1".to_owned();
        return Ok(Units {
            length: one(),
            mass: one(),
            time: one(),
        });
    };
    let section = entry.section()?;
    Ok(Units {
        length: label(&section, "length", "1")?,
        mass: label(&section, "mass", "1")?,
        time: label(&section, "time", "1")?,
    })
}
