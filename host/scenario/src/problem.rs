//! What can be wrong with a scenario: the facts of each case.

use std::path::PathBuf;

use motes_formula::FormulaFault;
use thiserror::Error;

use crate::keys::{Family, LISTS};
use crate::snippet::shortened as short;

/// What is wrong with a scenario. `Display` states it with the offending value;
/// [`Problem::help`] tells the cure.
#[derive(Debug, Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are what the texts print
pub enum Problem {
    /// A name that is neither a file nor a built-in scenario.
    #[error("there is no built-in scenario `{}`", short(name))]
    UnknownBuiltIn {
        name: String,
        known: Vec<&'static str>,
    },
    /// The file does not exist.
    #[error("there is no file `{}`", path(file))]
    NoSuchFile { file: PathBuf },
    /// A directory where a file is needed.
    #[error("`{}` is a directory, need a file", path(file))]
    Directory { file: PathBuf },
    /// What has no end, or may never begin.
    #[error("`{}` is a pipe or a device, need a file", path(file))]
    NotRegular { file: PathBuf },
    /// More bytes than a scenario may have.
    #[error("`{}` has more than {most} bytes: that is no scenario", path(file))]
    TooLong { file: PathBuf, most: u64 },
    /// The operating system refuses to read the file.
    #[error("cannot read `{}`: {error}", path(file))]
    Unreadable {
        file: PathBuf,
        error: std::io::Error,
    },
    /// The file is not UTF-8 text.
    #[error("not UTF-8 text: the byte 0x{byte:02x} cannot stand here")]
    NotUtf8 { byte: u8 },
    /// The text breaks the TOML grammar.
    #[error("not TOML: {}", short(message))]
    Syntax { message: String },

    /// A key that its section does not have.
    #[error("unknown key `{}` {}", short(key), within(section))]
    UnknownKey {
        key: String,
        section: String,
        known: Vec<String>,
    },
    /// A key of a gas where a linear system is described, or the reverse.
    #[error("`{}` {} goes with {}", short(key), within(section), whose(family.other()))]
    OtherFamily {
        key: String,
        section: String,
        family: Family,
    },
    /// A scenario of the family that the caller does not take.
    #[error("this scenario describes {}", whose(*family))]
    WrongFamily { family: Family },
    /// A key that its section needs.
    #[error("`{key}` is missing {}", within(section))]
    MissingKey {
        key: &'static str,
        section: String,
        example: &'static str,
    },
    /// A value of another type than the key takes.
    #[error("{key} = {value} is {found}, need {need}")]
    WrongType {
        key: String,
        value: String,
        found: &'static str,
        need: &'static str,
        example: &'static str,
    },
    /// A number that is NaN or infinite.
    #[error("{key} = {value} is not a finite number")]
    NotFinite { key: String, value: String },
    /// A number outside its range.
    #[error("{key} = {value} is out of range: need {need}")]
    OutOfRange {
        key: String,
        value: String,
        need: &'static str,
        cure: &'static str,
    },
    /// A name that is not one of those the key takes.
    #[error("{key} = \"{}\" is unknown", short(name))]
    UnknownName {
        key: String,
        name: String,
        known: Vec<String>,
    },
    /// A scenario name that cannot name a folder of results.
    #[error("name = \"{}\" is not a plain name", short(name))]
    NotPlain { name: String },
    /// A list whose length is not the dimension.
    #[error("{key} has length {found}, need {dimension}: one entry a direction")]
    WrongLength {
        key: String,
        found: usize,
        dimension: usize,
    },
    /// A box without volume.
    #[error("{key} is empty: upper = {upper} is not above lower = {lower} along {axis}")]
    EmptyBox {
        key: String,
        axis: char,
        lower: f64,
        upper: f64,
    },
    /// A box that reaches out of the domain.
    #[error("{key} = {value} lies outside the domain: [{lower}, {upper}] along {axis}")]
    OutsideDomain {
        key: String,
        axis: char,
        value: f64,
        lower: f64,
        upper: f64,
    },
    /// Two regions that share volume.
    #[error("region.{second} overlaps region.{first}: both hold {axis} in [{lower}, {upper}]")]
    Overlap {
        first: usize,
        second: usize,
        axis: char,
        lower: f64,
        upper: f64,
    },
    /// Periodic at one end of a direction only.
    #[error("{key} = {value} is periodic at one end only")]
    HalfPeriodic { key: String, value: String },
    /// Both widths of the cut-off, or neither.
    #[error("[cut-off] has {}", if *both { "both eta and epsilon" } else { "neither eta nor epsilon" })]
    Width { both: bool },
    /// A heading or a row of a file that the scenario names.
    #[error("{message}")]
    Table { message: String, cure: String },
    /// A formula that cannot be read.
    #[error("{key} = {text}: {fault}")]
    Formula {
        key: String,
        text: String,
        fault: FormulaFault,
    },
    /// A value that does not go with the rest of the scenario.
    #[error("{key} = {value} does not fit: {reason}")]
    DoesNotFit {
        key: String,
        value: String,
        reason: String,
        cure: String,
    },
    /// Neither, or more than one, of what can say how the gas is at t = 0.
    #[error("there is {}", if *both { "both [profile] and [[region]]" } else { "neither [[region]] nor [profile]" })]
    Gas { both: bool },

    /// A `--set` that is not `section.key=value`.
    #[error("--set {} is not of the form section.key=value", short(argument))]
    SetForm { argument: String },
    /// A `--set` of a key that does not exist.
    #[error(
        "--set {}: unknown key `{}` {}",
        short(key),
        short(unknown),
        within(section)
    )]
    SetKey {
        key: String,
        unknown: String,
        section: String,
        known: Vec<&'static str>,
    },
    /// A `--set` of a whole section.
    #[error("--set {} names a section, need one of its keys", short(key))]
    SetSection {
        key: String,
        section: String,
        known: Vec<&'static str>,
    },
    /// A `--set` of a region, material, deposit or wall that does not exist.
    #[error(
        "--set {}: there is no {list} {}, the file has {count}",
        short(key),
        short(index)
    )]
    SetIndex {
        key: String,
        list: &'static str,
        index: String,
        count: usize,
    },
    /// A `--set` whose value is not TOML.
    #[error("--set {}: `{}` is not a value", short(key), short(value))]
    SetValue { key: String, value: String },
}

/// The path of a file as messages repeat it.
fn path(file: &std::path::Path) -> String {
    short(&file.display().to_string())
}

/// "in [section]", or where the keys above all sections stand.
pub(super) fn within(section: &str) -> String {
    match section.split_once('.') {
        None if section.is_empty() => "at the top of the file".to_owned(),
        None if LISTS.contains(&section) && section != "material" => format!("in [[{section}]]"),
        Some((list, index)) if LISTS.contains(&list) => {
            format!("in [[{list}]] {index} (numbered from 0)")
        }
        _ => format!("in [{}]", short(section)),
    }
}

/// What scenarios of a family describe.
fn whose(family: Family) -> &'static str {
    match family {
        Family::Gas => "a gas",
        Family::Linear => "a linear system",
    }
}
