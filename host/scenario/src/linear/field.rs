//! Fields of velocities: what the particles follow, and what carries a transported quantity.

use motes_formula::Formula;

use super::System;
use crate::define::Definitions;
use crate::entry::{ANY, Entry};
use crate::error::Fault;
use crate::geometry::AXES;
use crate::section::Section;
use crate::{Domain, Extent, Side};

/// A field of velocities `a(x)`.
#[derive(Debug, Clone, PartialEq)]
pub enum Field {
    /// `a = 0`.
    Still,
    /// The same everywhere.
    Uniform {
        /// Length / time.
        velocity: Vec<f64>,
    },
    /// `a = rate (-(y - c_y), x - c_x)`, about an axis along z; two and three dimensions.
    Rotation {
        /// Radians / time, counterclockwise.
        rate: f64,
        /// `c`.
        center: Vec<f64>,
    },
    /// `a_x = rate (y - c_y)`; two and three dimensions.
    Shear {
        /// 1 / time.
        rate: f64,
        /// `c`.
        center: Vec<f64>,
    },
    /// `a = -rate (x - c)`, in every direction.
    Compression {
        /// 1 / time; below 0 it expands.
        rate: f64,
        /// `c`.
        center: Vec<f64>,
    },
    /// `a_x = amplitude sin(2π (x - lower)/(upper - lower))`, lower and upper those of the
    /// domain along x.
    Wave {
        /// Length / time.
        amplitude: f64,
    },
    /// What formulas of place and time say.
    Formula(FormulaField),
}

/// A field of velocities given as formulas, and its slopes, made from them.
#[derive(Debug, Clone, PartialEq)]
pub struct FormulaField {
    /// `a_i`, one a direction.
    pub velocity: Vec<Formula>,
    /// `∂_j a_i`, one a direction, row by row.
    pub slopes: Vec<Formula>,
}

impl FormulaField {
    fn new(velocity: Vec<Formula>) -> Self {
        let directions = 0..velocity.len();
        let slopes = velocity
            .iter()
            .flat_map(|of| directions.clone().map(|j| of.derivative(j)));
        Self {
            slopes: slopes.collect(),
            velocity,
        }
    }

    /// `a` at a point and a time.
    pub fn at(&self, point: [f64; 4]) -> Vec<f64> {
        self.velocity.iter().map(|of| of.at(&point)).collect()
    }

    /// Calls a function at points of the domain, on its sides too, at a few times.
    fn all_over(extent: &Extent, mut of: impl FnMut([f64; 4])) {
        const POINTS: usize = 9;
        const TIMES: [f64; 3] = [0.0, 0.3, 1.0];
        let dimension = extent.lower.len();
        for mut number in 0..POINTS.pow(dimension as u32) {
            let mut point = [0.0; 4];
            for (i, x) in point.iter_mut().enumerate().take(dimension) {
                let part = (number % POINTS) as f64 / (POINTS - 1) as f64;
                *x = (1.0 - part) * extent.lower[i] + part * extent.upper[i];
                number /= POINTS;
            }
            for time in TIMES {
                point[3] = time;
                of(point);
            }
        }
    }

    /// The largest of some numbers of the two ends of a direction, in the largest speed anywhere.
    fn largest(&self, extent: &Extent, axis: usize, of: impl Fn([Vec<f64>; 2]) -> f64) -> f64 {
        let (mut largest, mut speed) = (0.0f64, 0.0f64);
        Self::all_over(extent, |point| {
            let here = self.at(point);
            speed = here.iter().fold(speed, |speed, u| speed.max(u.abs()));
            if point[axis] == extent.lower[axis] {
                let mut opposite = point;
                opposite[axis] = extent.upper[axis];
                largest = largest.max(of([here, self.at(opposite)]));
            }
        });
        if speed > 0.0 { largest / speed } else { 0.0 }
    }
}

/// The part of the largest speed that is taken for rounding.
const ROUNDING: f64 = 1e-9;

/// The names of the fields, with the keys that each takes.
const KINDS: [(&str, &[&str]); 7] = [
    ("still", &[]),
    ("uniform", &["velocity"]),
    ("rotation", &["rate", "center"]),
    ("shear", &["rate", "center"]),
    ("compression", &["rate", "center"]),
    ("wave", &["amplitude"]),
    (FORMULA, &["velocity"]),
];

const FORMULA: &str = "formula";

/// What the particles of a transported quantity do unless told, and those of convection-diffusion
/// always: they go with it.
const FLOW: &str = "flow";

impl Field {
    /// Its name in a scenario.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Still => "still",
            Self::Uniform { .. } => "uniform",
            Self::Rotation { .. } => "rotation",
            Self::Shear { .. } => "shear",
            Self::Compression { .. } => "compression",
            Self::Wave { .. } => "wave",
            Self::Formula(_) => FORMULA,
        }
    }

    /// Whether it crosses the side of the domain in a direction at an end (0: lower, 1: upper).
    fn crosses(&self, axis: usize, end: usize, domain: &Domain) -> bool {
        match self {
            Self::Still | Self::Wave { .. } => false,
            Self::Uniform { velocity } => velocity[axis] != 0.0,
            Self::Rotation { rate, .. } => axis < 2 && *rate != 0.0,
            Self::Shear { rate, .. } => axis == 0 && *rate != 0.0,
            Self::Compression { rate, center } => {
                let side = [&domain.extent.lower, &domain.extent.upper][end][axis];
                *rate != 0.0 && side != center[axis]
            }
            Self::Formula(field) => {
                let across = |ends: [Vec<f64>; 2]| ends[end][axis].abs();
                field.largest(&domain.extent, axis, across) > ROUNDING
            }
        }
    }

    /// Whether it may go on at the other side of a periodic direction.
    fn goes_on(&self, axis: usize, domain: &Domain) -> bool {
        match self {
            Self::Still | Self::Uniform { .. } | Self::Wave { .. } => true,
            Self::Rotation { rate, .. } | Self::Shear { rate, .. } => axis >= 2 || *rate == 0.0,
            Self::Compression { rate, .. } => *rate == 0.0,
            Self::Formula(field) => {
                let jump = |[a, b]: [Vec<f64>; 2]| {
                    let jumps = a.iter().zip(&b).map(|(a, b)| (a - b).abs());
                    jumps.fold(0.0, f64::max)
                };
                field.largest(&domain.extent, axis, jump) <= ROUNDING
            }
        }
    }
}

/// `[motion]`.
pub(super) fn motion(
    root: &Section<'_>,
    system: &System,
    domain: &Domain,
    definitions: &Definitions<'_>,
) -> Result<Field, Fault> {
    let usual = match system {
        System::Transport { velocity, .. } => velocity,
        System::ConvectionDiffusion(diffusion) => &diffusion.velocity,
        _ => &Field::Still,
    };
    let Some(entry) = root.optional("motion") else {
        return Ok(usual.clone());
    };
    let section = entry.section()?;
    let kind = section.required("kind")?;
    let is_diffusion = matches!(system, System::ConvectionDiffusion(_));
    if kind.text()? != FLOW {
        if is_diffusion {
            let reason = "diffusion runs on particles that follow the velocity of the system";
            let cure =
                "set kind = \"flow\", or take [motion] out: system.velocity says how they move";
            return Err(kind.does_not_fit(reason.to_owned(), cure));
        }
        return field(&entry, domain, definitions);
    }
    if !is_diffusion && !matches!(system, System::Transport { .. }) {
        let reason = format!("{} has no velocity that could be followed", system.name());
        return Err(kind.does_not_fit(reason, "set kind = \"still\", or give another field"));
    }
    Ok(usual.clone())
}

/// A field that goes with the sides of the domain.
pub(super) fn field(
    entry: &Entry<'_>,
    domain: &Domain,
    definitions: &Definitions<'_>,
) -> Result<Field, Fault> {
    if entry.is_list() {
        let field = formulas(entry, domain, definitions)?;
        check_sides(entry, &field, domain)?;
        return Ok(field);
    }
    let section = entry.section()?;
    let kind = section.required("kind")?;
    let (name, keys) = kind.choice(&KINDS.map(|kind| (kind.0, kind)))?;
    if name == "still" {
        // Whatever else there is, so that `--set motion.kind=still` alone stops the particles.
        return Ok(Field::Still);
    }
    section.only(name, &["kind"], keys)?;
    let dimension = domain.extent.lower.len();
    if dimension == 1 && matches!(name, "rotation" | "shear") {
        let reason = "it takes two directions at least, dimension = 1".to_owned();
        let cure = "choose still, uniform, compression or wave, or another dimension";
        return Err(kind.does_not_fit(reason, cure));
    }
    let rate = || section.number("rate", ANY);
    let center = || center(&section, domain);
    let field = match name {
        "uniform" => Field::Uniform {
            velocity: section.required("velocity")?.vector(dimension)?,
        },
        "rotation" => Field::Rotation {
            rate: rate()?,
            center: center()?,
        },
        "shear" => Field::Shear {
            rate: rate()?,
            center: center()?,
        },
        "compression" => Field::Compression {
            rate: rate()?,
            center: center()?,
        },
        FORMULA => formulas(&section.required("velocity")?, domain, definitions)?,
        _ => Field::Wave {
            amplitude: section.number("amplitude", ANY)?,
        },
    };
    check_sides(&kind, &field, domain)?;
    Ok(field)
}

/// A list with a formula a direction.
fn formulas(
    entry: &Entry<'_>,
    domain: &Domain,
    definitions: &Definitions<'_>,
) -> Result<Field, Fault> {
    let directions = entry.directions(domain.extent.lower.len())?;
    let formulas = directions.iter().map(|entry| definitions.formula(entry));
    let formulas: Vec<Formula> = formulas.collect::<Result<_, _>>()?;
    let constants: Option<Vec<f64>> = formulas.iter().map(Formula::value).collect();
    Ok(match constants {
        Some(velocity) if velocity.iter().all(|u| u.is_finite()) => Field::Uniform { velocity },
        _ => Field::Formula(FormulaField::new(formulas)),
    })
}

/// A point, in the middle of the domain unless told.
pub(super) fn center(section: &Section<'_>, domain: &Domain) -> Result<Vec<f64>, Fault> {
    let extent = &domain.extent;
    match section.optional("center") {
        Some(entry) => entry.vector(extent.lower.len()),
        None => {
            let corners = extent.lower.iter().zip(&extent.upper);
            Ok(corners
                .map(|(lower, upper)| 0.5 * lower + 0.5 * upper)
                .collect())
        }
    }
}

/// That what flows across a side may do so, and that what is periodic has no jump.
pub(super) fn check_sides(kind: &Entry<'_>, field: &Field, domain: &Domain) -> Result<(), Fault> {
    for (axis, sides) in domain.sides.iter().enumerate() {
        let name = AXES[axis];
        if sides[0] == Side::Periodic && !field.goes_on(axis, domain) {
            let reason = format!("it differs at the two periodic sides along {name}");
            let cure = format!("set the sides along {name} to \"free\", or choose another field");
            return Err(kind.does_not_fit(reason, &cure));
        }
        for (end, &side) in sides.iter().enumerate() {
            if side == Side::Mirror && field.crosses(axis, end, domain) {
                let wall = ["lower", "upper"][end];
                let reason = format!("it crosses the {wall} wall along {name}");
                let cure =
                    format!("set the sides along {name} to \"free\", or choose another field");
                return Err(kind.does_not_fit(reason, &cure));
            }
        }
    }
    Ok(())
}
