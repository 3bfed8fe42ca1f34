//! The state at t = 0, by name.

use motes_formula::Formula;

use super::sides::check_sides;
use super::{Conductor, System, field};
use crate::Domain;
use crate::bound::POSITIVE;
use crate::define::Definitions;
use crate::entry::{ANY, Entry};
use crate::error::Fault;
use crate::geometry::point_inside;
use crate::section::Section;

/// A state at t = 0. That at later times is known, but not always of convection-diffusion
/// ([`Initial::has_solution`]). `k` is
/// `2π (wave_x/length_x, wave_y/length_y, ..)`, the lengths those of the domain.
#[derive(Debug, Clone, PartialEq)]
pub enum Initial {
    /// `amplitude exp(-|x - center|²/width²)` in the first component, with its images in
    /// periodic directions, 0 in the others: transport; acoustics in one dimension without
    /// walls, and in two between free sides; convection-diffusion.
    Gaussian {
        /// The middle of the domain unless told.
        center: Vec<f64>,
        /// > 0.
        width: f64,
        /// Of the first component.
        amplitude: f64,
    },
    /// `exp(sin(2π (x - lower)/length))` in the first component, 0 in the others: acoustics
    /// in one dimension between periodic sides.
    ExpSine,
    /// A wave that runs along `k`: acoustics, shallow-water, elastic-waves, linearised-gas
    /// between periodic sides.
    PlaneWave {
        /// Whole wavelengths in the domain along each direction, not all 0.
        wave: Vec<i32>,
        /// Of the pressure; the elevation; the velocity; the density.
        amplitude: f64,
    },
    /// A wave that stands: telegraph and maxwell-te between periodic sides.
    StandingWave {
        /// Whole wavelengths in the domain along each direction, not all 0.
        wave: Vec<i32>,
        /// Of the voltage; the magnetic field.
        amplitude: f64,
    },
    /// `state cos(k·(x - lower))`: matrices between periodic sides, convection-diffusion
    /// between periodic ones and walls that let nothing through.
    Modes {
        /// Whole wavelengths in the domain along each direction, not all 0.
        wave: Vec<i32>,
        /// The amplitude of each component.
        state: Vec<f64>,
    },
    /// The same everywhere: convection-diffusion, as all that follow.
    Uniform {
        /// One number a species.
        state: Vec<f64>,
    },
    /// `amplitude/2 (erf((s + length/2)/width) - erf((s - length/2)/width))` in the first
    /// species, `s = x - center` along x, with its images in a periodic direction; 0 in the
    /// others.
    Band {
        /// A coordinate along x.
        center: f64,
        /// From edge to edge, > 0.
        length: f64,
        /// Of an edge, > 0.
        width: f64,
        /// Of the first species.
        amplitude: f64,
    },
    /// `amplitude P_degree((x - center)/radius)` in the first species, center and radius those
    /// of the parabola of the diffusivity, 0 in the others: one dimension.
    Legendre {
        /// Up to 32.
        degree: u32,
        /// Of the first species.
        amplitude: f64,
    },
    /// What formulas of the place say, at t = 0: every system.
    Formula {
        /// One a component.
        state: Vec<Formula>,
    },
    /// What formulas say at t = 0, and at all times: the source is made so. Every system.
    Manufactured {
        /// `u(x,t)`, one a component.
        state: Vec<Formula>,
    },
    /// `background + (spot - background) exp(-|x - c|²/width²)`, `c` the nearest centre.
    Spots {
        /// One number a species.
        background: Vec<f64>,
        /// One number a species.
        spot: Vec<f64>,
        /// Points of the domain, at least one.
        centers: Vec<Vec<f64>>,
        /// > 0.
        width: f64,
    },
}

/// The states that every system has.
const FORMULA: &str = "formula";
const MANUFACTURED: &str = "manufactured";

/// The names of the states, with the keys that each takes.
const KINDS: [(&str, &[&str]); 11] = [
    ("gaussian", &["center", "width", "amplitude"]),
    ("exp-sine", &[]),
    ("plane-wave", &["wave", "amplitude"]),
    ("standing-wave", &["wave", "amplitude"]),
    ("modes", &["wave", "state"]),
    ("uniform", &["state"]),
    ("band", &["center", "length", "width", "amplitude"]),
    ("legendre", &["degree", "amplitude"]),
    ("spots", &["background", "spot", "centers", "width"]),
    (FORMULA, &["state"]),
    (MANUFACTURED, &["state"]),
];

impl Initial {
    /// Its name in a scenario.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Gaussian { .. } => "gaussian",
            Self::ExpSine => "exp-sine",
            Self::PlaneWave { .. } => "plane-wave",
            Self::StandingWave { .. } => "standing-wave",
            Self::Modes { .. } => "modes",
            Self::Uniform { .. } => "uniform",
            Self::Band { .. } => "band",
            Self::Legendre { .. } => "legendre",
            Self::Spots { .. } => "spots",
            Self::Formula { .. } => FORMULA,
            Self::Manufactured { .. } => MANUFACTURED,
        }
    }
}

/// The initial states of a system.
fn kinds_of(system: &System, dimension: usize) -> &'static [&'static str] {
    match (system, dimension) {
        (System::Transport { .. }, _) => &["gaussian"],
        (System::Acoustics { .. }, 1) => &["gaussian", "exp-sine", "plane-wave"],
        (System::Acoustics { .. }, 2) => &["gaussian", "plane-wave"],
        (System::Telegraph { .. } | System::MaxwellTe { .. }, _) => &["standing-wave"],
        (System::Matrices { .. }, _) => &["modes"],
        (System::VariableMatrices { .. }, _) => &[],
        (System::ConvectionDiffusion(_), 1) => {
            &["gaussian", "modes", "uniform", "band", "legendre", "spots"]
        }
        (System::ConvectionDiffusion(_), _) => &["gaussian", "modes", "uniform", "band", "spots"],
        _ => &["plane-wave"],
    }
}

/// `[initial]`.
pub(super) fn initial(
    section: &Section<'_>,
    system: &System,
    domain: &Domain,
    definitions: &Definitions<'_>,
) -> Result<Initial, Fault> {
    let kind = section.required("kind")?;
    let (name, keys) = kind.choice(&KINDS.map(|kind| (kind.0, kind)))?;
    let dimension = domain.sides.len();
    let known = kinds_of(system, dimension);
    if ![FORMULA, MANUFACTURED].contains(&name) && !known.contains(&name) {
        let system = system.name();
        let reason = format!("{system} has no such state in dimension = {dimension}");
        let cure = format!(
            "{system} has here: {}",
            [known, &[FORMULA, MANUFACTURED]].concat().join(", ")
        );
        return Err(kind.does_not_fit(reason, &cure));
    }
    section.only(name, &["kind"], keys)?;
    if let FORMULA | MANUFACTURED = name {
        let components = system.components(dimension);
        let state = definitions.formulas(&section.required("state")?, components)?;
        if name == FORMULA {
            return Ok(Initial::Formula { state });
        }
        check_layers(&kind, system)?;
        return Ok(Initial::Manufactured { state });
    }
    check_sides(&kind, name, system, domain)?;
    let amplitude = || section.number_or("amplitude", 1.0, ANY);
    let components = |key| state(&section.required(key)?, system.components(dimension));
    let wave = || wave(&section.required("wave")?, dimension);
    Ok(match name {
        "gaussian" => Initial::Gaussian {
            center: field::center(section, domain)?,
            width: section.number("width", POSITIVE)?,
            amplitude: amplitude()?,
        },
        "exp-sine" => Initial::ExpSine,
        "plane-wave" => Initial::PlaneWave {
            wave: wave()?,
            amplitude: amplitude()?,
        },
        "standing-wave" => Initial::StandingWave {
            wave: wave()?,
            amplitude: amplitude()?,
        },
        "modes" => Initial::Modes {
            wave: wave()?,
            state: components("state")?,
        },
        "uniform" => Initial::Uniform {
            state: components("state")?,
        },
        "band" => Initial::Band {
            center: along_x(section, domain)?,
            length: section.number("length", POSITIVE)?,
            width: section.number("width", POSITIVE)?,
            amplitude: amplitude()?,
        },
        "legendre" => Initial::Legendre {
            degree: degree(&section.required("degree")?)?,
            amplitude: amplitude()?,
        },
        _ => Initial::Spots {
            background: components("background")?,
            spot: components("spot")?,
            centers: centers(&section.required("centers")?, domain)?,
            width: section.number("width", POSITIVE)?,
        },
    })
}

/// That a diffusivity has no jumps: what a jump does to a smooth state, no formula says.
fn check_layers(kind: &Entry<'_>, system: &System) -> Result<(), Fault> {
    match system {
        System::ConvectionDiffusion(of) if matches!(of.profile, Conductor::Layers { .. }) => {
            let reason = "the diffusivity has layers, across which no smooth state solves it";
            let cure = "choose another profile, or kind = \"formula\"";
            Err(kind.does_not_fit(reason.to_owned(), cure))
        }
        _ => Ok(()),
    }
}

/// A coordinate along x, the middle of the domain unless told.
fn along_x(section: &Section<'_>, domain: &Domain) -> Result<f64, Fault> {
    let Some(entry) = section.optional("center") else {
        return Ok(domain.extent.middle(0));
    };
    // Of a Gaussian the same key is a point.
    let example = "center = 0.0";
    Entry { example, ..entry }.number(ANY)
}

fn degree(entry: &Entry<'_>) -> Result<u32, Fault> {
    entry.whole(0..=32, "0 to 32", "give the degree of the polynomial")
}

fn centers(entry: &Entry<'_>, domain: &Domain) -> Result<Vec<Vec<f64>>, Fault> {
    let entries = entry.list("a list of points")?;
    if entries.is_empty() {
        let reason = "spots without a centre are none".to_owned();
        return Err(entry.does_not_fit(reason, "give one point at least, or kind = \"uniform\""));
    }
    let center = |entry: &Entry<'_>| point_inside(entry, &domain.extent);
    entries.iter().map(center).collect()
}

/// Whole wavelengths, not all 0.
fn wave(entry: &Entry<'_>, dimension: usize) -> Result<Vec<i32>, Fault> {
    const MOST: i32 = 1_000_000;
    let whole = |entry: &Entry<'_>| {
        let cure = "give the number of wavelengths in the domain along each direction";
        entry.whole(-MOST..=MOST, "-1000000 to 1000000", cure)
    };
    let directions = entry.directions(dimension)?;
    let wave: Vec<i32> = directions.iter().map(whole).collect::<Result<_, _>>()?;
    if wave.iter().all(|&number| number == 0) {
        let reason = "a wave without wavelengths is none".to_owned();
        return Err(entry.does_not_fit(reason, "give one number at least that is not 0"));
    }
    Ok(wave)
}

/// One amplitude a component.
fn state(entry: &Entry<'_>, components: usize) -> Result<Vec<f64>, Fault> {
    let entries = entry.list("a list with one number a component")?;
    if entries.len() != components {
        let found = entries.len();
        let reason = format!("its length is {found}, components = {components}");
        return Err(entry.does_not_fit(reason, "give one number a component"));
    }
    entries.iter().map(|entry| entry.number(ANY)).collect()
}
