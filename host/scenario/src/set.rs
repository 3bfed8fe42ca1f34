//! `--set section.key=value`: changes to the text of a scenario before it is
//! read, so that an error can show the line as it then stands.

use std::borrow::Cow;

use toml::de::DeValue;

use crate::document::Document;
use crate::edit::{Edit, Spot, edited, written_key};
use crate::keys::{self, Family, LISTS, ROOT};
use crate::problem::Problem;

/// The text with a change made, comments and the order of keys kept.
///
/// A change to one of `cut-off.eta` (with `theta`) and `cut-off.epsilon` takes out the other,
/// since a scenario has exactly one of them; so with `every` and `steps` of snapshots, and with
/// `step` and `stages` of time.
pub(super) fn changed(document: &Document<'_>, argument: &str) -> Result<String, Box<Problem>> {
    let malformed = || Problem::SetForm {
        argument: argument.to_owned(),
    };
    let (path, value) = argument.split_once('=').ok_or_else(malformed)?;
    let (path, value) = (path.trim(), value.trim());
    if path.is_empty() || value.is_empty() {
        return Err(Box::new(malformed()));
    }
    let is_system = path.split('.').next() == Some("system");
    let change = Change {
        family: match is_system {
            true => Family::Linear,
            false => document.family(),
        },
        path,
        value: Given::parse(path, value)?,
    };
    let edits = change.edits(document)?;
    Ok(edited(document.text, edits))
}

/// A value as it is written, and as it is meant.
struct Given<'a> {
    toml: Cow<'a, str>,
    value: DeValue<'a>,
}

impl<'a> Given<'a> {
    /// A TOML value, or a bare word as text.
    fn parse(key: &str, text: &'a str) -> Result<Self, Box<Problem>> {
        if let Ok(value) = DeValue::parse(text) {
            return Ok(Self {
                toml: Cow::Borrowed(text),
                value: value.into_inner(),
            });
        }
        let bare = |c: char| c.is_alphanumeric() || "-_.+/".contains(c);
        if text.chars().all(bare) {
            return Ok(Self {
                toml: Cow::Owned(format!("\"{text}\"")),
                value: DeValue::String(Cow::Borrowed(text)),
            });
        }
        Err(Box::new(Problem::SetValue {
            key: key.to_owned(),
            value: text.to_owned(),
        }))
    }

    /// Whether it may stand for a section.
    fn is_whole(&self) -> bool {
        matches!(self.value, DeValue::Table(_) | DeValue::Array(_))
    }

    fn is_text(&self, text: &str) -> bool {
        matches!(&self.value, DeValue::String(value) if value == text)
    }
}

/// A change to a scenario.
struct Change<'a> {
    family: Family,
    path: &'a str,
    value: Given<'a>,
}

/// Where a change leads to: a table of the text, and the tables to be made in it.
struct Way<'a> {
    spot: Spot<'a>,
    missing: Vec<&'a str>,
}

impl<'a> Change<'a> {
    /// Walks the sections that the path names, and puts the value in place; makes those that are
    /// missing.
    fn edits(&self, document: &Document<'_>) -> Result<Vec<Edit>, Box<Problem>> {
        let mut section = ROOT.to_owned();
        let mut way = Way {
            spot: Spot::root(document),
            missing: Vec::new(),
        };
        let mut keys = self.path.split('.');
        while let Some(key) = keys.next() {
            if !keys::has(self.family, &section, key) {
                return Err(self.unknown(key, &section));
            }
            let inner = keys::path(&section, key);
            let is_last = keys.clone().next().is_none();
            let is_whole = is_last && (self.value.is_whole() || keys::is_either(&inner));
            if keys::keys_of(self.family, &inner).is_empty() || is_whole {
                return match keys.next() {
                    None => self.put(&way, key).ok_or_else(|| {
                        let is_list = LISTS.contains(&inner.as_str());
                        self.whole_section(&if is_list {
                            keys::path(&inner, "0")
                        } else {
                            inner
                        })
                    }),
                    Some(deeper) => Err(self.unknown(deeper, &inner)),
                };
            }
            // One material needs no number.
            let one = way.spot.inner(key).is_some();
            if LISTS.contains(&inner.as_str()) && !one {
                let index = keys
                    .next()
                    .ok_or_else(|| self.whole_section(&format!("{inner}.0")))?;
                way.spot = self.numbered(&way.spot, key, index)?;
                section = keys::path(&inner, index);
                continue;
            }
            if way.missing.is_empty() && way.spot.has(key) {
                let found = way.spot.inner(key);
                way.spot = found.ok_or_else(|| self.whole_section(&inner))?;
            } else {
                way.missing.push(key);
            }
            section = inner;
        }
        Err(self.whole_section(&section))
    }

    /// The section of this number in a list, counted from 0.
    fn numbered<'s>(
        &self,
        root: &Spot<'s>,
        list: &str,
        index: &str,
    ) -> Result<Spot<'s>, Box<Problem>> {
        let (count, found) = root.numbered(list, index);
        let list = LISTS.into_iter().find(|known| *known == list);
        found.ok_or_else(|| {
            Box::new(Problem::SetIndex {
                key: self.path.to_owned(),
                list: list.unwrap_or_default(),
                index: index.to_owned(),
                count,
            })
        })
    }

    /// Puts the value under a key, in the place and with the comment of the old one.
    fn put(&self, way: &Way<'_>, key: &str) -> Option<Vec<Edit>> {
        let (mut key, mut value) = (key, self.value.toml.clone());
        let Some((section, within)) = way.missing.split_first() else {
            return way.spot.put(key, &value, self.rivals(key));
        };
        // What lies within a missing section stands in braces there.
        for inner in within.iter().rev() {
            value = Cow::Owned(format!("{{ {} = {value} }}", written_key(key)));
            key = inner;
        }
        if way.spot.is_root() {
            return Some(way.spot.append(section, key, &value));
        }
        let value = format!("{{ {} = {value} }}", written_key(key));
        way.spot.put(section, &value, &[])
    }

    /// The keys that may not stand beside a key, or not beside this value of it.
    fn rivals(&self, key: &str) -> &'static [&'static str] {
        match key {
            "eta" => &["epsilon"],
            "epsilon" => &["eta", "theta"],
            "step" => &["stages"],
            "stages" => &["step"],
            "method" if !self.value.is_text("rkl2") => &["stages"],
            "form" if self.value.is_text("mixed") => &["mean"],
            "every" => &["steps"],
            "steps" => &["every"],
            _ => &[],
        }
    }

    fn unknown(&self, key: &str, section: &str) -> Box<Problem> {
        Box::new(Problem::SetKey {
            key: self.path.to_owned(),
            unknown: key.to_owned(),
            section: section.to_owned(),
            known: keys::names(self.family, section).collect(),
        })
    }

    fn whole_section(&self, section: &str) -> Box<Problem> {
        Box::new(Problem::SetSection {
            key: self.path.to_owned(),
            section: section.to_owned(),
            known: keys::names(self.family, section).collect(),
        })
    }
}
