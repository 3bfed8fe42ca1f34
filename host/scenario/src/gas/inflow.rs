//! The gas that comes in through a side of the domain.

use super::material::Material;
use super::region::{material, pressure};
use crate::bound::POSITIVE;
use crate::error::Fault;
use crate::geometry::AXES;
use crate::section::Section;
use crate::{Domain, Side};

use super::{Exact, Output};

/// What comes in through the inflow side.
#[derive(Debug, Clone, PartialEq)]
pub struct Inflow {
    /// Its substance: a place in the list of materials.
    pub material: usize,
    /// Mass / length^dimension, > 0.
    pub density: f64,
    /// Length / time; into the domain.
    pub velocity: Vec<f64>,
    /// Density * velocity^2; where the density alone gives it, what it gives.
    pub pressure: f64,
}

/// `[inflow]`, which goes with an inflow side.
pub(super) fn inflow(
    root: &Section<'_>,
    domain: &Domain,
    materials: &[Material],
) -> Result<Option<Inflow>, Fault> {
    let Some((axis, end)) = domain.inflow() else {
        return match root.optional("inflow") {
            None => Ok(None),
            Some(entry) => Err(entry.does_not_fit(
                "no side of the domain is an inflow".to_owned(),
                "take [inflow] out, or write for example sides = [[\"inflow\", \"outflow\"]]",
            )),
        };
    };
    let Some(entry) = root.optional("inflow") else {
        let sides = root.required("domain")?.section()?.required("sides")?;
        return Err(sides.does_not_fit(
            "there is no [inflow] to say what comes in".to_owned(),
            "add [inflow] with density, velocity and pressure",
        ));
    };
    let section = entry.section()?;
    let material = material(&section, materials)?;
    let density = section.required("density")?.number(POSITIVE)?;
    let entry = section.required("velocity")?;
    let velocity = entry.vector(domain.extent.lower.len())?;
    let inward = [1.0, -1.0][end] * velocity[axis];
    if !(inward > 0.0) {
        let (side, sign) = [("lower", "positive"), ("upper", "negative")][end];
        let reason = format!("it comes in at the {side} side along {}", AXES[axis]);
        let cure = format!(
            "make it point into the domain: a {sign} number along {}",
            AXES[axis]
        );
        return Err(entry.does_not_fit(reason, &cure));
    }
    Ok(Some(Inflow {
        material,
        density,
        velocity,
        pressure: pressure(&section, &materials[material].law, density)?,
    }))
}

/// That the reference solution is not asked for what it does not know.
pub(super) fn check_output(
    root: &Section<'_>,
    domain: &Domain,
    output: &Output,
) -> Result<(), Fault> {
    let (Some(Exact::Reference), Some(_)) = (output.exact, domain.inflow()) else {
        return Ok(());
    };
    let entry = root.required("output")?.section()?.required("exact")?;
    let reason = "the reference solution knows no inflow".to_owned();
    Err(entry.does_not_fit(reason, "leave `exact` out, or use sides without an inflow"))
}

impl Domain {
    /// The direction with inflow or outflow sides.
    pub fn open_direction(&self) -> Option<usize> {
        let is_open = |sides: &[Side; 2]| sides.iter().any(|side| side.is_open());
        self.sides.iter().position(is_open)
    }

    /// The direction and end (0: lower, 1: upper) of the inflow side.
    pub fn inflow(&self) -> Option<(usize, usize)> {
        let axis = self.open_direction()?;
        let end = self.sides[axis]
            .iter()
            .position(|&side| side == Side::Inflow)?;
        Some((axis, end))
    }
}
