//! From TOML text to a checked scenario.

use crate::document::Document;
use crate::error::{Fault, Place, ScenarioError};
use crate::keys::Family;
use crate::source::Source;
use crate::{AnyScenario, LinearScenario, Scenario};
use crate::{gas, linear, set};

/// Reads a source with the `overrides` on top, through `parsed`. Each text is parsed once: that of
/// the source, and what each of the overrides makes of it.
pub(super) fn read<T>(
    source: &Source,
    overrides: &[String],
    parsed: impl FnOnce(&Document<'_>) -> Result<T, Fault>,
) -> Result<T, ScenarioError> {
    let (mut text, mut name) = (source.text()?, source.to_string());
    for argument in overrides {
        let document = Document::parse(&text, source.files());
        let document = document.map_err(|fault| fault.within(&name, &text))?;
        text = set::changed(&document, argument).map_err(|problem| {
            let place = Place {
                name: "--set".to_owned(),
                text: argument.clone(),
                span: 0..argument.len(),
            };
            ScenarioError::new(*problem, place)
        })?;
    }
    if !overrides.is_empty() {
        name.push_str(" after --set");
    }
    Document::parse(&text, source.files())
        .and_then(|document| parsed(&document))
        .map_err(|fault| fault.within(&name, &text))
}

/// A scenario of either family.
pub(super) fn any(document: &Document<'_>) -> Result<AnyScenario, Fault> {
    Ok(match document.family() {
        Family::Gas => AnyScenario::Gas(Box::new(gas(document)?)),
        Family::Linear => AnyScenario::Linear(Box::new(linear(document)?)),
    })
}

/// A scenario that describes a linear system.
pub(super) fn linear(document: &Document<'_>) -> Result<LinearScenario, Fault> {
    let root = document.root(Family::Linear)?;
    linear::scenario(&root, document.files, document.text)
}

/// A scenario that describes a gas.
pub(super) fn gas(document: &Document<'_>) -> Result<Scenario, Fault> {
    let root = document.root(Family::Gas)?;
    gas::scenario(&root, document.files, document.text)
}
