//! Linear first-order systems `∂u/∂t + Σ_i ∂_i(A^i u) + A⁰ u = f`, and convection-diffusion
//! `∂u/∂t + div(a u) - div(b grad u) = f`, on particles that move with a field of velocities.

mod coefficients;
mod conductor;
mod diffusion;
mod field;
mod initial;
mod manufactured;
mod matrices;
mod output;
mod reaction;
mod resolution;
mod series;
mod sides;
mod solution;
mod source;
mod system;
mod tensor;
mod time;
mod wall;

use motes_formula::Formula;

use crate::define::Definitions;
use crate::domain::{Domain, Side};
use crate::error::{Fault, ScenarioError};
use crate::files::Files;
use crate::heading::{self, Units};
use crate::section::Section;
use crate::source::Source;
use crate::tolerance::Tolerance;
use crate::{CutOff, check, cut_off};

pub use conductor::Conductor;
pub use diffusion::{ConvectionDiffusion, Form, Mean, Modulation};
pub use field::{Field, FormulaField};
pub use initial::Initial;
pub use output::{Exact, Measured, Output, Probe};
pub use reaction::Reaction;
pub use resolution::{Arrangement, Resolution};
pub use series::Series;
pub use system::System;
pub use time::{Method, Time};
pub use wall::{Drive, WallCondition};

/// A linear first-order system to solve. All numbers are in the scenario's own units.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LinearScenario {
    /// Letters, digits, `-` and `_`: fit to name a file.
    pub name: String,
    /// One line for lists and headings; may be empty.
    pub description: String,
    /// 1, 2 or 3: the length of every vector of space below.
    pub dimension: usize,
    /// Labels of the units.
    pub units: Units,
    /// The box that is simulated, and its sides: periodic, mirror or free.
    pub domain: Domain,
    /// The equations.
    pub system: System,
    /// `f(x,t)`, one formula a component, of a first-order system; beside what [`System`] says.
    pub source: Option<Vec<Formula>>,
    /// The velocity of the particles.
    pub motion: Field,
    /// The state at t = 0; `None` where the file of the particles holds it.
    pub initial: Option<Initial>,
    /// How many particles, and how they are placed.
    pub resolution: Resolution,
    /// The function that smears a particle; its width is the same for all and at all times,
    /// [`crate::Width::epsilon`] of the spacing at the start.
    pub cut_off: CutOff,
    /// How long, and in what steps.
    pub time: Time,
    /// What is written and measured.
    pub output: Output,
    /// The largest errors that a run may have; empty without `output.exact`.
    pub tolerances: Vec<Tolerance<Measured>>,
    /// The TOML text after `--set`, comments included: reading it gives this scenario.
    pub text: String,
}

impl LinearScenario {
    /// Reads a scenario that describes a linear system; `overrides` are `section.key=value`
    /// as given to `--set`, the later ones on top of the earlier.
    ///
    /// # Errors
    /// Whatever keeps the text from being a scenario: the first fault found, with
    /// its place and cure. A gas is one.
    pub fn read(source: Source, overrides: &[String]) -> Result<Self, ScenarioError> {
        check::read(&source, overrides, check::linear)
    }

    /// Whether the particles go with what they carry, so that nothing passes between them (2.2).
    pub fn is_carried(&self) -> bool {
        match &self.system {
            System::Transport { velocity, .. } => *velocity == self.motion,
            _ => false,
        }
    }
}

/// The scenario of a text.
pub(super) fn scenario(
    root: &Section<'_>,
    files: Files<'_>,
    text: &str,
) -> Result<LinearScenario, Fault> {
    let heading = heading::heading(root)?;
    let domain = heading.domain;
    let definitions = Definitions::of(root, heading.dimension)?;
    check_sides(root, &domain)?;
    let system = system::system(root, &domain, files, &definitions)?;
    check_walls(root, &domain, &system)?;
    let section = root.required("resolution")?.section()?;
    let resolution = resolution::resolution(&section, files.folder())?;
    let in_file = matches!(resolution.arrangement, Arrangement::File(_));
    let initial = match root.optional("initial") {
        None if in_file => None,
        None => return Err(root.missing("initial")),
        Some(entry) => {
            let section = entry.section()?;
            Some(initial::initial(&section, &system, &domain, &definitions)?)
        }
    };
    let source = source::source(root, &system, heading.dimension, &definitions)?;
    let (system, source, is_known) = match &initial {
        Some(Initial::Manufactured { state }) => {
            source::refuse(root, source.is_some())?;
            let (system, source) = manufactured::made(system, state, &domain);
            (system, source, true)
        }
        _ => {
            let is_known = source.is_none();
            (system, source, is_known)
        }
    };
    let output = output::output(
        root,
        &domain,
        (&system, initial.as_ref(), is_known),
        &definitions,
    )?;
    let time = time::time(&root.required("time")?.section()?, &system)?;
    Ok(LinearScenario {
        name: heading.name,
        description: heading.description,
        dimension: heading.dimension,
        units: heading.units,
        source,
        motion: field::motion(root, &system, &domain, &definitions)?,
        tolerances: output::tolerances(root, &output, &system, heading.dimension)?,
        system,
        initial,
        resolution,
        cut_off: cut_off::of_linear(root)?,
        time,
        output,
        domain,
        text: text.to_owned(),
    })
}

/// That a wall knows what is even and what is odd.
fn check_walls(root: &Section<'_>, domain: &Domain, system: &System) -> Result<(), Fault> {
    let is_wall = |sides: &[Side; 2]| sides.contains(&Side::Mirror);
    let axis = domain.sides.iter().position(is_wall);
    let is_unknown = matches!(
        system,
        System::Matrices { .. } | System::VariableMatrices { .. }
    );
    let Some(axis) = axis.filter(|_| is_unknown) else {
        return Ok(());
    };
    let sides = root.required("domain")?.section()?.required("sides")?;
    let directions = sides.directions(domain.sides.len())?;
    let reason = "matrices do not say which components change sign in a mirror".to_owned();
    Err(directions[axis].does_not_fit(reason, "write \"periodic\" or \"free\""))
}

/// That nothing is taken in or out.
fn check_sides(root: &Section<'_>, domain: &Domain) -> Result<(), Fault> {
    let Some(axis) = domain.open_direction() else {
        return Ok(());
    };
    let sides = root.required("domain")?.section()?.required("sides")?;
    let directions = sides.directions(domain.sides.len())?;
    let reason = "inflow and outflow are of a gas: what leaves a linear system depends on the \
                  characteristics of its matrices"
        .to_owned();
    Err(directions[axis].does_not_fit(reason, "write \"periodic\", \"mirror\" or \"free\""))
}
