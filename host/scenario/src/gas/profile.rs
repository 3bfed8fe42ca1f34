//! Profiles: states at t = 0 that vary from place to place, by name.

use motes_formula::Formula;

use super::material::{EquationOfState, Material};
use crate::bound::{AMPLITUDE, POSITIVE};
use crate::define::Definitions;
use crate::entry::{ANY, Entry};
use crate::error::Fault;
use crate::section::Section;
use crate::{Domain, Extent};

/// A state at t = 0 that fills the domain; an ideal gas, but [`Profile::Formula`]. Vortices and Noh's collapse are
/// centred at the origin.
#[derive(Debug, Clone, PartialEq)]
pub enum Profile {
    /// Gas that falls onto the origin (Noh, J. Comput. Phys. 72 (1987) 78).
    Noh {
        /// > 0.
        density: f64,
        /// Towards the origin, > 0.
        speed: f64,
        /// > 0; the exact solution is that of pressure 0.
        pressure: f64,
    },
    /// A sound wave along x, as long as the domain.
    SoundWave {
        /// Relative change of the density, in (-1, 1).
        amplitude: f64,
        /// > 0.
        density: f64,
        /// > 0.
        pressure: f64,
    },
    /// An isentropic vortex (Yee, Sandham & Djomehri, J. Comput. Phys. 150 (1999) 199);
    /// two-dimensional.
    YeeVortex {
        /// `beta`.
        strength: f64,
        /// Of the vortex as a whole.
        velocity: Vec<f64>,
    },
    /// A triangular vortex (Gresho & Chan, Int. J. Numer. Meth. Fluids 11 (1990) 621);
    /// two-dimensional.
    Gresho {
        /// Of the vortex as a whole.
        velocity: Vec<f64>,
        /// Mach number of the fastest gas, at r = 0.2: the pressure at the centre is
        /// `1/(gamma mach^2) - 1/2`, and 5 without it.
        mach: Option<f64>,
    },
    /// The shear layer of McNally, Lyra & Passy, Astrophys. J. Suppl. 201 (2012) 18;
    /// two-dimensional, in the unit square.
    KelvinHelmholtz,
    /// Vortices that turn against their neighbours and decay by viscosity (Taylor & Green, Proc. R. Soc.
    /// Lond. A 158 (1937) 499); two-dimensional, one wave of the domain along each direction.
    TaylorGreen {
        /// > 0.
        density: f64,
        /// The largest along x, > 0.
        speed: f64,
        /// Its mean, > 0.
        pressure: f64,
    },
    /// What formulas of the place say, at t = 0: boxes that fill the domain, each with its own.
    Formula(Vec<Piece>),
}

/// A box whose gas is given by formulas.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Its place.
    pub extent: Extent,
    /// What they say.
    pub state: StateFormulas,
}

/// The state of a gas as formulas of place and time.
#[derive(Debug, Clone, PartialEq)]
pub struct StateFormulas {
    /// > 0.
    pub density: Formula,
    /// One a direction.
    pub velocity: Vec<Formula>,
    /// `None` where the density alone gives it.
    pub pressure: Option<Formula>,
}

/// `density`, `velocity` and `pressure` of a section as formulas; the velocity is 0 unless told.
pub(super) fn state_formulas(
    section: &Section<'_>,
    law: &EquationOfState,
    dimension: usize,
    definitions: &Definitions<'_>,
) -> Result<StateFormulas, Fault> {
    let pressure = match (section.optional("pressure"), law.is_barotropic()) {
        (Some(entry), true) => {
            let reason = format!("{} has the pressure that the density gives", law.name());
            return Err(entry.does_not_fit(reason, "take `pressure` out"));
        }
        (None, true) => None,
        _ => Some(definitions.formula(&section.required("pressure")?)?),
    };
    let velocity = section.optional("velocity");
    let velocity = velocity.map(|entry| {
        let directions = entry.directions(dimension)?;
        let formulas = directions.iter().map(|entry| definitions.formula(entry));
        formulas.collect()
    });
    Ok(StateFormulas {
        density: definitions.formula(&section.required("density")?)?,
        velocity: velocity.unwrap_or(Ok(vec![Formula::constant(0.0); dimension]))?,
        pressure,
    })
}

impl Profile {
    /// Its name in a scenario.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Noh { .. } => "noh",
            Self::SoundWave { .. } => "sound-wave",
            Self::YeeVortex { .. } => "yee-vortex",
            Self::Gresho { .. } => "gresho",
            Self::KelvinHelmholtz => "kelvin-helmholtz",
            Self::TaylorGreen { .. } => "taylor-green",
            Self::Formula(_) => FORMULA,
        }
    }

    /// Whether its density is the same everywhere.
    pub fn is_uniform(&self) -> bool {
        match self {
            Self::Noh { .. } | Self::Gresho { .. } | Self::TaylorGreen { .. } => true,
            Self::Formula(pieces) => {
                let mut densities = pieces.iter().map(|piece| piece.state.density.value());
                let first = densities.next().flatten();
                first.is_some() && densities.all(|density| density == first)
            }
            _ => false,
        }
    }

    /// Whether the state at later times is known.
    pub fn has_solution(&self) -> bool {
        !matches!(self, Self::KelvinHelmholtz | Self::Formula(_))
    }
}

const FORMULA: &str = "formula";

/// The names of the profiles, with the keys that each takes.
const KINDS: [(&str, &[&str]); 7] = [
    ("noh", &["density", "speed", "pressure"]),
    ("sound-wave", &["amplitude", "density", "pressure"]),
    ("yee-vortex", &["strength", "velocity"]),
    ("gresho", &["velocity", "mach"]),
    ("kelvin-helmholtz", &[]),
    ("taylor-green", &["density", "speed", "pressure"]),
    (FORMULA, &["density", "velocity", "pressure"]),
];

/// `[profile]`.
pub(super) fn profile(
    entry: &Entry<'_>,
    domain: &Domain,
    materials: &[Material],
    definitions: &Definitions<'_>,
) -> Result<Profile, Fault> {
    let section = entry.section()?;
    let kind = section.required("kind")?;
    let (name, keys) = kind.choice(&KINDS.map(|kind| (kind.0, kind)))?;
    section.only(name, &["kind"], keys)?;
    if name == FORMULA {
        let dimension = domain.extent.lower.len();
        let state = state_formulas(&section, &materials[0].law, dimension, definitions)?;
        let extent = domain.extent.clone();
        return Ok(Profile::Formula(vec![Piece { extent, state }]));
    }
    let EquationOfState::IdealGas { gamma } = materials[0].law else {
        let reason = format!("the first material is {}", materials[0].law.name());
        let cure =
            "profiles but formula need equation-of-state = \"ideal-gas\" in the first material";
        return Err(kind.does_not_fit(reason, cure));
    };
    let dimension = domain.extent.lower.len();
    if dimension != 2 && !matches!(name, "noh" | "sound-wave") {
        let reason = format!("it is two-dimensional, dimension = {dimension}");
        return Err(kind.does_not_fit(
            reason,
            "set dimension = 2, or choose noh, sound-wave or formula",
        ));
    }
    let number = |key, bound| section.required(key)?.number(bound);
    Ok(match name {
        "noh" => Profile::Noh {
            density: number("density", POSITIVE)?,
            speed: number("speed", POSITIVE)?,
            pressure: number("pressure", POSITIVE)?,
        },
        "sound-wave" => {
            let amplitude = section.required("amplitude")?;
            let value = amplitude.number(AMPLITUDE)?;
            if !(gamma * value.abs() < 1.0) {
                let reason = format!(
                    "gamma * amplitude = {} takes the pressure to 0",
                    gamma * value
                );
                return Err(amplitude.does_not_fit(reason, "give an amplitude below 1/gamma"));
            }
            Profile::SoundWave {
                amplitude: value,
                density: number("density", POSITIVE)?,
                pressure: number("pressure", POSITIVE)?,
            }
        }
        "taylor-green" => Profile::TaylorGreen {
            density: number("density", POSITIVE)?,
            speed: number("speed", POSITIVE)?,
            pressure: number("pressure", POSITIVE)?,
        },
        "yee-vortex" => Profile::YeeVortex {
            strength: strength(&section.required("strength")?, gamma)?,
            velocity: velocity(&section, dimension)?,
        },
        "gresho" => Profile::Gresho {
            velocity: velocity(&section, dimension)?,
            mach: match section.optional("mach") {
                Some(entry) => Some(mach(&entry, gamma)?),
                None => None,
            },
        },
        _ => {
            let unit = domain.extent.lower == [0.0; 2] && domain.extent.upper == [1.0; 2];
            if !unit {
                let reason = "it fills the unit square, the domain is another".to_owned();
                let cure = "set domain.lower = [0.0, 0.0] and domain.upper = [1.0, 1.0]";
                return Err(kind.does_not_fit(reason, cure));
            }
            Profile::KelvinHelmholtz
        }
    })
}

fn velocity(section: &Section<'_>, dimension: usize) -> Result<Vec<f64>, Fault> {
    let entry = section.optional("velocity");
    entry.map_or(Ok(vec![0.0; dimension]), |entry| entry.vector(dimension))
}

/// A strength that leaves gas at the centre: the temperature there,
/// `1 - (gamma - 1) beta^2 e / (8 gamma pi^2)`, is above 0.
fn strength(entry: &Entry<'_>, gamma: f64) -> Result<f64, Fault> {
    let strength = entry.number(ANY)?;
    let pi = std::f64::consts::PI;
    let largest = (8.0 * gamma * pi * pi / ((gamma - 1.0) * std::f64::consts::E)).sqrt();
    if strength.abs() < largest {
        return Ok(strength);
    }
    let reason = format!("from {largest:.3} on the temperature at the centre falls to 0");
    Err(entry.does_not_fit(reason, "give a smaller strength; 5 is usual"))
}

/// A Mach number that leaves the centre a positive pressure: `1/(gamma mach^2)`.
fn mach(entry: &Entry<'_>, gamma: f64) -> Result<f64, Fault> {
    let mach = entry.number(POSITIVE)?;
    let pressure = 1.0 / (gamma * mach * mach);
    if pressure.is_finite() && pressure > 0.0 {
        return Ok(mach);
    }
    let reason = format!("the pressure at the centre would be {pressure}");
    Err(entry.does_not_fit(reason, "give a Mach number nearer to 1"))
}
