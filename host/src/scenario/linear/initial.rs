//! The state at t = 0, by name; each has a solution.

use super::{System, field};
use crate::scenario::bound::POSITIVE;
use crate::scenario::entry::{ANY, Entry};
use crate::scenario::error::Fault;
use crate::scenario::section::Section;
use crate::scenario::{Domain, Side};

/// A state at t = 0 of which the state at later times is known. `k` is
/// `2π (wave_x/length_x, wave_y/length_y, ..)`, the lengths those of the domain.
#[derive(Debug, Clone, PartialEq)]
pub enum Initial {
    /// `amplitude exp(-|x - center|²/width²)` in the first component, with its images in
    /// periodic directions, 0 in the others: transport; acoustics in one dimension without
    /// walls, and in two between free sides.
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
    /// `state cos(k·(x - lower))`: matrices between periodic sides.
    Modes {
        /// Whole wavelengths in the domain along each direction, not all 0.
        wave: Vec<i32>,
        /// The amplitude of each component.
        state: Vec<f64>,
    },
}

/// The names of the states, with the keys that each takes.
const KINDS: [(&str, &[&str]); 5] = [
    ("gaussian", &["center", "width", "amplitude"]),
    ("exp-sine", &[]),
    ("plane-wave", &["wave", "amplitude"]),
    ("standing-wave", &["wave", "amplitude"]),
    ("modes", &["wave", "state"]),
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
        (System::ConvectionDiffusion(_), _) => &["gaussian", "modes"],
        _ => &["plane-wave"],
    }
}

/// `[initial]`.
pub(super) fn initial(
    section: &Section<'_>,
    system: &System,
    domain: &Domain,
) -> Result<Initial, Fault> {
    let kind = section.required("kind")?;
    let (name, keys) = kind.choice(&KINDS.map(|kind| (kind.0, kind)))?;
    let dimension = domain.sides.len();
    let known = kinds_of(system, dimension);
    if !known.contains(&name) {
        let system = system.name();
        let reason = format!("{system} has no such state in dimension = {dimension}");
        let cure = format!("{system} has here: {}", known.join(", "));
        return Err(kind.does_not_fit(reason, &cure));
    }
    section.only(name, &["kind"], keys)?;
    check_sides(&kind, name, system, domain)?;
    let amplitude = || section.number_or("amplitude", 1.0, ANY);
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
        _ => Initial::Modes {
            wave: wave()?,
            state: state(&section.required("state")?, system.components(dimension))?,
        },
    })
}

/// That a wave fills the domain periodically, and that a round pulse meets no side.
fn check_sides(
    kind: &Entry<'_>,
    name: &str,
    system: &System,
    domain: &Domain,
) -> Result<(), Fault> {
    let is_sound = matches!(system, System::Acoustics { .. });
    let sides = || domain.sides.iter().flatten();
    let need = match (name, domain.sides.len()) {
        // Along a line the pulse has images, but no echo.
        ("gaussian", 1) if is_sound && sides().any(|&side| side == Side::Mirror) => Side::Free,
        ("gaussian", 2..) if is_sound => Side::Free,
        ("gaussian", _) => return Ok(()),
        _ => Side::Periodic,
    };
    if sides().all(|&side| side == need) {
        return Ok(());
    }
    let (word, why) = match need {
        Side::Free => ("free", "its solution is that of a pulse in the open"),
        _ => ("periodic", "it has whole wavelengths in the domain"),
    };
    let cure = format!("set all of domain.sides to \"{word}\", or choose another initial state");
    Err(kind.does_not_fit(why.to_owned(), &cure))
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
