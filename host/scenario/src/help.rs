//! The cure of each problem.

use motes_formula::FormulaFault;

use crate::keys::{DEFINE, Family};
use crate::nearest::nearest;
use crate::problem::{Problem, within};
use crate::snippet::shortened as short;

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
                 with its folder, as ./{}",
                did_you_mean(name, known.iter().copied()),
                known.join(", "),
                short(name)
            ),
            Self::NoSuchFile { .. } => "check the spelling and the folder; `motes list` lists the \
                 built-in scenarios, `motes show sod > mine.toml` writes one to start from"
                .to_owned(),
            Self::Directory { .. } => "give the .toml file in it".to_owned(),
            Self::NotRegular { .. } => {
                "write what comes out of it into a file that ends in .toml, and give that"
                    .to_owned()
            }
            Self::TooLong { .. } => {
                "check that it is the file that you mean: particles and series \
                 stand in CSV files of their own"
                    .to_owned()
            }
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
                    "for example --set {}.{name}=...; {}",
                    short(section),
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
                 '{key}=\"two words\"', each in single quotes for the shell",
                key = short(key)
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
                format!(
                    "give {} an ordinary number, at most 1.7e308 in size",
                    short(key)
                )
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
            Self::Formula { fault, .. } => match fault {
                FormulaFault::Unknown { name, known } => {
                    let plain = known.iter().map(|name| name.trim_end_matches("()"));
                    format!("{}{}", did_you_mean(name, plain), fault.help())
                }
                _ => fault.help(),
            },
            Self::DoesNotFit { cure, .. } | Self::Table { cure, .. } => cure.clone(),
            Self::Gas { both: true } => "keep one: [profile], or every [[region]]".to_owned(),
            Self::Gas { both: false } => "add a [[region]] with lower, upper, density, velocity \
                 and pressure, or a [profile] with its kind"
                .to_owned(),
            _ => String::new(),
        }
    }
}

/// "did you mean ...? the keys of [section] are: ..."
fn known_keys(key: &str, section: &str, known: &[impl AsRef<str>]) -> String {
    if section == DEFINE {
        return "any name may be defined: a constant, k = \"2*pi\", or a function, \"c(s)\" = \"1 + s^2\"".to_owned();
    }
    let names: Vec<&str> = known.iter().map(AsRef::as_ref).collect();
    format!(
        "{}the keys {} are: {}",
        did_you_mean(key, names.iter().copied()),
        within(section),
        names.join(", ")
    )
}

/// What to do with a key that goes with the other family.
fn family_cure(key: &str, family: Family) -> String {
    let key = short(key);
    if family == Family::Gas {
        return format!("add [system] with its kind for a linear system, or take `{key}` out");
    }
    let instead = match key.as_str() {
        "region" | "profile" | "inflow" | "outflow" | "deposit" => {
            "[initial] says what there is at t = 0 in a linear system"
        }
        "material" => "[system] holds the constants of a linear system",
        "viscosity" | "conduction" => "a linear system has no shocks to smooth",
        "weights" => "a particle of a linear system carries its weight",
        _ => "[system] makes this scenario a linear system",
    };
    format!("take `{key}` out: {instead}")
}

fn did_you_mean<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, known).map_or_else(String::new, |near| format!("did you mean `{near}`? "))
}
