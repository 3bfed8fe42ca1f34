//! The files of a run: tables, pictures, and the scenario as it was run.

use std::path::{Path, PathBuf};

use miette::Report;

use super::figure::{self, Panel};
use super::map::{self, Map, rasterised};
use crate::comparison::{FIELDS, within};
use crate::exact::flow::FlowState;
use crate::experiment::Experiment;
use crate::io;
use crate::scenario::{Exact, Profile};
use crate::simulation::ParticleRow;

/// Writes all result files into a folder.
///
/// # Errors
/// Files that cannot be written.
pub fn write(out: &Path, experiment: &Experiment) -> Result<(), Report> {
    let file = |name: &str| -> PathBuf { out.join(name) };
    let (scenario, outcome) = (&experiment.scenario, &experiment.outcome);
    let dimension = scenario.dimension;
    io::write_text(&file("scenario.toml"), &scenario.text)?;
    io::write_particles(
        &file("particles.csv"),
        dimension,
        outcome,
        experiment.exact.as_ref(),
    )?;
    io::write_series(&file("series.csv"), dimension, &outcome.series)?;
    for (name, picture) in pictures(experiment)? {
        io::write_text(&file(name), &picture)?;
    }
    Ok(())
}

/// The pictures of a run by the name of their files: fields along a line or a radius, and in
/// two dimensions maps.
///
/// # Errors
/// A picture that cannot be drawn.
pub fn pictures(experiment: &Experiment) -> Result<Vec<(&'static str, String)>, Report> {
    let title = format!(
        "{}, {} particles, t = {:.6}",
        experiment.scenario.name,
        experiment.outcome.particles.len(),
        experiment.outcome.time
    );
    let abscissa = Abscissa::of(experiment);
    let mut pictures = vec![(
        "figure.svg",
        figure::panels(&title, abscissa.label(), &panels(experiment, &abscissa))?,
    )];
    if experiment.scenario.dimension == 2 {
        pictures.push(("map.svg", map::maps(&title, &planes(experiment))?));
    }
    Ok(pictures)
}

/// What fields are drawn over.
enum Abscissa {
    /// A coordinate.
    Along(usize),
    /// The distance from a point.
    From([f64; 3]),
}

impl Abscissa {
    /// The direction in which a solution varies; the distance from its centre where it is round.
    fn of(experiment: &Experiment) -> Self {
        let scenario = &experiment.scenario;
        if scenario.dimension == 1 {
            return Self::Along(0);
        }
        let spread = |at: &[f64]| std::array::from_fn(|i| at.get(i).copied().unwrap_or(0.0));
        match (scenario.output.exact, &scenario.profile) {
            (Some(Exact::Sedov), _) => Self::From(spread(&scenario.deposits[0].ball.center)),
            (_, Some(Profile::Noh { .. })) => Self::From([0.0; 3]),
            (_, Some(Profile::YeeVortex { velocity, .. } | Profile::Gresho { velocity, .. }))
                if velocity.iter().all(|&u| u == 0.0) =>
            {
                Self::From([0.0; 3])
            }
            _ => Self::Along(scenario.riemann_direction().unwrap_or(0)),
        }
    }

    fn label(&self) -> &'static str {
        match self {
            Self::Along(0) => "position",
            Self::Along(1) => "y",
            Self::Along(_) => "z",
            Self::From(_) => "radius",
        }
    }

    fn at(&self, position: &[f64; 3]) -> f64 {
        match self {
            Self::Along(axis) => position[*axis],
            Self::From(centre) => {
                let from = position.iter().zip(centre);
                from.map(|(x, c)| (x - c) * (x - c)).sum::<f64>().sqrt()
            }
        }
    }

    /// The point of the curve at a value of the abscissa.
    fn point(&self, value: f64, middle: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Along(axis) => {
                let mut point = middle;
                point[*axis] = value;
                point
            }
            Self::From(centre) => {
                let mut point = *centre;
                point[0] += value;
                point
            }
        }
    }
}

/// The value of a field: of the velocity the component along the abscissa, or its length.
fn value(field: usize, state: &FlowState, abscissa: &Abscissa) -> f64 {
    match (field, abscissa) {
        (0, _) => state.density,
        (1, Abscissa::Along(axis)) => state.velocity[*axis],
        (1, Abscissa::From(_)) => state.velocity.iter().map(|u| u * u).sum::<f64>().sqrt(),
        (2, _) => state.pressure,
        _ => state.energy,
    }
}

/// A particle as a point of a flow.
fn state(particle: &ParticleRow) -> FlowState {
    FlowState {
        density: particle.density,
        velocity: particle.velocity,
        pressure: particle.pressure,
        energy: particle.energy,
    }
}

/// A panel for each field over the window: particles as points, the exact solution as a curve.
fn panels(experiment: &Experiment, abscissa: &Abscissa) -> Vec<Panel> {
    let (scenario, outcome) = (&experiment.scenario, &experiment.outcome);
    let window = &scenario.output.window;
    let inside: Vec<_> = within(&outcome.particles, window, None).collect();
    let places = || {
        inside
            .iter()
            .map(|particle| abscissa.at(&particle.position))
    };
    let (lower, upper) = match abscissa {
        Abscissa::Along(axis) => (window.lower[*axis], window.upper[*axis]),
        Abscissa::From(_) => (0.0, places().fold(0.0, f64::max)),
    };
    let middle = std::array::from_fn(|i| match window.lower.get(i) {
        Some(lower) => 0.5 * (lower + window.upper[i]),
        None => 0.0,
    });
    let points = 1000;
    let at = |i: i32| lower + (upper - lower) * f64::from(i) / f64::from(points);
    let curve = |field: usize| {
        let Some(exact) = &experiment.exact else {
            return Vec::new();
        };
        let exact = |x: f64| exact.at(abscissa.point(x, middle), outcome.time);
        // Where the solution leaves all particles behind, it would leave them no room.
        let values = inside.iter().map(|p| value(field, &state(p), abscissa));
        let most = 3.0 * values.map(f64::abs).fold(0.0, f64::max);
        (0..=points)
            .map(|i| (at(i), value(field, &exact(at(i)), abscissa)))
            .filter(|(_, value)| value.abs() <= most)
            .collect()
    };
    let panel = |(field, name): (usize, &str)| Panel {
        heading: name.to_owned(),
        points: inside
            .iter()
            .zip(places())
            .map(|(particle, place)| (place, value(field, &state(particle), abscissa)))
            .collect(),
        curve: curve(field),
    };
    FIELDS.into_iter().enumerate().map(panel).collect()
}

/// Cells of a map along its longer side.
const CELLS: f64 = 128.0;

/// Maps of density, speed, pressure and internal energy over the window.
fn planes(experiment: &Experiment) -> Vec<Map> {
    let (scenario, outcome) = (&experiment.scenario, &experiment.outcome);
    let window = &scenario.output.window;
    let corner = |at: &[f64]| [at[0], at[1]];
    let (lower, upper) = (corner(&window.lower), corner(&window.upper));
    let size = [upper[0] - lower[0], upper[1] - lower[1]];
    let cell = size[0].max(size[1]) / CELLS;
    let cells = size.map(|length| ((length / cell).round() as usize).max(1));
    let positions: Vec<[f64; 2]> = outcome
        .particles
        .iter()
        .map(|particle| corner(&particle.position))
        .collect();
    let area: f64 = outcome.particles.iter().map(|p| p.mass / p.density).sum();
    let spacing = (area / positions.len() as f64).sqrt();
    let map = |heading: &str, of: fn(&ParticleRow) -> f64| Map {
        heading: heading.to_owned(),
        cells: rasterised(
            &positions,
            &outcome.particles.iter().map(of).collect::<Vec<_>>(),
            1.3 * spacing,
            lower,
            upper,
            cells,
        ),
        nx: cells[0],
        ny: cells[1],
        lower,
        upper,
    };
    vec![
        map("density", |p| p.density),
        map("speed", ParticleRow::speed),
        map("pressure", |p| p.pressure),
        map("energy", |p| p.energy),
    ]
}
