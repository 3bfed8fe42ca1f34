//! What passes through the walls of convection-diffusion: `[[wall]]`.

use motes_formula::Formula;

use super::Series;
use super::series::series;
use crate::Domain;
use crate::bound::{NOT_NEGATIVE, POSITIVE};
use crate::define::Definitions;
use crate::entry::{ANY, Entry};
use crate::error::Fault;
use crate::files::Files;
use crate::geometry::place_of_wall;
use crate::section::Section;

/// What a species meets at a wall. The flux is what leaves the domain, `-b ∂u/∂n` with the
/// normal `n` outwards: species · length / time.
#[derive(Debug, Clone, PartialEq)]
pub enum WallCondition {
    /// `b ∂u/∂n = 0`.
    NoFlux,
    /// `u` is given.
    Value(Drive),
    /// The flux is given, above 0 outwards.
    Flux(Drive),
    /// The flux is `rate (u - outside)`.
    Exchange {
        /// Length / time, >= 0.
        rate: f64,
        /// `u` outside.
        outside: Drive,
    },
}

impl WallCondition {
    /// What drives it.
    pub fn drive(&self) -> Option<&Drive> {
        match self {
            Self::NoFlux => None,
            Self::Value(drive) | Self::Flux(drive) | Self::Exchange { outside: drive, .. } => {
                Some(drive)
            }
        }
    }

    /// The series that drives it, if one does.
    pub fn series(&self) -> Option<&Series> {
        match self.drive() {
            Some(Drive::Series(series)) => Some(series),
            _ => None,
        }
    }
}

/// A number that drives a wall, of the time.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    /// The same at all times.
    Constant(f64),
    /// Out of a file.
    Series(Series),
    /// A formula of the time.
    Formula(Formula),
}

impl Drive {
    /// Times of a run and what a formula is there, equally spaced; none of another drive.
    pub fn sampled(&self, duration: f64, intervals: u32) -> Vec<(f64, f64)> {
        let Self::Formula(formula) = self else {
            return Vec::new();
        };
        let time = |i: u32| duration * f64::from(i) / f64::from(intervals);
        let point = |i: u32| (time(i), formula.at(&[0.0, 0.0, 0.0, time(i)]));
        (0..=intervals).map(point).collect()
    }
}

/// The names of the conditions, with the keys that each takes.
const KINDS: [(&str, &[&str]); 4] = [
    ("no-flux", &[]),
    ("value", &["value", "series"]),
    ("flux", &["flux", "series"]),
    ("exchange", &["rate", "outside", "series"]),
];

/// The conditions of the walls: a direction, its lower and its upper end, the species.
pub(super) type Walls = Vec<[Vec<WallCondition>; 2]>;

/// Every `[[wall]]`; a wall of which nothing is said lets nothing through.
pub(super) fn walls(
    root: &Section<'_>,
    domain: &Domain,
    species: &[String],
    files: Files<'_>,
    definitions: &Definitions<'_>,
) -> Result<Walls, Fault> {
    let closed = || vec![WallCondition::NoFlux; species.len()];
    let mut walls: Walls = domain.sides.iter().map(|_| [closed(), closed()]).collect();
    let Some(entry) = root.optional("wall") else {
        return Ok(walls);
    };
    let mut told = Vec::new();
    let end_of_run = end_of_run(root);
    for (number, entry) in entry.list("one or more [[wall]]")?.iter().enumerate() {
        let section = entry.section()?;
        let (axis, end) = place_of_wall(&section, domain)?;
        let condition = condition(&section, (files, end_of_run), definitions)?;
        for i in chosen(&section, species)? {
            let same = told.iter().find(|(_, place)| *place == (axis, end, i));
            if let Some((first, _)) = same {
                let reason = format!("wall {first} says already what {} meets there", species[i]);
                let cure = "keep one of the two, or give each a `species` of its own; walls are \
                            numbered from 0";
                return Err(section.required("end")?.does_not_fit(reason, cure));
            }
            told.push((number, (axis, end, i)));
            walls[axis][end][i] = condition.clone();
        }
    }
    Ok(walls)
}

/// The duration, where it is one: if not, `[time]` says what is wrong with it.
fn end_of_run(root: &Section<'_>) -> Option<f64> {
    let time = root.optional("time")?.section().ok()?;
    time.optional("end")?.number(POSITIVE).ok()
}

/// The species that a wall is for: all unless told.
fn chosen(section: &Section<'_>, species: &[String]) -> Result<Vec<usize>, Fault> {
    Ok(match section.optional("species") {
        Some(entry) => vec![entry.choice_of(species.iter().map(String::as_str))?],
        None => (0..species.len()).collect(),
    })
}

fn condition(
    section: &Section<'_>,
    (files, end): (Files<'_>, Option<f64>),
    definitions: &Definitions<'_>,
) -> Result<WallCondition, Fault> {
    let kind = section.required("kind")?;
    let (name, keys) = kind.choice(&KINDS.map(|kind| (kind.0, kind)))?;
    section.only(name, &["axis", "end", "species", "kind"], keys)?;
    let of = |key| drive(section, key, (files, end), definitions);
    Ok(match name {
        "no-flux" => WallCondition::NoFlux,
        "value" => WallCondition::Value(of("value")?),
        "flux" => WallCondition::Flux(of("flux")?),
        _ => WallCondition::Exchange {
            rate: section.number("rate", NOT_NEGATIVE)?,
            outside: of("outside")?,
        },
    })
}

/// A number under its key, or a series in its place.
fn drive(
    section: &Section<'_>,
    key: &'static str,
    (files, end): (Files<'_>, Option<f64>),
    definitions: &Definitions<'_>,
) -> Result<Drive, Fault> {
    match (section.optional(key), section.optional("series")) {
        (Some(entry), None) if entry.is_text() => of_time(&entry, definitions),
        (Some(entry), None) => Ok(Drive::Constant(entry.number(ANY)?)),
        (None, Some(entry)) => Ok(Drive::Series(series(&entry.section()?, files, end)?)),
        (Some(_), Some(entry)) => Err(both(&entry, key)),
        (None, None) => Err(section.missing(key)),
    }
}

/// A formula that is of the time alone.
fn of_time(entry: &Entry<'_>, definitions: &Definitions<'_>) -> Result<Drive, Fault> {
    let formula = definitions.formula(entry)?;
    if let Some(value) = formula.value().filter(|value| value.is_finite()) {
        return Ok(Drive::Constant(value));
    }
    if (0..3).any(|axis| formula.depends_on(axis)) {
        let reason = "it depends on the place, and a wall has one number for all of it".to_owned();
        return Err(entry.does_not_fit(reason, "give a formula of t alone"));
    }
    Ok(Drive::Formula(formula))
}

fn both(series: &Entry<'_>, key: &str) -> Fault {
    let reason = format!("`{key}` is there too");
    let cure = format!("keep one: `{key}`, a number, or `series`, a column of a file");
    series.does_not_fit(reason, &cure)
}
