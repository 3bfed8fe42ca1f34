//! A system given by its matrices.

use motes_formula::Formula;

use super::System;
use crate::define::Definitions;
use crate::entry::{ANY, Entry};
use crate::error::Fault;
use crate::section::Section;

/// Names that the results have already.
const TAKEN: [&str; 9] = [
    "state",
    "reconstruction",
    "weight",
    "neighbours",
    "id",
    "time",
    "steps",
    "time_step",
    "energy",
];

/// What names of columns that are made of others begin with.
const TAKEN_FRONTS: [&str; 5] = ["position", "exact_", "reconstructed_", "total_", "energy_"];

/// What they end with.
const TAKEN_ENDS: [&str; 3] = ["_min", "_mean", "_max"];

/// The most components that a system given by matrices may have.
const MOST: u32 = 8;

/// `[system]` of kind "matrices".
pub(super) fn matrices(
    section: &Section<'_>,
    dimension: usize,
    definitions: &Definitions<'_>,
) -> Result<System, Fault> {
    let cure = "give the number of components of u";
    let components = section.required("components")?;
    let components = components.count(MOST, "1 to 8", cure)?;
    let flux = section.required("flux")?;
    let entries = flux.list("a list of matrices, one a direction")?;
    if entries.len() != dimension {
        let found = entries.len();
        let reason = format!("the number of matrices is {found}, dimension = {dimension}");
        let cure = "give one matrix a direction, each a list of rows: [[[0.0, 1.0], [1.0, 0.0]]] \
                    in one dimension";
        return Err(flux.does_not_fit(reason, cure));
    }
    let names = match section.optional("names") {
        Some(entry) => component_names(&entry, components)?,
        None => (0..components).map(|i| format!("u{i}")).collect(),
    };
    let formula = |entry: &Entry<'_>| definitions.formula(entry);
    let matrix = |entry: &Entry<'_>| square(entry, (components, "components"), formula);
    let flux: Vec<Vec<Formula>> = entries.iter().map(matrix).collect::<Result<_, _>>()?;
    let decay = match section.optional("decay") {
        Some(entry) => matrix(&entry)?,
        None => vec![Formula::constant(0.0); components * components],
    };
    let numbers = |matrix: &[Formula]| {
        matrix
            .iter()
            .map(Formula::value)
            .collect::<Option<Vec<_>>>()
    };
    let constant: Option<Vec<_>> = flux.iter().map(|matrix| numbers(matrix)).collect();
    Ok(match (constant, numbers(&decay)) {
        (Some(flux), Some(decay)) => System::Matrices {
            components,
            flux,
            decay,
            names,
        },
        _ => System::VariableMatrices {
            components,
            flux,
            decay,
            names,
        },
    })
}

/// A square matrix of numbers, row by row; `what` has as many as there are rows.
pub(super) fn matrix(
    entry: &Entry<'_>,
    size: usize,
    what: &'static str,
) -> Result<Vec<f64>, Fault> {
    square(entry, (size, what), |entry| entry.number(ANY))
}

/// A square matrix, row by row, of whatever its entries are read as.
fn square<T>(
    entry: &Entry<'_>,
    (size, what): (usize, &'static str),
    read: impl Fn(&Entry<'_>) -> Result<T, Fault>,
) -> Result<Vec<T>, Fault> {
    let cure = match what {
        "dimension" => format!("give {size} rows of {size} numbers, or another dimension"),
        _ => format!("give {size} rows of {size} numbers, or another number of {what}"),
    };
    let rows = entry.list("a matrix: a list of rows")?;
    if rows.len() != size {
        let found = rows.len();
        let reason = format!("the number of its rows is {found}, {what} = {size}");
        return Err(entry.does_not_fit(reason, &cure));
    }
    let mut entries = Vec::with_capacity(size * size);
    for row in rows {
        let columns = row.list("a row: a list of numbers")?;
        if columns.len() != size {
            let found = columns.len();
            let reason = format!("the number of entries of this row is {found}, {what} = {size}");
            return Err(row.does_not_fit(reason, &cure));
        }
        for entry in columns {
            entries.push(read(&entry)?);
        }
    }
    Ok(entries)
}

/// One name a component.
fn component_names(entry: &Entry<'_>, components: usize) -> Result<Vec<String>, Fault> {
    let entries = entry.list("a list of names")?;
    if entries.len() != components {
        let found = entries.len();
        let reason = format!("the number of names is {found}, components = {components}");
        return Err(entry.does_not_fit(reason, "give one name a component"));
    }
    names(&entries)
}

/// Names that can head the columns of a file, no two alike.
pub(super) fn names(entries: &[Entry<'_>]) -> Result<Vec<String>, Fault> {
    let mut names: Vec<String> = Vec::new();
    for entry in entries {
        let name = entry.text()?;
        let is_plain = name
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
        let is_taken = TAKEN.contains(&name)
            || TAKEN_FRONTS.iter().any(|front| name.starts_with(front))
            || TAKEN_ENDS.iter().any(|end| name.ends_with(end));
        if name.is_empty() || !is_plain || is_taken {
            let reason = "names head the columns of the results, and some are taken".to_owned();
            let cure = "use letters, digits, - and _; not a column of the results, such as \
                        state, weight, position_x, exact_u or u_min";
            return Err(entry.does_not_fit(reason, cure));
        }
        if names.iter().any(|other| other == name) {
            let reason = "another one has the same name".to_owned();
            return Err(entry.does_not_fit(reason, "give each a name of its own"));
        }
        names.push(name.to_owned());
    }
    Ok(names)
}
