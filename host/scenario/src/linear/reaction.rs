//! What species turn into at a place.

use motes_formula::Formula;

use super::matrices::matrix;
use crate::bound::{NOT_NEGATIVE, POSITIVE};
use crate::define::Definitions;
use crate::entry::{ANY, Entry};
use crate::error::Fault;

/// The right-hand side `f(u)` of `du/dt = f(u)` where nothing flows.
#[derive(Debug, Clone, PartialEq)]
pub enum Reaction {
    /// 0.
    None,
    /// `f = M u + source`.
    Linear {
        /// `M`, row by row, 1 / time.
        matrix: Vec<f64>,
        /// One a species, of the species per time.
        source: Vec<f64>,
    },
    /// `f = rate u (1 - u/capacity)`, each species by itself.
    Logistic {
        /// 1 / time, >= 0.
        rate: f64,
        /// What it grows to, > 0.
        capacity: f64,
    },
    /// `f = (-u v² + feed (1 - u), u v² - (feed + kill) v)` (Pearson, Science 261 (1993) 189):
    /// two species.
    GrayScott {
        /// 1 / time, >= 0.
        feed: f64,
        /// 1 / time, >= 0.
        kill: f64,
    },
    /// `f(x,t,u)`, one formula a species: of the place, the time and, behind them, the species.
    Formula {
        /// Of a species per time.
        rates: Vec<Formula>,
    },
}

const FORMULA: &str = "formula";

/// The names of the reactions, with the keys that each takes.
const KINDS: [(&str, &[&str]); 5] = [
    ("none", &[]),
    ("linear", &["matrix", "source"]),
    ("logistic", &["rate", "capacity"]),
    ("gray-scott", &["feed", "kill"]),
    (FORMULA, &["rates"]),
];

impl Reaction {
    /// Its name in a scenario.
    pub fn name(&self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Linear { .. } => "linear",
            Self::Logistic { .. } => "logistic",
            Self::GrayScott { .. } => "gray-scott",
            Self::Formula { .. } => FORMULA,
        }
    }
}

/// `system.reaction` of some species.
pub(super) fn reaction(
    entry: &Entry<'_>,
    names: &[String],
    definitions: &Definitions<'_>,
) -> Result<Reaction, Fault> {
    let species = names.len();
    let section = entry.section()?;
    let kind = section.required("kind")?;
    let (name, keys) = kind.choice(&KINDS.map(|kind| (kind.0, kind)))?;
    if name == "none" {
        // Whatever else there is, so that `--set system.reaction.kind=none` alone will do.
        return Ok(Reaction::None);
    }
    section.only(name, &["kind"], keys)?;
    Ok(match name {
        FORMULA => {
            let definitions = definitions.with_unknowns(names);
            let rates = definitions.formulas(&section.required("rates")?, species)?;
            Reaction::Formula { rates }
        }
        "linear" => Reaction::Linear {
            matrix: matrix(&section.required("matrix")?, species, "species")?,
            source: match section.optional("source") {
                Some(entry) => one_a_species(&entry, species)?,
                None => vec![0.0; species],
            },
        },
        "logistic" => Reaction::Logistic {
            rate: section.number("rate", NOT_NEGATIVE)?,
            capacity: section.number("capacity", POSITIVE)?,
        },
        _ if species != 2 => {
            let reason = format!("gray-scott is of two species, there are {species}");
            let cure = "give two, as species = [\"u\", \"v\"], or choose another reaction";
            return Err(kind.does_not_fit(reason, cure));
        }
        _ => Reaction::GrayScott {
            feed: section.number("feed", NOT_NEGATIVE)?,
            kill: section.number("kill", NOT_NEGATIVE)?,
        },
    })
}

/// One number a species.
pub(super) fn one_a_species(entry: &Entry<'_>, species: usize) -> Result<Vec<f64>, Fault> {
    let entries = entry.list("a list with one number a species")?;
    if entries.len() != species {
        let found = entries.len();
        let reason = format!("its length is {found}, species = {species}");
        return Err(entry.does_not_fit(reason, "give one number a species"));
    }
    entries.iter().map(|entry| entry.number(ANY)).collect()
}
