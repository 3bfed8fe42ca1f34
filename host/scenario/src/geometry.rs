//! Boxes, balls and points as they are read, and the domain.

use crate::bound::POSITIVE;
use crate::entry::Entry;
use crate::error::Fault;
use crate::problem::Problem;
use crate::section::Section;
use crate::{Ball, Domain, Extent, Side};

const SIDES: &[(&str, Side)] = &[
    ("periodic", Side::Periodic),
    ("mirror", Side::Mirror),
    ("free", Side::Free),
    ("inflow", Side::Inflow),
    ("outflow", Side::Outflow),
];

pub(super) const AXES: [char; 3] = ['x', 'y', 'z'];

/// A box of positive volume.
fn extent(section: &Section<'_>, dimension: usize) -> Result<Extent, Fault> {
    let lower = section.required("lower")?.vector(dimension)?;
    let upper_entry = section.required("upper")?;
    let upper = upper_entry.vector(dimension)?;
    for ((&lower, &upper), axis) in lower.iter().zip(&upper).zip(AXES) {
        if upper <= lower {
            let key = section.path().to_owned();
            return Err(upper_entry.fault(Problem::EmptyBox {
                key,
                axis,
                lower,
                upper,
            }));
        }
    }
    Ok(Extent { lower, upper })
}

/// A box of `section` that must lie in the domain.
pub(super) fn extent_inside(section: &Section<'_>, domain: &Extent) -> Result<Extent, Fault> {
    let extent = extent(section, domain.lower.len())?;
    for (name, corner) in [("lower", &extent.lower), ("upper", &extent.upper)] {
        let entry = section.required(name)?;
        check_inside(&entry, corner, domain)?;
    }
    Ok(extent)
}

/// The domain and its sides.
pub(super) fn domain(section: &Section<'_>, dimension: usize) -> Result<Domain, Fault> {
    let extent = extent(section, dimension)?;
    let directions = section.required("sides")?.directions(dimension)?;
    let sides: Vec<_> = directions.iter().map(sides).collect::<Result<_, _>>()?;
    check_open(&directions, &sides)?;
    Ok(Domain { extent, sides })
}

/// That gas is taken in or out in one direction only, and in at one side only.
fn check_open(directions: &[Entry<'_>], sides: &[[Side; 2]]) -> Result<(), Fault> {
    let mut open = None;
    for (axis, (entry, sides)) in directions.iter().zip(sides).enumerate() {
        if !sides.iter().any(|side| side.is_open()) {
            continue;
        }
        if *sides == [Side::Inflow; 2] {
            let reason = "gas can come in at one side only".to_owned();
            let cure = "write \"outflow\", \"free\" or \"mirror\" for the other, as \
                        [[\"inflow\", \"outflow\"]]";
            return Err(entry.does_not_fit(reason, cure));
        }
        if let Some(first) = open {
            let reason = format!("gas comes in or goes out along {} already", AXES[first]);
            let cure = "keep \"inflow\" and \"outflow\" to one direction: \"free\", \"mirror\" or \
                        \"periodic\" are for the others";
            return Err(entry.does_not_fit(reason, cure));
        }
        open = Some(axis);
    }
    Ok(())
}

/// Both sides of a direction: one name for both, or a pair of names.
fn sides(entry: &Entry<'_>) -> Result<[Side; 2], Fault> {
    if entry.text().is_ok() {
        let side = entry.choice(SIDES)?;
        return Ok([side, side]);
    }
    let pair = entry.list("a name, or a pair of names in brackets")?;
    let [lower, upper] = pair.as_slice() else {
        return Err(entry.wrong_type("a name or a pair of names"));
    };
    let pair = [lower.choice(SIDES)?, upper.choice(SIDES)?];
    if pair[0] != pair[1] && pair.contains(&Side::Periodic) {
        return Err(entry.fault(Problem::HalfPeriodic {
            key: entry.key().to_owned(),
            value: entry.shown(),
        }));
    }
    Ok(pair)
}

/// A point that must lie in the domain.
pub(super) fn point_inside(entry: &Entry<'_>, domain: &Extent) -> Result<Vec<f64>, Fault> {
    let point = entry.vector(domain.lower.len())?;
    check_inside(entry, &point, domain)?;
    Ok(point)
}

/// That the point of an entry lies in the domain.
fn check_inside(entry: &Entry<'_>, point: &[f64], domain: &Extent) -> Result<(), Fault> {
    let bounds = domain.lower.iter().zip(&domain.upper);
    for ((&value, (&lower, &upper)), axis) in point.iter().zip(bounds).zip(AXES) {
        if value < lower || value > upper {
            return Err(entry.fault(Problem::OutsideDomain {
                key: entry.key().to_owned(),
                axis,
                value,
                lower,
                upper,
            }));
        }
    }
    Ok(())
}

/// The ball of `section`, whose centre must lie in the domain.
pub(super) fn ball(section: &Section<'_>, domain: &Extent) -> Result<Ball, Fault> {
    let center = point_inside(&section.required("center")?, domain)?;
    let radius = section.required("radius")?.number(POSITIVE)?;
    Ok(Ball { center, radius })
}

const ENDS: [&str; 2] = ["lower", "upper"];

/// Which wall: its direction and its end, 0 for the lower.
pub(super) fn place_of_wall(
    section: &Section<'_>,
    domain: &Domain,
) -> Result<(usize, usize), Fault> {
    let entry = section.required("axis")?;
    let axis = entry.choice(&[("x", 0), ("y", 1), ("z", 2)])?;
    let dimension = domain.sides.len();
    if axis >= dimension {
        let reason = format!("dimension = {dimension}");
        let cure = format!("the directions are: {}", &"x, y, z"[..3 * dimension - 2]);
        return Err(entry.does_not_fit(reason, &cure));
    }
    let entry = section.required("end")?;
    let end = entry.choice(&[(ENDS[0], 0), (ENDS[1], 1)])?;
    if domain.sides[axis][end] != Side::Mirror {
        let name = AXES[axis];
        let reason = format!("there is no wall at the {} side along {name}", ENDS[end]);
        let cure = format!(
            "set the side along {name} in domain.sides to \"mirror\", or take this [[wall]] out"
        );
        return Err(entry.does_not_fit(reason, &cure));
    }
    Ok((axis, end))
}
