//! What can be wrong with a scenario: the facts and the cure of each case.

use std::path::PathBuf;

use thiserror::Error;

use super::keys::{Family, LISTS};
use super::nearest::nearest;

/// What is wrong with a scenario. `Display` states it with the offending value;
/// [`Problem::help`] tells the cure.
#[derive(Debug, Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are what the texts print
pub enum Problem {
    /// A name that is neither a file nor a built-in scenario.
    #[error("there is no built-in scenario `{name}`")]
    UnknownBuiltIn {
        name: String,
        known: Vec<&'static str>,
    },
    /// The file does not exist.
    #[error("there is no file `{}`", file.display())]
    NoSuchFile { file: PathBuf },
    /// A directory where a file is needed.
    #[error("`{}` is a directory, need a file", file.display())]
    Directory { file: PathBuf },
    /// The operating system refuses to read the file.
    #[error("cannot read `{}`: {error}", file.display())]
    Unreadable {
        file: PathBuf,
        error: std::io::Error,
    },
    /// The file is not UTF-8 text.
    #[error("not UTF-8 text: the byte 0x{byte:02x} cannot stand here")]
    NotUtf8 { byte: u8 },
    /// The text breaks the TOML grammar.
    #[error("not TOML: {message}")]
    Syntax { message: String },

    /// A key that its section does not have.
    #[error("unknown key `{key}` {}", within(section))]
    UnknownKey {
        key: String,
        section: String,
        known: Vec<String>,
    },
    /// A key of a gas where a linear system is described, or the reverse.
    #[error("`{key}` {} goes with {}", within(section), whose(family.other()))]
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
    #[error("{key} = \"{name}\" is unknown")]
    UnknownName {
        key: String,
        name: String,
        known: Vec<String>,
    },
    /// A scenario name that cannot name a folder of results.
    #[error("name = \"{name}\" is not a plain name")]
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
    #[error("--set {argument} is not of the form section.key=value")]
    SetForm { argument: String },
    /// A `--set` of a key that does not exist.
    #[error("--set {key}: unknown key `{unknown}` {}", within(section))]
    SetKey {
        key: String,
        unknown: String,
        section: String,
        known: Vec<&'static str>,
    },
    /// A `--set` of a whole section.
    #[error("--set {key} names a section, need one of its keys")]
    SetSection {
        key: String,
        section: String,
        known: Vec<&'static str>,
    },
    /// A `--set` of a region, material or deposit that does not exist.
    #[error("--set {key}: there is no {list} {index}, the file has {count}")]
    SetIndex {
        key: String,
        list: &'static str,
        index: String,
        count: usize,
    },
    /// A `--set` whose value is not TOML.
    #[error("--set {key}: `{value}` is not a value")]
    SetValue { key: String, value: String },
}

impl Problem {
    /// The cure.
    pub fn help(&self) -> String {
        self.help_on_source()
            .or_else(|| self.help_on_set())
            .unwrap_or_else(|| self.help_on_value())
    }

    /// The cure where the text cannot be read at all.
    fn help_on_source(&self) -> Option<String> {
        Some(match self {
            Self::UnknownBuiltIn { name, known } => format!(
                "{}built-in scenarios: {}. A file of your own must end in .toml or be given \
                 with its folder, as ./{name}",
                did_you_mean(name, known.iter().copied()),
                known.join(", ")
            ),
            Self::NoSuchFile { .. } => "check the spelling and the folder; `motes list` lists the \
                 built-in scenarios, `motes show sod > mine.toml` writes one to start from"
                .to_owned(),
            Self::Directory { .. } => "give the .toml file in it".to_owned(),
            Self::Unreadable { .. } => "check that it may be read by you".to_owned(),
            Self::NotUtf8 { .. } => "save the file as UTF-8 text".to_owned(),
            Self::Syntax { .. } => "a line is `key = value`, `[section]` or `[[region]]`; text \
                 stands in \"quotes\", a list in [brackets]"
                .to_owned(),
            _ => return None,
        })
    }

    /// The cure of a faulty `--set`.
    fn help_on_set(&self) -> Option<String> {
        Some(match self {
            Self::SetForm { .. } => {
                "for example --set material.gamma=1.4 or --set region.0.density=2".to_owned()
            }
            Self::SetKey {
                unknown,
                section,
                known,
                ..
            } => known_keys(unknown, section, known),
            Self::SetSection { section, known, .. } => match known.first() {
                Some(name) => format!(
                    "for example --set {section}.{name}=...; {}",
                    known_keys("", section, known)
                ),
                None => known_keys("", "", known),
            },
            Self::SetIndex { count: 0, list, .. } => format!("add a [[{list}]] to the file"),
            Self::SetIndex { count, list, .. } => {
                format!("{list}s are numbered from 0 to {}", count - 1)
            }
            Self::SetValue { key, .. } => format!(
                "write a number, a list as '{key}=[0.0, 1.0]', a word, or quoted text as \
                 '{key}=\"two words\"', each in single quotes for the shell"
            ),
            _ => return None,
        })
    }

    /// The cure where a key or its value is at fault.
    fn help_on_value(&self) -> String {
        match self {
            Self::UnknownKey {
                key,
                section,
                known,
            } => known_keys(key, section, known),
            Self::OtherFamily { key, family, .. } => family_cure(key, *family),
            Self::WrongFamily {
                family: Family::Linear,
            } => "[system] makes it a linear system, and this is for a gas only".to_owned(),
            Self::WrongFamily {
                family: Family::Gas,
            } => "a linear system has [system] with its kind; this is for those only".to_owned(),
            Self::MissingKey { example, .. } => format!("add for example `{example}`"),
            Self::WrongType { example, .. } => format!("write for example `{example}`"),
            Self::NotFinite { key, .. } => {
                format!("give {key} an ordinary number, at most 1.7e308 in size")
            }
            Self::OutOfRange { cure, .. } => (*cure).to_owned(),
            Self::UnknownName { name, known, .. } => format!(
                "{}known: {}",
                did_you_mean(name, known.iter().map(String::as_str)),
                known.join(", ")
            ),
            Self::NotPlain { .. } => {
                "use letters, digits, - and _ only: results are filed under the name".to_owned()
            }
            Self::WrongLength { dimension, .. } => {
                format!("the list goes with dimension = {dimension}: change one of the two")
            }
            Self::EmptyBox { key, .. } => {
                format!("make {key}.upper larger than {key}.lower in every direction")
            }
            Self::OutsideDomain { .. } => {
                "move it inside, or enlarge domain.lower and domain.upper".to_owned()
            }
            Self::Overlap { first, second, .. } => format!(
                "regions may touch but not overlap: move lower or upper of region.{first} or \
                 region.{second} (numbered from 0)"
            ),
            Self::HalfPeriodic { .. } => "what leaves at a periodic side comes in at the other: \
                 write \"periodic\" for the direction, or another side at both ends"
                .to_owned(),
            Self::Width { both: true } => "keep one: eta (width in mean spacings; that of a gas \
                 adapts to the density) or epsilon (constant width, a length)"
                .to_owned(),
            Self::Width { both: false } => "add `eta = 1.2` (width in mean spacings, adapts to \
                 the density) or `epsilon = 0.01` (constant width, a length)"
                .to_owned(),
            Self::DoesNotFit { cure, .. } => cure.clone(),
            Self::Gas { both: true } => "keep one: [profile], or every [[region]]".to_owned(),
            Self::Gas { both: false } => "add a [[region]] with lower, upper, density, velocity \
                 and pressure, or a [profile] with its kind"
                .to_owned(),
            _ => String::new(),
        }
    }
}

/// "in [section]", or where the keys above all sections stand.
fn within(section: &str) -> String {
    match section.split_once('.') {
        None if section.is_empty() => "at the top of the file".to_owned(),
        None if LISTS.contains(&section) && section != "material" => format!("in [[{section}]]"),
        Some((list, index)) if LISTS.contains(&list) => {
            format!("in [[{list}]] {index} (numbered from 0)")
        }
        _ => format!("in [{section}]"),
    }
}

/// "did you mean ...? the keys of [section] are: ..."
fn known_keys(key: &str, section: &str, known: &[impl AsRef<str>]) -> String {
    let names: Vec<&str> = known.iter().map(AsRef::as_ref).collect();
    format!(
        "{}the keys {} are: {}",
        did_you_mean(key, names.iter().copied()),
        within(section),
        names.join(", ")
    )
}

/// What scenarios of a family describe.
fn whose(family: Family) -> &'static str {
    match family {
        Family::Gas => "a gas",
        Family::Linear => "a linear system",
    }
}

/// What to do with a key that goes with the other family.
fn family_cure(key: &str, family: Family) -> String {
    let instead = match (family, key) {
        (Family::Gas, _) => "this scenario has no [system], which makes it a gas",
        (_, "region" | "profile" | "inflow" | "deposit") => {
            "[initial] says what there is at t = 0 in a linear system"
        }
        (_, "material") => "[system] holds the constants of a linear system",
        (_, "viscosity" | "conduction") => "a linear system has no shocks to smooth",
        (_, "weights") => "a particle of a linear system carries its weight",
        _ => "[system] makes this scenario a linear system",
    };
    format!("take `{key}` out: {instead}")
}

fn did_you_mean<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, known).map_or_else(String::new, |near| format!("did you mean `{near}`? "))
}
