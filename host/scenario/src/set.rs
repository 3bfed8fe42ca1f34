//! `--set section.key=value`: changes to the text of a scenario before it is
//! read, so that an error can show the line as it then stands.

use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, Value};

use super::error::{Fault, Place, ScenarioError};
use super::keys::{self, Family, LISTS, ROOT};
use super::problem::Problem;

/// The text with the changes made, comments and the order of keys kept.
///
/// A change to one of `cut-off.eta` (with `theta`) and `cut-off.epsilon` takes out the other,
/// since a scenario has exactly one of them; so with `every` and `steps` of snapshots, and with
/// `step` and `stages` of time.
pub(super) fn with_overrides(
    text: &str,
    name: &str,
    overrides: &[String],
) -> Result<String, ScenarioError> {
    let mut document = text.parse::<DocumentMut>().map_err(|error| {
        let end = text.trim_end().len();
        let message = error.message().to_owned();
        let span = error.span().unwrap_or(end..end);
        Fault::new(Problem::Syntax { message }, span).within(name, text)
    })?;
    for argument in overrides {
        apply(&mut document, argument).map_err(|problem| {
            let place = Place {
                name: "--set".to_owned(),
                text: argument.clone(),
                span: 0..argument.len(),
            };
            ScenarioError::new(*problem, place)
        })?;
    }
    Ok(document.to_string())
}

fn apply(document: &mut DocumentMut, argument: &str) -> Result<(), Box<Problem>> {
    let malformed = || Problem::SetForm {
        argument: argument.to_owned(),
    };
    let (path, value) = argument.split_once('=').ok_or_else(malformed)?;
    let (path, value) = (path.trim(), value.trim());
    if path.is_empty() || value.is_empty() {
        return Err(Box::new(malformed()));
    }
    let value = parsed(path, value)?;
    let keys: Vec<&str> = path.split('.').collect();
    let is_system = |key: &str| key == "system";
    let has_system = document.iter().any(|(key, _)| is_system(key));
    let family = Family::of(has_system || keys.first().is_some_and(|key| is_system(key)));
    place(document.as_table_mut(), family, path, &keys, value)
}

/// A TOML value, or a bare word as text.
fn parsed(key: &str, text: &str) -> Result<Value, Box<Problem>> {
    if let Ok(value) = text.parse::<Value>() {
        return Ok(value);
    }
    let bare = |c: char| c.is_alphanumeric() || "-_.+/".contains(c);
    if text.chars().all(bare) {
        return Ok(Value::from(text));
    }
    Err(Box::new(Problem::SetValue {
        key: key.to_owned(),
        value: text.to_owned(),
    }))
}

/// Walks the sections that `keys` name, makes those that are missing, and puts
/// the value in place.
fn place(
    root: &mut Table,
    family: Family,
    path: &str,
    keys: &[&str],
    value: Value,
) -> Result<(), Box<Problem>> {
    let mut section = ROOT.to_owned();
    let mut table: &mut dyn TableLike = root;
    let mut keys = keys.iter().copied();
    while let Some(key) = keys.next() {
        if !keys::has(family, &section, key) {
            return Err(unknown(family, path, key, &section));
        }
        let inner = keys::path(&section, key);
        let is_whole = section != ROOT && (value.is_inline_table() || value.is_array());
        if keys::keys_of(family, &inner).is_empty() || is_whole && keys.len() == 0 {
            return match keys.next() {
                None => {
                    put(table, key, value);
                    Ok(())
                }
                Some(deeper) => Err(unknown(family, path, deeper, &inner)),
            };
        }
        let list = LISTS.into_iter().find(|list| *list == inner);
        // One material needs no number.
        let list = list.filter(|_| !table.get(key).is_some_and(Item::is_table_like));
        if let Some(list) = list {
            let index = keys
                .next()
                .ok_or_else(|| whole_section(family, path, &format!("{list}.0")))?;
            table = numbered(table, list, path, index)?;
            section = keys::path(&inner, index);
        } else {
            table = subsection(table, key, section == ROOT)
                .ok_or_else(|| whole_section(family, path, &inner))?;
            section = inner;
        }
    }
    Err(whole_section(family, path, &section))
}

/// The section of this number in a list, counted from 0.
fn numbered<'a>(
    root: &'a mut dyn TableLike,
    list: &'static str,
    path: &str,
    index: &str,
) -> Result<&'a mut dyn TableLike, Box<Problem>> {
    let number: Option<usize> = index.parse().ok();
    let mut count = 0;
    let found: Option<&mut dyn TableLike> = match root.get_mut(list) {
        Some(Item::ArrayOfTables(tables)) => {
            count = tables.len();
            number
                .and_then(|number| tables.get_mut(number))
                .map(|table| table as &mut dyn TableLike)
        }
        Some(Item::Value(Value::Array(values))) => {
            count = values.len();
            number
                .and_then(|number| values.get_mut(number)?.as_inline_table_mut())
                .map(|table| table as &mut dyn TableLike)
        }
        _ => None,
    };
    found.ok_or_else(|| {
        Box::new(Problem::SetIndex {
            key: path.to_owned(),
            list,
            index: index.to_owned(),
            count,
        })
    })
}

/// The section of this name, made if missing; none if the name stands for
/// something else in the text.
fn subsection<'a>(
    table: &'a mut dyn TableLike,
    key: &str,
    at_the_top: bool,
) -> Option<&'a mut dyn TableLike> {
    let item = table.entry(key).or_insert_with(|| {
        if at_the_top {
            Item::Table(Table::new())
        } else {
            Item::Value(Value::InlineTable(InlineTable::new()))
        }
    });
    item.as_table_like_mut()
}

/// Puts a value under a key, in the place and with the comment of the old one.
fn put(table: &mut dyn TableLike, key: &str, mut value: Value) {
    match key {
        "eta" => drop(table.remove("epsilon")),
        "epsilon" => drop((table.remove("eta"), table.remove("theta"))),
        "step" => drop(table.remove("stages")),
        "stages" => drop(table.remove("step")),
        // What goes with the old one only.
        "method" if value.as_str() != Some("rkl2") => drop(table.remove("stages")),
        "form" if value.as_str() == Some("mixed") => drop(table.remove("mean")),
        "every" => drop(table.remove("steps")),
        "steps" => drop(table.remove("every")),
        _ => {}
    }
    match table.get_mut(key) {
        Some(item) => {
            if let Some(old) = item.as_value() {
                *value.decor_mut() = old.decor().clone();
            }
            *item = Item::Value(value);
        }
        None => drop(table.insert(key, Item::Value(value))),
    }
}

fn unknown(family: Family, path: &str, key: &str, section: &str) -> Box<Problem> {
    Box::new(Problem::SetKey {
        key: path.to_owned(),
        unknown: key.to_owned(),
        section: section.to_owned(),
        known: keys::names(family, section).collect(),
    })
}

fn whole_section(family: Family, path: &str, section: &str) -> Box<Problem> {
    Box::new(Problem::SetSection {
        key: path.to_owned(),
        section: section.to_owned(),
        known: keys::names(family, section).collect(),
    })
}
