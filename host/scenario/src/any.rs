//! A scenario of either family.

use crate::check;
use crate::error::ScenarioError;
use crate::linear::LinearScenario;
use crate::source::Source;
use crate::{Family, Scenario};

/// A scenario, whatever it describes.
#[derive(Debug, Clone, PartialEq)]
pub enum AnyScenario {
    /// A gas.
    Gas(Box<Scenario>),
    /// A linear first-order system.
    Linear(Box<LinearScenario>),
}

impl AnyScenario {
    /// Reads a scenario; `overrides` are `section.key=value` as given to `--set`,
    /// the later ones on top of the earlier.
    ///
    /// # Errors
    /// Whatever keeps the text from being a scenario: the first fault found, with
    /// its place and cure.
    pub fn read(source: Source, overrides: &[String]) -> Result<Self, ScenarioError> {
        check::read(&source, overrides, check::any)
    }

    /// What it describes.
    pub fn family(&self) -> Family {
        match self {
            Self::Gas(_) => Family::Gas,
            Self::Linear(_) => Family::Linear,
        }
    }

    /// Letters, digits, `-` and `_`: fit to name a file.
    pub fn name(&self) -> &str {
        match self {
            Self::Gas(scenario) => &scenario.name,
            Self::Linear(scenario) => &scenario.name,
        }
    }

    /// One line for lists and headings; may be empty.
    pub fn description(&self) -> &str {
        match self {
            Self::Gas(scenario) => &scenario.description,
            Self::Linear(scenario) => &scenario.description,
        }
    }

    /// 1, 2 or 3.
    pub fn dimension(&self) -> usize {
        match self {
            Self::Gas(scenario) => scenario.dimension,
            Self::Linear(scenario) => scenario.dimension,
        }
    }

    /// The TOML text after `--set`: reading it gives this scenario.
    pub fn text(&self) -> &str {
        match self {
            Self::Gas(scenario) => &scenario.text,
            Self::Linear(scenario) => &scenario.text,
        }
    }
}
