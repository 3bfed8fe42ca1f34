//! The regions of uniform gas at t = 0, and the energy deposited in it.

use super::material::{EquationOfState, Material};
use super::profile::{Piece, state_formulas};
use crate::bound::POSITIVE;
use crate::define::Definitions;
use crate::entry::{ANY, Entry};
use crate::error::Fault;
use crate::geometry::{self, AXES};
use crate::problem::Problem;
use crate::section::Section;
use crate::{Ball, Extent};

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
            clear_of_overlap(&section, &region.extent, &regions)?;
        }
        regions.push(region);
    }
    Ok(regions)
}

/// Every `[[region]]` where one of them has a formula: boxes of the first material that fill the domain;
/// `None` where none has.
pub(super) fn pieces(
    entry: &Entry<'_>,
    domain: &Extent,
    materials: &[Material],
    definitions: &Definitions<'_>,
) -> Result<Option<Vec<Piece>>, Fault> {
    let entries = entry.list("one or more [[region]]")?;
    let sections: Vec<Section<'_>> = entries
        .iter()
        .map(Entry::section)
        .collect::<Result<_, _>>()?;
    let Some(formula) = sections.iter().find_map(formula) else {
        return Ok(None);
    };
    let mut regions: Vec<Region> = Vec::new();
    let mut pieces = Vec::new();
    for section in &sections {
        if let Some(ball) = section.optional("radius").or(section.optional("center")) {
            let reason = format!(
                "{} is a formula, and a ball cuts into what it says",
                formula.key()
            );
            return Err(ball.does_not_fit(reason, "give boxes, or formulas with if(r < ..., a, b)"));
        }
        if let (Some(entry), 1..) = (section.optional("material"), material(section, materials)?) {
            let reason = format!(
                "{} is a formula, and those are of the first material",
                formula.key()
            );
            return Err(entry.does_not_fit(reason, "take `material` out, or give numbers"));
        }
        let extent = geometry::extent_inside(section, domain)?;
        clear_of_overlap(section, &extent, &regions)?;
        let state = state_formulas(section, &materials[0].law, domain.lower.len(), definitions)?;
        regions.push(Region {
            extent: extent.clone(),
            ball: None,
            material: 0,
            density: 0.0,
            velocity: Vec::new(),
            pressure: 0.0,
        });
        pieces.push(Piece { extent, state });
    }
    let filled: f64 = pieces.iter().map(|piece| piece.extent.volume()).sum();
    if filled < (1.0 - 1e-9) * domain.volume() {
        let reason = format!(
            "it is a formula, and the regions fill {filled} of {}",
            domain.volume()
        );
        return Err(formula.does_not_fit(reason, "give regions that fill the domain"));
    }
    Ok(Some(pieces))
}

/// The first value of a region that is a formula.
fn formula<'a>(section: &Section<'a>) -> Option<Entry<'a>> {
    let own = ["density", "pressure"]
        .into_iter()
        .filter_map(|key| section.optional(key));
    let velocity = section
        .optional("velocity")
        .and_then(|entry| entry.list("").ok());
    own.chain(velocity.into_iter().flatten())
        .find(Entry::is_text)
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

/// That `extent`, of the region `section`, shares no volume with the earlier `regions`.
pub(super) fn clear_of_overlap(
    section: &Section<'_>,
    extent: &Extent,
    regions: &[Region],
) -> Result<(), Fault> {
    for (first, other) in regions.iter().enumerate() {
        if other.ball.is_some() {
            continue;
        }
        let Some((axis, lower, upper)) = shared(extent, &other.extent) else {
            continue;
        };
        let second = regions.len();
        let problem = Problem::Overlap {
            first,
            second,
            axis,
            lower,
            upper,
        };
        return Err(section.required("lower")?.fault(problem));
    }
    Ok(())
}

/// The direction in which two overlapping boxes share least, and what they share there.
fn shared(a: &Extent, b: &Extent) -> Option<(char, f64, f64)> {
    let lower = a.lower.iter().zip(&b.lower).map(|(a, b)| a.max(*b));
    let upper = a.upper.iter().zip(&b.upper).map(|(a, b)| a.min(*b));
    let shared: Vec<_> = AXES.into_iter().zip(lower).zip(upper).collect();
    let overlaps = shared.iter().all(|((_, lower), upper)| lower < upper);
    let thinnest = shared
        .into_iter()
        .map(|((axis, lower), upper)| (axis, lower, upper))
        .min_by(|(_, l, u), (_, m, v)| (u - l).total_cmp(&(v - m)));
    thinnest.filter(|_| overlaps)
}

/// The direction across which two boxes touch, or why they are no Riemann problem.
pub(super) fn riemann_direction(regions: &[Region]) -> Result<usize, String> {
    let [a, b] = regions else {
        let count = regions.len();
        return Err(format!("the number of regions is {count}"));
    };
    if a.ball.is_some() || b.ball.is_some() {
        return Err("a region is a ball".to_owned());
    }
    let (a, b) = (&a.extent, &b.extent);
    let touch = |&i: &usize| a.upper[i] == b.lower[i] || b.upper[i] == a.lower[i];
    let direction = (0..a.lower.len()).find(touch);
    let direction = direction.ok_or_else(|| "the two regions do not touch".to_owned())?;
    let mut others = (0..a.lower.len()).filter(|&i| i != direction);
    match others.find(|&i| [a.lower[i], a.upper[i]] != [b.lower[i], b.upper[i]]) {
        Some(i) => Err(format!(
            "the two regions span unequal stretches along {}",
            AXES[i]
        )),
        None => Ok(direction),
    }
}
