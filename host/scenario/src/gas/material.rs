//! The substances of a scenario and their equations of state.

use crate::bound::{GAMMA, NOT_NEGATIVE, POSITIVE};
use crate::error::Fault;
use crate::section::Section;

/// A substance.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// What regions call it; the name of its equation of state where the only material has
    /// none of its own.
    pub name: String,
    /// Its equation of state.
    pub law: EquationOfState,
}

/// An equation of state: pressure `p` from density `rho` and internal energy per mass `e`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EquationOfState {
    /// `p = (gamma - 1) rho e`.
    IdealGas {
        /// Ratio of the specific heats, > 1.
        gamma: f64,
    },
    /// `p = (gamma - 1) rho e - gamma p_inf`.
    StiffenedGas {
        /// Ratio of the specific heats, > 1.
        gamma: f64,
        /// `p_inf`, >= 0.
        pressure_at_infinity: f64,
    },
    /// `p = c^2 rho`; the energy plays no part.
    Isothermal {
        /// `c`, > 0.
        sound_speed: f64,
    },
    /// `p = B ((rho/rho_0)^n - 1)`, `B = rho_0 c_0^2/n`; the energy plays no part.
    Tait {
        /// `rho_0`, the density without pressure, > 0.
        density: f64,
        /// `c_0`, the sound speed at `rho_0`, > 0.
        sound_speed: f64,
        /// `n`, 1 to 15.
        exponent: u32,
    },
}

impl EquationOfState {
    /// Its name in a scenario.
    pub fn name(&self) -> &'static str {
        match self {
            Self::IdealGas { .. } => "ideal-gas",
            Self::StiffenedGas { .. } => "stiffened-gas",
            Self::Isothermal { .. } => "isothermal",
            Self::Tait { .. } => "tait",
        }
    }

    /// Whether the density alone gives the pressure.
    pub fn is_barotropic(&self) -> bool {
        matches!(self, Self::Isothermal { .. } | Self::Tait { .. })
    }

    /// The pressure at a density and an internal energy per mass.
    pub fn pressure(&self, density: f64, energy: f64) -> f64 {
        match *self {
            Self::IdealGas { gamma } => (gamma - 1.0) * density * energy,
            Self::StiffenedGas {
                gamma,
                pressure_at_infinity,
            } => (gamma - 1.0) * density * energy - gamma * pressure_at_infinity,
            Self::Isothermal { sound_speed } => sound_speed * sound_speed * density,
            Self::Tait {
                density: reference,
                sound_speed,
                exponent,
            } => {
                let stiffness = reference * sound_speed * sound_speed / f64::from(exponent);
                // Multiplications, not `powi`: its bits may differ between platforms.
                let power = (0..exponent).fold(1.0, |power, _| power * (density / reference));
                stiffness * (power - 1.0)
            }
        }
    }

    /// The square of the sound speed; 0 where it would be negative.
    pub fn sound_speed_squared(&self, density: f64, energy: f64) -> f64 {
        let squared = match *self {
            Self::IdealGas { gamma } => gamma * self.pressure(density, energy) / density,
            Self::StiffenedGas {
                gamma,
                pressure_at_infinity,
            } => gamma * (self.pressure(density, energy) + pressure_at_infinity) / density,
            Self::Isothermal { sound_speed } => sound_speed * sound_speed,
            Self::Tait {
                density: reference,
                sound_speed,
                exponent,
            } => {
                let power = (1..exponent).fold(1.0, |power, _| power * (density / reference));
                sound_speed * sound_speed * power
            }
        };
        squared.max(0.0)
    }

    /// The internal energy per mass at a density and a pressure; 0 where it plays no part.
    pub fn energy(&self, density: f64, pressure: f64) -> f64 {
        match *self {
            Self::IdealGas { gamma } => pressure / ((gamma - 1.0) * density),
            Self::StiffenedGas {
                gamma,
                pressure_at_infinity,
            } => (pressure + gamma * pressure_at_infinity) / ((gamma - 1.0) * density),
            Self::Isothermal { .. } | Self::Tait { .. } => 0.0,
        }
    }
}

/// Materials are numbered in a byte.
const MOST: usize = 256;

/// The names of the equations of state, with the keys that each takes.
const LAWS: [(&str, &[&str]); 4] = [
    ("ideal-gas", &["gamma"]),
    ("stiffened-gas", &["gamma", "pressure-at-infinity"]),
    ("isothermal", &["sound-speed"]),
    ("tait", &["density", "sound-speed", "exponent"]),
];

/// `[material]`, or every `[[material]]`: at least one, their names unequal.
pub(super) fn materials(root: &Section<'_>) -> Result<Vec<Material>, Fault> {
    let entry = root.required("material")?;
    if entry.is_section() {
        let section = entry.section()?;
        let law = law(&section)?;
        let name = section.optional("name");
        let name = name
            .map_or(Ok(law.name()), |entry| entry.text())?
            .to_owned();
        return Ok(vec![Material { name, law }]);
    }
    let mut materials: Vec<Material> = Vec::new();
    for entry in entry.list("a [material], or one or more [[material]]")? {
        let section = entry.section()?;
        let name_entry = section.required("name")?;
        let name = name_entry.text()?.to_owned();
        if let Some(first) = materials.iter().position(|other| other.name == name) {
            let reason = format!("material.{first} has the same name");
            return Err(name_entry.does_not_fit(reason, "give every material a name of its own"));
        }
        if materials.len() == MOST {
            let reason = format!("there can be {MOST} materials");
            return Err(name_entry.does_not_fit(reason, "use fewer materials"));
        }
        let law = law(&section)?;
        materials.push(Material { name, law });
    }
    if materials.is_empty() {
        return Err(root.missing("material"));
    }
    Ok(materials)
}

fn law(section: &Section<'_>) -> Result<EquationOfState, Fault> {
    let entry = section.required("equation-of-state")?;
    let (name, keys) = entry.choice(&LAWS.map(|law| (law.0, law)))?;
    section.only(name, &["equation-of-state", "name"], keys)?;
    let number = |key, bound| section.required(key)?.number(bound);
    Ok(match name {
        "ideal-gas" => EquationOfState::IdealGas {
            gamma: number("gamma", GAMMA)?,
        },
        "stiffened-gas" => EquationOfState::StiffenedGas {
            gamma: number("gamma", GAMMA)?,
            pressure_at_infinity: number("pressure-at-infinity", NOT_NEGATIVE)?,
        },
        "isothermal" => EquationOfState::Isothermal {
            sound_speed: number("sound-speed", POSITIVE)?,
        },
        _ => EquationOfState::Tait {
            density: number("density", POSITIVE)?,
            sound_speed: number("sound-speed", POSITIVE)?,
            exponent: section.required("exponent")?.whole(
                1..=15,
                "1 to 15",
                "give a whole number: 7 for water",
            )?,
        },
    })
}
