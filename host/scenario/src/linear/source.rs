//! The source `f(x,t)` of a first-order system.

use motes_formula::Formula;

use super::System;
use crate::define::Definitions;
use crate::error::Fault;
use crate::section::Section;

/// `system.source` where it is formulas; the number that transport takes is a part of the system.
pub(super) fn source(
    root: &Section<'_>,
    system: &System,
    dimension: usize,
    definitions: &Definitions<'_>,
) -> Result<Option<Vec<Formula>>, Fault> {
    let section = root.required("system")?.section()?;
    let Some(entry) = section.optional("source") else {
        return Ok(None);
    };
    if matches!(system, System::Transport { .. }) && !entry.is_text() && !entry.is_list() {
        return Ok(None);
    }
    let components = system.components(dimension);
    definitions.formulas(&entry, components).map(Some)
}

/// That no source is given where one is made.
pub(super) fn refuse(root: &Section<'_>, is_given: bool) -> Result<(), Fault> {
    if !is_given {
        return Ok(());
    }
    let entry = root.required("system")?.section()?.required("source")?;
    let reason = "the source of a manufactured solution is made from it".to_owned();
    Err(entry.does_not_fit(
        reason,
        "take `source` out, or set initial.kind = \"formula\"",
    ))
}
