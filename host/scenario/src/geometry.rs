//! The boxes and balls of a scenario: domain, regions, deposits, window.

use super::bound::POSITIVE;
use super::entry::Entry;
use super::error::Fault;
use super::problem::Problem;
use super::section::Section;
use super::{Ball, Domain, Extent, Region, Side};

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
