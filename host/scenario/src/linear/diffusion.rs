//! Convection-diffusion: `∂u/∂t + div(a u) - div(b grad u) = f`.

use motes_formula::Formula;

use super::conductor::conductor;
use super::field::field;
use super::matrices::names;
use super::reaction::reaction;
use super::tensor::tensor;
use super::wall::{Walls, walls};
use super::{Conductor, Field, Reaction};
use crate::bound::{NOT_NEGATIVE, PART};
use crate::define::Definitions;
use crate::entry::{ANY, Entry};
use crate::error::Fault;
use crate::files::Files;
use crate::section::Section;
use crate::{Domain, Extent};

/// Species that a velocity carries, that diffuse and react. That of the `i`-th is
/// `diffusivity_i profile(x) (1 + amplitude sin(rate t)) tensor`.
#[derive(Debug, Clone, PartialEq)]
pub struct ConvectionDiffusion {
    /// What they are called: 1 to 4, no two alike.
    pub species: Vec<String>,
    /// How `div(b grad u)` is written between particles.
    pub form: Form,
    /// Of `b` between two particles, of [`Form::Direct`].
    pub mean: Mean,
    /// `a`: the particles follow it.
    pub velocity: Field,
    /// One a species, length² / time, >= 0. Of formulas what they are in the middle of the domain at
    /// t = 0.
    pub diffusivity: Vec<f64>,
    /// How it varies along x.
    pub profile: Conductor,
    /// How it varies in time.
    pub modulation: Option<Modulation>,
    /// How it varies with the direction: symmetric, positive semidefinite, as many rows as
    /// directions; two and three dimensions.
    pub tensor: Option<Vec<Vec<f64>>>,
    /// `f`.
    pub reaction: Reaction,
    /// A direction, its lower and its upper end, a species; [`super::WallCondition::NoFlux`]
    /// where nothing is said, and where there is no wall.
    pub walls: Walls,
}

/// How `div(b grad u)` is written between particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// From the differences of `u` between pairs.
    Direct,
    /// The divergence of the fluxes `b grad u` of the particles.
    Mixed,
}

/// Of the diffusivities of two particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mean {
    /// `(b_k + b_l)/2`.
    Arithmetic,
    /// `2 b_k b_l/(b_k + b_l)`, and through layers what their resistances in series conduct on the
    /// way between the two. The default of a layered profile in the direct form.
    Harmonic,
}

/// The factor `1 + amplitude sin(rate t)` of a diffusivity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Modulation {
    /// Above -1 and below 1.
    pub amplitude: f64,
    /// Radians / time.
    pub rate: f64,
}

const FORMS: &[(&str, Form)] = &[("direct", Form::Direct), ("mixed", Form::Mixed)];

const MEANS: &[(&str, Mean)] = &[
    ("arithmetic", Mean::Arithmetic),
    ("harmonic", Mean::Harmonic),
];

/// The most species.
const MOST: usize = 4;

impl ConvectionDiffusion {
    /// Whether nothing passes through a wall.
    pub fn is_closed(&self) -> bool {
        let mut ends = self.walls.iter().flatten().flatten();
        ends.all(|condition| *condition == super::WallCondition::NoFlux)
    }
}

/// `[system]` of kind "convection-diffusion", and `[[wall]]`.
pub(super) fn convection_diffusion(
    root: &Section<'_>,
    section: &Section<'_>,
    domain: &Domain,
    files: Files<'_>,
    definitions: &Definitions<'_>,
) -> Result<ConvectionDiffusion, Fault> {
    let species = match section.optional("species") {
        Some(entry) => species(&entry)?,
        None => vec!["u".to_owned()],
    };
    let form = match section.optional("form") {
        Some(entry) => entry.choice(FORMS)?,
        None => Form::Direct,
    };
    let walls = walls(root, domain, &species, files, definitions)?;
    let mut profile = match section.optional("profile") {
        Some(entry) => conductor(&entry, &domain.extent)?,
        None => Conductor::Uniform,
    };
    let given = section.required("diffusivity")?;
    let formulas = formulas(&given, section, species.len(), definitions)?;
    let diffusivity = match &formulas {
        Some(formulas) => formulas
            .iter()
            .map(|of| at_start(of, &domain.extent))
            .collect(),
        None => diffusivity(&given, species.len())?,
    };
    if let Some(diffusivity) = formulas {
        profile = Conductor::Formula { diffusivity };
    }
    Ok(ConvectionDiffusion {
        form,
        mean: mean(section, form, &profile)?,
        velocity: match section.optional("velocity") {
            Some(entry) => field(&entry, domain, definitions)?,
            None => Field::Still,
        },
        diffusivity,
        profile,
        modulation: match section.optional("modulation") {
            Some(entry) => Some(modulation(&entry.section()?)?),
            None => None,
        },
        tensor: match section.optional("tensor") {
            Some(entry) => Some(tensor(&entry, domain)?),
            None => None,
        },
        reaction: match section.optional("reaction") {
            Some(entry) => reaction(&entry, &species, definitions)?,
            None => Reaction::None,
        },
        walls,
        species,
    })
}

fn species(entry: &Entry<'_>) -> Result<Vec<String>, Fault> {
    let entries = entry.list("a list of names")?;
    if !(1..=MOST).contains(&entries.len()) {
        let reason = format!(
            "the number of species is {}, need 1 to {MOST}",
            entries.len()
        );
        return Err(entry.does_not_fit(reason, "give one name a species, as [\"u\", \"v\"]"));
    }
    names(&entries)
}

/// Resistances in series between layers, unless told.
fn mean(section: &Section<'_>, form: Form, profile: &Conductor) -> Result<Mean, Fault> {
    let Some(entry) = section.optional("mean") else {
        let is_layered = matches!(profile, Conductor::Layers { .. });
        return Ok(match (form, is_layered) {
            (Form::Direct, true) => Mean::Harmonic,
            _ => Mean::Arithmetic,
        });
    };
    let mean = entry.choice(MEANS)?;
    if (mean, form) == (Mean::Harmonic, Form::Mixed) {
        let reason = "the mixed form takes b at a particle, and no mean between two".to_owned();
        return Err(entry.does_not_fit(reason, "set form = \"direct\", or take `mean` out"));
    }
    Ok(mean)
}

/// Diffusivities that are formulas: one a species, or one for all. What else says how a diffusivity
/// varies belongs into them.
fn formulas(
    entry: &Entry<'_>,
    section: &Section<'_>,
    species: usize,
    definitions: &Definitions<'_>,
) -> Result<Option<Vec<Formula>>, Fault> {
    let is_formula = match entry.list("") {
        Ok(entries) => entries.iter().any(Entry::is_text),
        Err(_) => entry.is_text(),
    };
    if !is_formula {
        return Ok(None);
    }
    for key in ["profile", "modulation"] {
        if let Some(other) = section.optional(key) {
            let reason = "system.diffusivity is a formula".to_owned();
            let cure = "write how it varies into the formula, and take this out";
            return Err(other.does_not_fit(reason, cure));
        }
    }
    let formulas = match entry.is_list() {
        true => definitions.formulas(entry, species)?,
        false => vec![definitions.formula(entry)?; species],
    };
    Ok(Some(formulas))
}

/// The value of a formula in the middle of a box at t = 0.
fn at_start(formula: &Formula, extent: &Extent) -> f64 {
    let mut point = [0.0; 4];
    for (i, x) in point.iter_mut().enumerate().take(extent.lower.len()) {
        *x = extent.middle(i);
    }
    formula.at(&point)
}

/// One number a species, or one for all.
fn diffusivity(entry: &Entry<'_>, species: usize) -> Result<Vec<f64>, Fault> {
    let Ok(entries) = entry.list("a number, or a list of numbers") else {
        return Ok(vec![entry.number(NOT_NEGATIVE)?; species]);
    };
    if entries.len() != species {
        let found = entries.len();
        let reason = format!("its length is {found}, species = {species}");
        return Err(entry.does_not_fit(reason, "give one number a species, or one for all"));
    }
    let numbers = entries.iter().map(|entry| entry.number(NOT_NEGATIVE));
    numbers.collect()
}

fn modulation(section: &Section<'_>) -> Result<Modulation, Fault> {
    Ok(Modulation {
        amplitude: section.number("amplitude", PART)?,
        rate: section.number("rate", ANY)?,
    })
}
