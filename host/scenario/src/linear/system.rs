//! The systems of equations, by name.

use motes_formula::Formula;

use super::{ConvectionDiffusion, Field, Series, diffusion, field, matrices};
use crate::Domain;
use crate::bound::{GAMMA, NOT_NEGATIVE, POSITIVE};
use crate::define::Definitions;
use crate::entry::{ANY, Entry};
use crate::error::Fault;
use crate::files::Files;
use crate::geometry::AXES;
use crate::section::Section;

/// A linear first-order system. Its components, in their order, are those of [`System::names`].
#[derive(Debug, Clone, PartialEq)]
pub enum System {
    /// `∂u/∂t + div(v u) + decay u = source`: one quantity, carried by a velocity.
    Transport {
        /// `v`.
        velocity: Field,
        /// 1 / time, >= 0.
        decay: f64,
        /// Of the quantity, per time.
        source: f64,
    },
    /// `∂p/∂t + density c² div v = 0`, `∂v/∂t + grad p / density = 0`: pressure, velocity.
    Acoustics {
        /// > 0.
        density: f64,
        /// `c`, > 0.
        sound_speed: f64,
    },
    /// `C ∂v/∂t + ∂i/∂x + G v = 0`, `L ∂i/∂t + ∂v/∂x + R i = 0`: voltage, current; one
    /// dimension.
    Telegraph {
        /// `L`, per length, > 0.
        inductance: f64,
        /// `C`, per length, > 0.
        capacitance: f64,
        /// `R`, per length, >= 0.
        resistance: f64,
        /// `G`, per length, >= 0.
        conductance: f64,
    },
    /// `∂η/∂t + depth div v = 0`, `∂v/∂t + gravity grad η + coriolis (-v_y, v_x) = 0`:
    /// elevation, velocity; two dimensions.
    ShallowWater {
        /// > 0.
        gravity: f64,
        /// > 0.
        depth: f64,
        /// `f`, of either sign.
        coriolis: f64,
    },
    /// `ε ∂E/∂t = (∂_y H, -∂_x H)`, `μ ∂H/∂t = ∂_y E_x - ∂_x E_y`: electric field in the
    /// plane, magnetic field across it; two dimensions.
    MaxwellTe {
        /// `ε`, > 0.
        permittivity: f64,
        /// `μ`, > 0.
        permeability: f64,
    },
    /// `density ∂v/∂t = div s`, `∂s/∂t = lambda (div v) I + mu (grad v + grad vᵀ)`: velocity
    /// and stress in plane strain; two dimensions.
    ElasticWaves {
        /// > 0.
        density: f64,
        /// Lamé's first parameter, `lambda + mu > 0`.
        lambda: f64,
        /// The shear modulus, > 0.
        mu: f64,
    },
    /// Euler's equations about a uniform state: `r`, `v`, `p` are what density, velocity and
    /// pressure differ by. With `D = ∂/∂t + velocity·grad`: `D r + density div v = 0`,
    /// `D v + grad p / density = 0`, `D p + gamma pressure div v = 0`.
    LinearisedGas {
        /// Of the uniform state, > 0.
        density: f64,
        /// Of the uniform state, > 0.
        pressure: f64,
        /// > 1.
        gamma: f64,
        /// Of the uniform state.
        velocity: Vec<f64>,
    },
    /// `∂u/∂t + Σ_i flux_i ∂_i u + decay u = 0`.
    Matrices {
        /// How many, 1 to 8.
        components: usize,
        /// A direction: the matrix, row by row.
        flux: Vec<Vec<f64>>,
        /// Row by row.
        decay: Vec<f64>,
        /// What the components are called; no two alike.
        names: Vec<String>,
    },
    /// `∂u/∂t + Σ_i ∂_i(flux_i u) + decay u = 0`, matrices of place and time.
    VariableMatrices {
        /// How many, 1 to 8.
        components: usize,
        /// A direction: the matrix, row by row.
        flux: Vec<Vec<Formula>>,
        /// Row by row.
        decay: Vec<Formula>,
        /// What the components are called; no two alike.
        names: Vec<String>,
    },
    /// `∂u/∂t + div(a u) - div(b grad u) = f`: species that are carried, diffuse and react.
    ConvectionDiffusion(Box<ConvectionDiffusion>),
}

/// The one that has `[[wall]]`.
const DIFFUSION: &str = "convection-diffusion";

/// The names of the systems, with the keys that each takes and its dimension if it has one.
const KINDS: [(&str, &[&str], Option<usize>); 9] = [
    ("transport", &["velocity", "decay", "source"], None),
    ("acoustics", &["density", "sound-speed", "source"], None),
    (
        "telegraph",
        &[
            "inductance",
            "capacitance",
            "resistance",
            "conductance",
            "source",
        ],
        Some(1),
    ),
    (
        "shallow-water",
        &["gravity", "depth", "coriolis", "source"],
        Some(2),
    ),
    (
        "maxwell-te",
        &["permittivity", "permeability", "source"],
        Some(2),
    ),
    (
        "elastic-waves",
        &["density", "lambda", "mu", "source"],
        Some(2),
    ),
    (
        "linearised-gas",
        &["density", "pressure", "gamma", "velocity", "source"],
        None,
    ),
    (
        "matrices",
        &["components", "flux", "decay", "names", "source"],
        None,
    ),
    (
        DIFFUSION,
        &[
            "species",
            "diffusivity",
            "form",
            "mean",
            "velocity",
            "profile",
            "modulation",
            "tensor",
            "reaction",
        ],
        None,
    ),
];

impl System {
    /// Its name in a scenario.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Transport { .. } => "transport",
            Self::Acoustics { .. } => "acoustics",
            Self::Telegraph { .. } => "telegraph",
            Self::ShallowWater { .. } => "shallow-water",
            Self::MaxwellTe { .. } => "maxwell-te",
            Self::ElasticWaves { .. } => "elastic-waves",
            Self::LinearisedGas { .. } => "linearised-gas",
            Self::Matrices { .. } | Self::VariableMatrices { .. } => "matrices",
            Self::ConvectionDiffusion(_) => DIFFUSION,
        }
    }

    /// The fastest wave that runs through what carries it; 0 for [`System::Transport`] and
    /// [`System::ConvectionDiffusion`], and for matrices, whose eigenvalues tell.
    pub fn wave_speed(&self) -> f64 {
        match self {
            Self::Transport { .. }
            | Self::Matrices { .. }
            | Self::VariableMatrices { .. }
            | Self::ConvectionDiffusion(_) => 0.0,
            Self::Acoustics { sound_speed, .. } => *sound_speed,
            Self::Telegraph {
                inductance,
                capacitance,
                ..
            } => 1.0 / (inductance * capacitance).sqrt(),
            Self::ShallowWater { gravity, depth, .. } => (gravity * depth).sqrt(),
            Self::MaxwellTe {
                permittivity,
                permeability,
            } => 1.0 / (permittivity * permeability).sqrt(),
            Self::ElasticWaves {
                density,
                lambda,
                mu,
            } => ((lambda + 2.0 * mu) / density).sqrt(),
            Self::LinearisedGas {
                density,
                pressure,
                gamma,
                velocity,
            } => {
                let flow = velocity.iter().map(|u| u * u).sum::<f64>().sqrt();
                flow + (gamma * pressure / density).sqrt()
            }
        }
    }

    /// What drives its walls out of files, with the components that it drives.
    pub fn driven(&self) -> Vec<(usize, &Series)> {
        let Self::ConvectionDiffusion(of) = self else {
            return Vec::new();
        };
        let ends = of.walls.iter().flatten();
        let conditions = ends.flat_map(|species| species.iter().enumerate());
        let driven = conditions.filter_map(|(i, condition)| Some((i, condition.series()?)));
        driven.collect()
    }

    /// How many components its state has.
    pub fn components(&self, dimension: usize) -> usize {
        self.names(dimension).len()
    }

    /// What they are called in files, in their order.
    pub fn names(&self, dimension: usize) -> Vec<String> {
        let velocity = || vector("velocity", dimension);
        match self {
            Self::Transport { .. } => named(&["u"]),
            Self::Acoustics { .. } => [named(&["pressure"]), velocity()].concat(),
            Self::Telegraph { .. } => named(&["voltage", "current"]),
            Self::ShallowWater { .. } => [named(&["elevation"]), velocity()].concat(),
            Self::MaxwellTe { .. } => named(&["electric_x", "electric_y", "magnetic_z"]),
            Self::ElasticWaves { .. } => {
                let stress = named(&["stress_xx", "stress_yy", "stress_xy"]);
                [velocity(), stress].concat()
            }
            Self::LinearisedGas { .. } => {
                [named(&["density"]), velocity(), named(&["pressure"])].concat()
            }
            Self::Matrices { names, .. } | Self::VariableMatrices { names, .. } => names.clone(),
            Self::ConvectionDiffusion(diffusion) => diffusion.species.clone(),
        }
    }
}

fn named(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

fn vector(name: &str, dimension: usize) -> Vec<String> {
    let axes = AXES.iter().take(dimension);
    axes.map(|axis| format!("{name}_{axis}")).collect()
}

/// `[system]`.
pub(super) fn system(
    root: &Section<'_>,
    domain: &Domain,
    files: Files<'_>,
    definitions: &Definitions<'_>,
) -> Result<System, Fault> {
    let section = root.required("system")?.section()?;
    let kind = section.required("kind")?;
    let (name, keys, own) = kind.choice(&KINDS.map(|kind| (kind.0, kind)))?;
    section.only(name, &["kind"], keys)?;
    let dimension = domain.extent.lower.len();
    if let Some(own) = own.filter(|own| *own != dimension) {
        let reason = format!("{name} has dimension {own} only, dimension = {dimension}");
        let cure = format!("set dimension = {own}, or choose another system");
        return Err(kind.does_not_fit(reason, &cure));
    }
    if let Some(wall) = root.optional("wall").filter(|_| name != DIFFUSION) {
        let reason = format!("the walls of {name} are mirrors, and nothing else");
        return Err(wall.does_not_fit(reason, "take [[wall]] out: it is of convection-diffusion"));
    }
    if !matches!(name, "matrices" | DIFFUSION) {
        constants(&section, name, keys)?;
    }
    let number = |key, bound| section.number(key, bound);
    Ok(match name {
        "transport" => System::Transport {
            velocity: field::field(&section.required("velocity")?, domain, definitions)?,
            decay: section.number_or("decay", 0.0, NOT_NEGATIVE)?,
            source: match section.optional("source") {
                Some(entry) if !entry.is_text() && !entry.is_list() => entry.number(ANY)?,
                _ => 0.0,
            },
        },
        "acoustics" => System::Acoustics {
            density: section.number_or("density", 1.0, POSITIVE)?,
            sound_speed: section.number_or("sound-speed", 1.0, POSITIVE)?,
        },
        "telegraph" => System::Telegraph {
            inductance: number("inductance", POSITIVE)?,
            capacitance: number("capacitance", POSITIVE)?,
            resistance: section.number_or("resistance", 0.0, NOT_NEGATIVE)?,
            conductance: section.number_or("conductance", 0.0, NOT_NEGATIVE)?,
        },
        "shallow-water" => System::ShallowWater {
            gravity: number("gravity", POSITIVE)?,
            depth: number("depth", POSITIVE)?,
            coriolis: section.number_or("coriolis", 0.0, ANY)?,
        },
        "maxwell-te" => System::MaxwellTe {
            permittivity: number("permittivity", POSITIVE)?,
            permeability: number("permeability", POSITIVE)?,
        },
        "elastic-waves" => elastic_waves(&section)?,
        "linearised-gas" => System::LinearisedGas {
            density: number("density", POSITIVE)?,
            pressure: number("pressure", POSITIVE)?,
            gamma: number("gamma", GAMMA)?,
            velocity: velocity(&section, domain)?,
        },
        DIFFUSION => System::ConvectionDiffusion(Box::new(diffusion::convection_diffusion(
            root,
            &section,
            domain,
            files,
            definitions,
        )?)),
        _ => matrices::matrices(&section, dimension, definitions)?,
    })
}

/// That what a system by name takes is a number: its equations, its symmetriser and its walls are those of a medium that is
/// the same everywhere.
///
/// # Errors
/// A formula in any key but the source and the velocity of transport.
fn constants(section: &Section<'_>, name: &str, keys: &[&str]) -> Result<(), Fault> {
    let is_constant = |key: &&&str| **key != "source" && (name, **key) != ("transport", "velocity");
    let entries = keys
        .iter()
        .filter(is_constant)
        .filter_map(|key| section.optional(key));
    let Some(entry) = entries.into_iter().find(Entry::is_text) else {
        return Ok(());
    };
    let reason = format!("it is the same everywhere in a system of kind {name}");
    let cure = "give a number; kind = \"matrices\" takes formulas as entries of flux and decay, as in \
                flux = [[[0, \"c(x)\"], [\"c(x)\", 0]]] (docs/formulas.md)";
    Err(entry.does_not_fit(reason, cure))
}

fn elastic_waves(section: &Section<'_>) -> Result<System, Fault> {
    let entry = section.required("lambda")?;
    let lambda = entry.number(ANY)?;
    let mu = section.number("mu", POSITIVE)?;
    if !(lambda + mu > 0.0) {
        let reason = format!("lambda + mu = {} is not above 0", lambda + mu);
        return Err(entry.does_not_fit(reason, "give a lambda above -mu"));
    }
    Ok(System::ElasticWaves {
        density: section.number("density", POSITIVE)?,
        lambda,
        mu,
    })
}

/// The velocity of the uniform state, 0 unless told, which crosses no wall.
fn velocity(section: &Section<'_>, domain: &Domain) -> Result<Vec<f64>, Fault> {
    let dimension = domain.extent.lower.len();
    let Some(entry) = section.optional("velocity") else {
        return Ok(vec![0.0; dimension]);
    };
    let velocity = entry.vector(dimension)?;
    field::check_sides(
        &entry,
        &Field::Uniform {
            velocity: velocity.clone(),
        },
        domain,
    )?;
    Ok(velocity)
}
