//! Typed, checked values out of parsed TOML, each with its place in the text.

use std::ops::{Range, RangeInclusive};

use toml::Spanned;
use toml::de::DeValue;

use crate::error::Fault;
use crate::keys::Family;
use crate::problem::Problem;
use crate::section::Section;
use crate::snippet::{shortened, shortened_sentence};

type Value<'a> = Spanned<DeValue<'a>>;

/// One value, with the key that leads to it.
#[derive(Debug, Clone)]
pub(super) struct Entry<'a> {
    pub(super) family: Family,
    pub(super) key: String,
    pub(super) example: &'static str,
    pub(super) value: &'a Value<'a>,
}

/// The numbers that a key takes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bound {
    /// The condition as a reader reads it.
    pub need: &'static str,
    /// The same as a function; only asked about finite numbers.
    pub holds: fn(f64) -> bool,
    /// What to write instead.
    pub cure: &'static str,
}

/// No bound: any finite number.
pub(super) const ANY: Bound = Bound {
    need: "a finite number",
    holds: |_| true,
    cure: "",
};

impl<'a> Entry<'a> {
    /// Where the value stands.
    pub fn span(&self) -> Range<usize> {
        self.value.span()
    }

    /// The path of keys that leads to it.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// A fault of this value.
    pub fn fault(&self, problem: Problem) -> Fault {
        Fault::new(problem, self.span())
    }

    /// A finite number within its bound; TOML integers count as numbers.
    pub fn number(&self, bound: Bound) -> Result<f64, Fault> {
        let value = match self.value.get_ref() {
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::Integer(integer) => integer_value(integer).map(|integer| integer as f64),
            _ => None,
        };
        let value = value.ok_or_else(|| self.wrong_type("a number"))?;
        if !value.is_finite() {
            return Err(self.fault(Problem::NotFinite {
                key: self.key.clone(),
                value: shown(self.value.get_ref()),
            }));
        }
        if (bound.holds)(value) {
            Ok(value)
        } else {
            Err(self.out_of_range(bound.need, bound.cure))
        }
    }

    /// The fault that the value does not go with the rest of the scenario.
    pub fn does_not_fit(&self, reason: String, cure: &str) -> Fault {
        self.fault(Problem::DoesNotFit {
            key: self.key.clone(),
            value: self.shown(),
            reason: shortened_sentence(&reason),
            cure: shortened_sentence(cure),
        })
    }

    /// Whether it is text.
    pub fn is_text(&self) -> bool {
        matches!(self.value.get_ref(), DeValue::String(_))
    }

    /// Whether it is a list.
    pub fn is_list(&self) -> bool {
        matches!(self.value.get_ref(), DeValue::Array(_))
    }

    /// Whether it is a section or a table in braces.
    pub fn is_section(&self) -> bool {
        matches!(self.value.get_ref(), DeValue::Table(_))
    }

    /// A whole number in `1..=most`.
    pub fn count(&self, most: u32, need: &'static str, cure: &'static str) -> Result<usize, Fault> {
        let most = usize::try_from(most).unwrap_or(usize::MAX);
        self.whole(1..=most, need, cure)
    }

    /// A whole number in a range.
    pub fn whole<T: TryFrom<i128> + PartialOrd>(
        &self,
        range: RangeInclusive<T>,
        need: &'static str,
        cure: &'static str,
    ) -> Result<T, Fault> {
        let value = match self.value.get_ref() {
            DeValue::Integer(integer) => integer_value(integer),
            DeValue::Float(float) => match float.as_str().parse::<f64>() {
                // 7.0 and 1e6 are whole; beyond 2^53 nobody can tell.
                Ok(value) if value.fract() == 0.0 && value.abs() < 9e15 => Some(value as i128),
                _ => return Err(self.wrong_type("a whole number")),
            },
            _ => return Err(self.wrong_type("a whole number")),
        };
        value
            .and_then(|value| T::try_from(value).ok())
            .filter(|value| range.contains(value))
            .ok_or_else(|| self.out_of_range(need, cure))
    }

    /// `true` or `false`.
    pub fn truth(&self) -> Result<bool, Fault> {
        match self.value.get_ref() {
            DeValue::Boolean(truth) => Ok(*truth),
            _ => Err(self.wrong_type("true or false")),
        }
    }

    /// Text.
    pub fn text(&self) -> Result<&'a str, Fault> {
        match self.value.get_ref() {
            DeValue::String(text) => Ok(text),
            _ => Err(self.wrong_type("text in quotes")),
        }
    }

    /// One of the names in a table.
    pub fn choice<T: Clone>(&self, names: &[(&'static str, T)]) -> Result<T, Fault> {
        let place = self.choice_of(names.iter().map(|(name, _)| *name))?;
        Ok(names[place].1.clone())
    }

    /// The place of the text in a list of names.
    pub fn choice_of<'n>(
        &self,
        names: impl Iterator<Item = &'n str> + Clone,
    ) -> Result<usize, Fault> {
        let text = self.text()?;
        let place = names.clone().position(|name| name == text);
        place.ok_or_else(|| {
            self.fault(Problem::UnknownName {
                key: self.key.clone(),
                name: text.to_owned(),
                known: names.map(str::to_owned).collect(),
            })
        })
    }

    /// The entries of a list, called `key.0`, `key.1`, ...
    pub fn list(&self, need: &'static str) -> Result<Vec<Entry<'a>>, Fault> {
        let DeValue::Array(values) = self.value.get_ref() else {
            return Err(self.wrong_type(need));
        };
        let entry = |(index, value)| Entry {
            family: self.family,
            key: format!("{}.{index}", self.key),
            example: self.example,
            value,
        };
        Ok(values.iter().enumerate().map(entry).collect())
    }

    /// The entries of a list with one entry a direction.
    pub fn directions(&self, dimension: usize) -> Result<Vec<Entry<'a>>, Fault> {
        let entries = self.list("a list with one entry a direction")?;
        if entries.len() == dimension {
            return Ok(entries);
        }
        Err(self.fault(Problem::WrongLength {
            key: self.key.clone(),
            found: entries.len(),
            dimension,
        }))
    }

    /// A vector: one finite number a direction.
    pub fn vector(&self, dimension: usize) -> Result<Vec<f64>, Fault> {
        let entries = self.directions(dimension)?;
        entries.iter().map(|entry| entry.number(ANY)).collect()
    }

    /// A section, or a table in braces.
    pub fn section(&self) -> Result<Section<'a>, Fault> {
        match self.value.get_ref() {
            DeValue::Table(table) => Section::open(self.family, &self.key, table, self.span()),
            _ => Err(self.wrong_type("a section")),
        }
    }

    /// The value as text, shortened.
    pub fn shown(&self) -> String {
        shown(self.value.get_ref())
    }

    /// The fault that the value is not what the key needs.
    pub fn wrong_type(&self, need: &'static str) -> Fault {
        let value = self.value.get_ref();
        self.fault(Problem::WrongType {
            key: self.key.clone(),
            value: shown(value),
            found: match value {
                DeValue::String(_) => "text",
                DeValue::Integer(_) => "a whole number",
                DeValue::Float(_) => "a number with a fraction",
                DeValue::Boolean(_) => "a truth value",
                DeValue::Datetime(_) => "a date or time",
                DeValue::Array(_) => "a list",
                DeValue::Table(_) => "a section",
            },
            need,
            example: self.example,
        })
    }

    fn out_of_range(&self, need: &'static str, cure: &'static str) -> Fault {
        self.fault(Problem::OutOfRange {
            key: self.key.clone(),
            value: shown(self.value.get_ref()),
            need,
            cure,
        })
    }
}

fn integer_value(integer: &toml::de::DeInteger<'_>) -> Option<i128> {
    i128::from_str_radix(integer.as_str(), integer.radix()).ok()
}

/// A value as text, shortened.
pub(super) fn shown(value: &DeValue<'_>) -> String {
    shortened(&written(value))
}

fn written(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => format!("\"{text}\""),
        DeValue::Integer(integer) => integer.to_string(),
        DeValue::Float(float) => float.as_str().to_owned(),
        DeValue::Boolean(truth) => truth.to_string(),
        DeValue::Datetime(date) => date.to_string(),
        DeValue::Array(values) => {
            let values: Vec<String> = values
                .iter()
                .map(|value| written(value.get_ref()))
                .collect();
            format!("[{}]", values.join(", "))
        }
        DeValue::Table(_) => "{ ... }".to_owned(),
    }
}
