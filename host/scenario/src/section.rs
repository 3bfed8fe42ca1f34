//! Sections of parsed TOML: their keys, each a known one.

use std::ops::Range;

use toml::de::DeTable;

use crate::entry::{Bound, Entry, shown};
use crate::error::Fault;
use crate::keys::{self, Family, example};
use crate::problem::Problem;

/// A section of which every key is known.
#[derive(Debug, Clone)]
pub(super) struct Section<'a> {
    family: Family,
    path: String,
    table: &'a DeTable<'a>,
    span: Range<usize>,
}

impl<'a> Section<'a> {
    /// Opens a section; `span` is where a missing key should be reported.
    ///
    /// # Errors
    /// The first key, in the order of the text, that the section does not have.
    pub fn open(
        family: Family,
        path: &str,
        table: &'a DeTable<'a>,
        span: Range<usize>,
    ) -> Result<Self, Fault> {
        let unknown = table
            .keys()
            .filter(|key| !keys::has(family, path, key.get_ref()))
            .min_by_key(|key| key.span().start);
        let section = path.to_owned();
        let Some(key) = unknown else {
            return Ok(Self {
                family,
                path: section,
                table,
                span,
            });
        };
        let span = key.span();
        let key = key.get_ref().to_string();
        let problem = if keys::has(family.other(), path, &key) {
            Problem::OtherFamily {
                key,
                section,
                family,
            }
        } else {
            let known = keys::names(family, path).map(str::to_owned).collect();
            Problem::UnknownKey {
                key,
                section,
                known,
            }
        };
        Err(Fault::new(problem, span))
    }

    /// The value of a key, if it is there.
    pub fn optional(&self, key: &str) -> Option<Entry<'a>> {
        let (_, value) = self.table.iter().find(|(name, _)| name.get_ref() == key)?;
        Some(Entry {
            family: self.family,
            key: keys::path(&self.path, key),
            example: example(self.family, &self.path, key),
            value,
        })
    }

    /// All keys with their values, in the order of the text.
    pub fn entries(&self) -> Vec<(String, Entry<'a>)> {
        let mut keys: Vec<_> = self.table.keys().collect();
        keys.sort_by_key(|key| key.span().start);
        let entry = |key: &str| self.optional(key).map(|entry| (key.to_owned(), entry));
        keys.iter().filter_map(|key| entry(key.get_ref())).collect()
    }

    /// The value of a key, or the error that it is missing.
    pub fn required(&self, key: &'static str) -> Result<Entry<'a>, Fault> {
        self.optional(key).ok_or_else(|| self.missing(key))
    }

    /// A number that must be there.
    pub fn number(&self, key: &'static str, bound: Bound) -> Result<f64, Fault> {
        self.required(key)?.number(bound)
    }

    /// A number, or what it is without the key.
    pub fn number_or(&self, key: &str, usual: f64, bound: Bound) -> Result<f64, Fault> {
        let entry = self.optional(key);
        entry.map_or(Ok(usual), |entry| entry.number(bound))
    }

    /// The fault that a key is missing.
    pub fn missing(&self, key: &'static str) -> Fault {
        let problem = Problem::MissingKey {
            key,
            section: self.path.clone(),
            example: example(self.family, &self.path, key),
        };
        Fault::new(problem, self.span())
    }

    /// That it has no keys but the `known` ones, where the text itself says what they are.
    ///
    /// # Errors
    /// The first other key, in the order of the text.
    pub fn is_among<'n>(&self, known: impl Iterator<Item = &'n str> + Clone) -> Result<(), Fault> {
        let is_known = |key: &str| known.clone().any(|known| known == key);
        let other = self.table.keys().filter(|key| !is_known(key.get_ref()));
        let Some(key) = other.min_by_key(|key| key.span().start) else {
            return Ok(());
        };
        let problem = Problem::UnknownKey {
            key: key.get_ref().to_string(),
            section: self.path.clone(),
            known: known.map(str::to_owned).collect(),
        };
        Err(Fault::new(problem, key.span()))
    }

    /// That it has no keys but those of its `kind` and the `common` ones.
    ///
    /// # Errors
    /// The first other key, in the order of the text.
    pub fn only(&self, kind: &str, common: &[&str], own: &[&'static str]) -> Result<(), Fault> {
        let fits = |key: &str| common.contains(&key) || own.contains(&key);
        let other = self.table.iter().filter(|(key, _)| !fits(key.get_ref()));
        let Some((key, value)) = other.min_by_key(|(key, _)| key.span().start) else {
            return Ok(());
        };
        let name = key.get_ref();
        let takes = match own {
            [] => "nothing".to_owned(),
            own => own.join(", "),
        };
        // `--set` changes keys one by one, and takes none out; but it can replace them all.
        let whole = match common.first() {
            Some(&"kind") if !self.path.contains('.') => format!(
                "; --set '{path}={{ kind = \"{kind}\", ... }}' replaces the keys of [{path}]",
                path = self.path
            ),
            _ => String::new(),
        };
        let problem = Problem::DoesNotFit {
            key: keys::path(&self.path, name),
            value: shown(value.get_ref()),
            reason: format!("{kind} has no {name}"),
            cure: format!("take `{name}` out: {kind} takes {takes}{whole}"),
        };
        Err(Fault::new(problem, key.span()))
    }

    /// The path of keys that leads to it; empty above all sections.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Where the section stands.
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }
}
