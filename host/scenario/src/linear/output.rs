//! What is written and measured.

use motes_formula::Formula;

use super::{Initial, System};
use crate::define::Definitions;
use crate::entry::Entry;
use crate::error::Fault;
use crate::geometry::point_inside;
use crate::output::{DEFAULT_SAMPLES, exact_times, samples, snapshots, window};
use crate::section::Section;
use crate::tolerance::{self, Tolerance};
use crate::{Domain, Extent, Snapshots};

/// What is written and measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Where errors are measured; in the domain.
    pub window: Extent,
    /// Rows of the time series, equally spaced in time, at least 1.
    pub samples: usize,
    /// The solution to compare with.
    pub exact: Option<Exact>,
    /// States on the way, if any are written.
    pub snapshots: Option<Snapshots>,
    /// Whether steps are shortened so that rows of the time series and snapshots have their own
    /// times.
    pub exact_times: bool,
    /// Places where the smoothed solution is written at the end.
    pub probe: Option<Probe>,
}

/// A solution to compare with.
#[derive(Debug, Clone, PartialEq)]
pub enum Exact {
    /// That which belongs to the initial state.
    Initial,
    /// What formulas of place and time say, one a component.
    Formula(Vec<Formula>),
}

/// A grid of points.
#[derive(Debug, Clone, PartialEq)]
pub struct Probe {
    /// The corner with the smallest coordinates; in the domain.
    pub lower: Vec<f64>,
    /// The corner with the largest; above `lower` where there are several points.
    pub upper: Vec<f64>,
    /// How many along each direction, at least 1: equally spaced, the first at `lower` and
    /// the last at `upper`; a single one in the middle.
    pub points: Vec<usize>,
}

/// What a tolerance is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measured {
    /// All components together.
    State,
    /// The reconstruction (1.13) of all components together.
    Reconstruction,
    /// One of them, counted from 0.
    Component(usize),
}

/// The most points of a probe.
const MOST: u32 = 10_000_000;

impl Probe {
    /// The coordinate along a direction of the point of that number, counted from 0.
    pub fn coordinate(&self, direction: usize, number: usize) -> f64 {
        let (lower, upper) = (self.lower[direction], self.upper[direction]);
        let part = match self.points[direction] {
            0 | 1 => 0.5,
            points => number as f64 / (points - 1) as f64,
        };
        (1.0 - part) * lower + part * upper
    }

    /// All points, 0 beyond the dimension; the last direction runs fastest.
    pub fn positions(&self) -> Vec<[f64; 3]> {
        let dimension = self.points.len();
        let count: usize = self.points.iter().product();
        let place = |mut number: usize| {
            let mut position = [0.0; 3];
            for axis in (0..dimension).rev() {
                position[axis] = self.coordinate(axis, number % self.points[axis]);
                number /= self.points[axis];
            }
            position
        };
        (0..count).map(place).collect()
    }
}

/// `[output]`.
pub(super) fn output(
    root: &Section<'_>,
    domain: &Domain,
    (system, initial, is_known): (&System, Option<&Initial>, bool),
    definitions: &Definitions<'_>,
) -> Result<Output, Fault> {
    let extent = &domain.extent;
    let Some(entry) = root.optional("output") else {
        return Ok(Output {
            window: extent.clone(),
            samples: DEFAULT_SAMPLES,
            exact: None,
            snapshots: None,
            exact_times: false,
            probe: None,
        });
    };
    let section = entry.section()?;
    Ok(Output {
        window: window(&section, extent)?,
        samples: samples(&section)?,
        exact: match section.optional("exact") {
            Some(entry) if entry.is_list() => {
                let components = system.components(domain.sides.len());
                Some(Exact::Formula(definitions.formulas(&entry, components)?))
            }
            Some(entry) if !is_known => {
                let reason = "system.source is a formula, of which no solution is known".to_owned();
                let cure = "give the solution as formulas, as exact = [\"exp(-t)*sin(x)\"], or leave it out";
                return Err(entry.does_not_fit(reason, cure));
            }
            Some(entry) => Some(exact(&entry, domain, system, initial)?),
            None => None,
        },
        snapshots: snapshots(&section)?,
        exact_times: exact_times(&section)?,
        probe: match section.optional("probe") {
            Some(entry) => Some(probe(&entry.section()?, extent)?),
            None => None,
        },
    })
}

/// The name of the one that there is.
const INITIAL: &str = "initial";

fn exact(
    entry: &Entry<'_>,
    domain: &Domain,
    system: &System,
    initial: Option<&Initial>,
) -> Result<Exact, Fault> {
    let chosen = entry.choice(&[(INITIAL, Exact::Initial)])?;
    let Some(initial) = initial else {
        let reason = "there is no [initial], of which the solution is known".to_owned();
        return Err(entry.does_not_fit(reason, "add [initial], or leave `exact` out"));
    };
    initial.has_solution(system, domain).map_err(|reason| {
        let reason = format!(
            "the solution of {} is not known here: {reason}",
            initial.name()
        );
        let cure = "leave `exact` out, give formulas, as exact = [\"exp(-t)*sin(x)\"], or change what the \
                    reason names (docs/scenario.md lists the solutions)";
        entry.does_not_fit(reason, cure)
    })?;
    Ok(chosen)
}

fn probe(section: &Section<'_>, domain: &Extent) -> Result<Probe, Fault> {
    let dimension = domain.lower.len();
    let corner = |key, usual: &Vec<f64>| match section.optional(key) {
        Some(entry) => point_inside(&entry, domain),
        None => Ok(usual.clone()),
    };
    let lower = corner("lower", &domain.lower)?;
    let upper = corner("upper", &domain.upper)?;
    let entry = section.required("points")?;
    let need = "1 to 10000000";
    let cure = "give the number of points along each direction, as in points = [200]";
    let directions = entry.directions(dimension)?;
    let points = directions.iter().map(|entry| entry.count(MOST, need, cure));
    let points: Vec<usize> = points.collect::<Result<_, _>>()?;
    if points.iter().map(|&n| n as f64).product::<f64>() > f64::from(MOST) {
        let reason = "together they are more than 10000000".to_owned();
        return Err(entry.does_not_fit(reason, "give fewer points"));
    }
    for (axis, entry) in directions.iter().enumerate() {
        let (low, high) = (lower[axis], upper[axis]);
        if !(low < high || low == high && points[axis] == 1) {
            let reason = format!("the probe reaches from {low} to {high} there");
            let cure = "make upper larger than lower, or equal with one point";
            return Err(entry.does_not_fit(reason, cure));
        }
    }
    Ok(Probe {
        lower,
        upper,
        points,
    })
}

/// `[tolerance]`: of the state, of the reconstruction, then of the components in their order.
pub(super) fn tolerances(
    root: &Section<'_>,
    output: &Output,
    system: &System,
    dimension: usize,
) -> Result<Vec<Tolerance<Measured>>, Fault> {
    let names = system.names(dimension).into_iter().enumerate();
    let components = names.map(|(i, name)| (name, Measured::Component(i)));
    let whole = [
        ("state".to_owned(), Measured::State),
        ("reconstruction".to_owned(), Measured::Reconstruction),
    ];
    let fields: Vec<_> = whole.into_iter().chain(components).collect();
    tolerance::tolerances(root, output.exact.is_some(), &fields)
}
