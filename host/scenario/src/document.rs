//! The parsed text of a scenario: parsed once, read by everything that asks what stands in it.

use std::ops::Range;

use toml::de::DeTable;

use crate::error::Fault;
use crate::files::Files;
use crate::keys::{Family, ROOT};
use crate::problem::Problem;
use crate::section::Section;

/// The parsed text of a scenario; every key and value knows its bytes.
pub(super) struct Document<'a> {
    /// All of it.
    pub text: &'a str,
    /// What it holds.
    pub table: DeTable<'a>,
    /// Where files named in the text are looked for.
    pub files: Files<'a>,
}

impl<'a> Document<'a> {
    /// Parses a text.
    ///
    /// # Errors
    /// A text that is not TOML.
    pub fn parse(text: &'a str, files: Files<'a>) -> Result<Self, Fault> {
        let table = DeTable::parse(text).map_err(|error| {
            let message = error.message().to_owned();
            let span = error.span().unwrap_or(end_of(text));
            Fault::new(Problem::Syntax { message }, span)
        })?;
        let table = table.into_inner();
        Ok(Self { text, table, files })
    }

    /// What it describes: `[system]` decides.
    pub fn family(&self) -> Family {
        Family::of(self.system().is_some())
    }

    /// Where `system` stands.
    fn system(&self) -> Option<Range<usize>> {
        let mut keys = self.table.keys();
        let system = keys.find(|key| key.get_ref() == "system");
        system.map(|system| system.span())
    }

    /// The keys above all sections.
    ///
    /// # Errors
    /// A scenario that is not of the family, and keys that the family does not have.
    pub fn root(&self, wanted: Family) -> Result<Section<'_>, Fault> {
        let family = self.family();
        if family != wanted {
            let span = self.system().unwrap_or(end_of(self.text));
            return Err(Fault::new(Problem::WrongFamily { family }, span));
        }
        Section::open(family, ROOT, &self.table, end_of(self.text))
    }
}

/// Where what is missing at the top is reported.
fn end_of(text: &str) -> Range<usize> {
    let end = text.trim_end().len();
    end..end
}
