//! How a diffusivity varies from place to place.

use motes_formula::Formula;

use crate::Extent;
use crate::bound::POSITIVE;
use crate::entry::{ANY, Entry};
use crate::error::Fault;

/// A factor `c(x) >= 0` of the diffusivity, of the coordinate along x alone; or formulas in its place.
#[derive(Debug, Clone, PartialEq)]
pub enum Conductor {
    /// `c = 1`.
    Uniform,
    /// `c = 1 - ((x - center)/radius)²`, 0 beyond.
    Parabola {
        /// A coordinate along x.
        center: f64,
        /// Length, > 0.
        radius: f64,
    },
    /// Constant between bounds, and beyond the first and the last.
    Layers {
        /// Coordinates along x, ascending, at least one.
        bounds: Vec<f64>,
        /// Of the layers from lower to upper, > 0, one more than the bounds.
        factors: Vec<f64>,
    },
    /// The diffusivities themselves, of place and time.
    Formula {
        /// One a species.
        diffusivity: Vec<Formula>,
    },
}

/// The names of the profiles, with the keys that each takes.
const KINDS: [(&str, &[&str]); 3] = [
    ("uniform", &[]),
    ("parabola", &["center", "radius"]),
    ("layers", &["bounds", "factors"]),
];

impl Conductor {
    /// Its name in a scenario.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Parabola { .. } => "parabola",
            Self::Layers { .. } => "layers",
            Self::Formula { .. } => "formula",
        }
    }

    /// Its largest value.
    pub fn largest(&self) -> f64 {
        match self {
            Self::Uniform | Self::Parabola { .. } | Self::Formula { .. } => 1.0,
            Self::Layers { factors, .. } => factors.iter().copied().fold(0.0, f64::max),
        }
    }
}

/// `system.profile`; a parabola falls to 0 at the sides of the domain along x unless told.
pub(super) fn conductor(entry: &Entry<'_>, domain: &Extent) -> Result<Conductor, Fault> {
    let section = entry.section()?;
    let (name, keys) = section
        .required("kind")?
        .choice(&KINDS.map(|kind| (kind.0, kind)))?;
    if name == "uniform" {
        // Whatever else there is, so that `--set system.profile.kind=uniform` alone will do.
        return Ok(Conductor::Uniform);
    }
    section.only(name, &["kind"], keys)?;
    if name == "parabola" {
        let half = 0.5 * (domain.upper[0] - domain.lower[0]);
        return Ok(Conductor::Parabola {
            center: section.number_or("center", domain.middle(0), ANY)?,
            radius: section.number_or("radius", half, POSITIVE)?,
        });
    }
    let bounds = bounds(&section.required("bounds")?)?;
    let factors = factors(&section.required("factors")?, bounds.len())?;
    Ok(Conductor::Layers { bounds, factors })
}

/// Where one layer ends and the next begins.
fn bounds(entry: &Entry<'_>) -> Result<Vec<f64>, Fault> {
    let entries = entry.list("a list of coordinates along x")?;
    if entries.is_empty() {
        let reason = "layers without a bound are one".to_owned();
        return Err(entry.does_not_fit(reason, "set kind = \"uniform\", or give a bound"));
    }
    let mut bounds: Vec<f64> = Vec::with_capacity(entries.len());
    for entry in entries {
        let bound = entry.number(ANY)?;
        if let Some(last) = bounds.last().filter(|last| bound <= **last) {
            let reason = format!("it is not above the bound before it, {last}");
            return Err(entry.does_not_fit(reason, "give the bounds in ascending order"));
        }
        bounds.push(bound);
    }
    Ok(bounds)
}

/// What the layers multiply the diffusivity with.
fn factors(entry: &Entry<'_>, bounds: usize) -> Result<Vec<f64>, Fault> {
    let entries = entry.list("a list of numbers, one a layer")?;
    if entries.len() != bounds + 1 {
        let (found, layers) = (entries.len(), bounds + 1);
        let reason = format!("its length is {found}, the bounds make {layers} layers");
        return Err(entry.does_not_fit(reason, "give one number a layer, one more than bounds"));
    }
    let factor = |entry: &Entry<'_>| entry.number(POSITIVE);
    entries.iter().map(factor).collect()
}
