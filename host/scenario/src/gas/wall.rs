//! Walls that a viscous gas sticks to: `[[wall]]`.

use crate::entry::Entry;
use crate::error::Fault;
use crate::geometry::{AXES, place_of_wall};
use crate::section::Section;
use crate::{Diffusion, Domain, Region, Side};

/// The walls that the gas sticks to: the velocity of the lower and of the upper wall across each direction,
/// length / time, without a component across it; `None` for one that the gas slips along.
pub type NoSlipWalls = Vec<[Option<Vec<f64>>; 2]>;

/// Every `[[wall]]`; along a wall of which nothing is said the gas slips.
pub(super) fn walls(
    root: &Section<'_>,
    domain: &Domain,
    diffusion: &Diffusion,
) -> Result<NoSlipWalls, Fault> {
    let dimension = domain.sides.len();
    let mut walls: NoSlipWalls = vec![[None, None]; dimension];
    let Some(entry) = root.optional("wall") else {
        return Ok(walls);
    };
    let mut told = Vec::new();
    for (number, entry) in entry.list("one or more [[wall]]")?.iter().enumerate() {
        let section = entry.section()?;
        let (axis, end) = place_of_wall(&section, domain)?;
        if let Some((first, _)) = told.iter().find(|(_, place)| *place == (axis, end)) {
            let reason = format!("wall {first} is the same one");
            let cure = "keep one of the two; walls are numbered from 0";
            return Err(section.required("end")?.does_not_fit(reason, cure));
        }
        told.push((number, (axis, end)));
        let slip = section.required("slip")?;
        let (name, sticks, keys) = slip.choice(SLIPS)?;
        section.only(name, &["axis", "end", "slip"], keys)?;
        if !sticks {
            continue;
        }
        check_physics(&slip, dimension, diffusion)?;
        let velocity = section.optional("velocity");
        walls[axis][end] = Some(match velocity {
            None => vec![0.0; dimension],
            Some(entry) => velocity_along(&entry, axis, dimension)?,
        });
    }
    Ok(walls)
}

/// What a wall may do to the gas along it: whether it sticks, and the keys that go with that.
type Slip = (&'static str, bool, &'static [&'static str]);

const SLIPS: &[(&str, Slip)] = &[
    ("none", ("none", true, &["velocity"])),
    ("free", ("free", false, &[])),
];

/// That there is a direction along the wall, and something to stick by.
fn check_physics(slip: &Entry<'_>, dimension: usize, diffusion: &Diffusion) -> Result<(), Fault> {
    if dimension == 1 {
        let reason = "dimension = 1: nothing lies along a wall".to_owned();
        let cure = "take this [[wall]] out, or use two or three dimensions";
        return Err(slip.does_not_fit(reason, cure));
    }
    if !(diffusion.viscosity > 0.0) {
        let reason = "diffusion.viscosity = 0: a gas sticks to a wall by it".to_owned();
        let cure = "give `viscosity` in [diffusion], above 0, or slip = \"free\"";
        return Err(slip.does_not_fit(reason, cure));
    }
    Ok(())
}

/// A velocity along a wall.
fn velocity_along(entry: &Entry<'_>, axis: usize, dimension: usize) -> Result<Vec<f64>, Fault> {
    let velocity = entry.vector(dimension)?;
    if velocity[axis] != 0.0 {
        let name = AXES[axis];
        let reason = format!("the wall lies across {name}, and would leave its place");
        let cure = format!("make the component along {name} 0");
        return Err(entry.does_not_fit(reason, &cure));
    }
    Ok(velocity)
}

/// The direction across the walls of a channel, or why there is none.
pub(super) fn channel(
    (walls, domain): (&NoSlipWalls, &Domain),
    acceleration: &[f64],
    regions: &[Region],
) -> Result<usize, &'static str> {
    let sticks = |walls: &[Option<Vec<f64>>; 2]| walls.iter().all(Option::is_some);
    let Some(axis) = walls.iter().position(sticks) else {
        return Err("there are no two walls that the gas sticks to");
    };
    let sides = domain.sides.iter().enumerate();
    let mut others = sides.filter(|(i, _)| *i != axis);
    if !others.all(|(_, sides)| *sides == [Side::Periodic; 2]) {
        return Err("the channel is not periodic along its walls");
    }
    if acceleration[axis] != 0.0 {
        return Err("an acceleration acts across the walls");
    }
    match regions.first() {
        Some(region) if region.velocity[axis] == 0.0 => Ok(axis),
        _ => Err("the gas moves across the walls"),
    }
}
