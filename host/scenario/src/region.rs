//! The regions of uniform gas at t = 0, and the energy deposited in it.

use super::bound::POSITIVE;
use super::entry::{ANY, Entry};
use super::error::Fault;
use super::geometry;
use super::material::{EquationOfState, Material};
use super::section::Section;
use super::{Ball, Extent};

/// A box or a ball of uniform gas at t = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Its place; for a ball the box around it, which may reach out of the domain.
    pub extent: Extent,
    /// The ball, if it is none of the boxes: it replaces what lies under it, and is cut off at
    /// the sides of the domain, also at periodic ones.
    pub ball: Option<Ball>,
    /// Its substance: a place in the list of materials.
    pub material: usize,
    /// Mass / length^dimension, > 0.
    pub density: f64,
    /// Length / time.
    pub velocity: Vec<f64>,
    /// Density * velocity^2; where the density alone gives it, what it gives.
    pub pressure: f64,
}

/// Energy added at t = 0 to the particles of a ball.
#[derive(Debug, Clone, PartialEq)]
pub struct Deposit {
    /// The ball; its centre lies in the domain.
    pub ball: Ball,
    /// Mass * velocity^2, > 0.
    pub energy: f64,
}

/// Every `[[region]]`: the boxes share no volume.
pub(super) fn regions(
    entry: &Entry<'_>,
    domain: &Extent,
    materials: &[Material],
) -> Result<Vec<Region>, Fault> {
    let mut regions: Vec<Region> = Vec::new();
    for entry in entry.list("one or more [[region]]")? {
        let section = entry.section()?;
        let region = region(&section, domain, materials)?;
        if region.ball.is_none() {
            geometry::clear_of_overlap(&section, &region.extent, &regions)?;
        }
        regions.push(region);
    }
    Ok(regions)
}

fn region(section: &Section<'_>, domain: &Extent, materials: &[Material]) -> Result<Region, Fault> {
    let ball = match section.optional("radius").or(section.optional("center")) {
        None => None,
        Some(_) => {
            let rest = ["material", "density", "velocity", "pressure"];
            section.only("a ball", &rest, &["center", "radius"])?;
            Some(geometry::ball(section, domain)?)
        }
    };
    let extent = match &ball {
        Some(ball) => ball.extent(),
        None => geometry::extent_inside(section, domain)?,
    };
    let material = material(section, materials)?;
    let density = section.required("density")?.number(POSITIVE)?;
    Ok(Region {
        extent,
        ball,
        material,
        density,
        velocity: section.required("velocity")?.vector(domain.lower.len())?,
        pressure: pressure(section, &materials[material].law, density)?,
    })
}

/// The place of the material that the file names; the first where it names none.
pub(super) fn material(section: &Section<'_>, materials: &[Material]) -> Result<usize, Fault> {
    section.optional("material").map_or(Ok(0), |entry| {
        entry.choice_of(materials.iter().map(|material| material.name.as_str()))
    })
}

/// The pressure that the file gives, or that follows from the density.
pub(super) fn pressure(
    section: &Section<'_>,
    law: &EquationOfState,
    density: f64,
) -> Result<f64, Fault> {
    if law.is_barotropic() {
        return match section.optional("pressure") {
            None => Ok(law.pressure(density, 0.0)),
            Some(entry) => {
                let pressure = law.pressure(density, 0.0);
                let reason = format!("{} gives {pressure} at this density", law.name());
                Err(entry.does_not_fit(reason, "take `pressure` out: it follows from the density"))
            }
        };
    }
    let entry = section.required("pressure")?;
    let EquationOfState::StiffenedGas {
        pressure_at_infinity,
        ..
    } = *law
    else {
        return entry.number(POSITIVE);
    };
    let pressure = entry.number(ANY)?;
    if pressure > -pressure_at_infinity {
        return Ok(pressure);
    }
    let reason = format!(
        "the stiffened gas needs a pressure > {}",
        -pressure_at_infinity
    );
    Err(entry.does_not_fit(reason, "give a pressure above minus pressure-at-infinity"))
}

/// Every `[[deposit]]`.
pub(super) fn deposits(
    root: &Section<'_>,
    domain: &Extent,
    materials: &[Material],
) -> Result<Vec<Deposit>, Fault> {
    let Some(entry) = root.optional("deposit") else {
        return Ok(Vec::new());
    };
    let deposit = |entry: &Entry<'_>| {
        let section = entry.section()?;
        let ball = geometry::ball(&section, domain)?;
        let energy = section.required("energy")?;
        if let Some(material) = materials
            .iter()
            .find(|material| material.law.is_barotropic())
        {
            let reason = format!("the energy of {} plays no part", material.law.name());
            return Err(energy.does_not_fit(reason, "take the [[deposit]] out"));
        }
        let energy = energy.number(POSITIVE)?;
        Ok(Deposit { ball, energy })
    };
    entry
        .list("one or more [[deposit]]")?
        .iter()
        .map(deposit)
        .collect()
}
