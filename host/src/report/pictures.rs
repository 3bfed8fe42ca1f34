//! The pictures of a run: fields along a line or a radius, in two dimensions maps of them, what the
//! probe saw, and what drove it over time. Made in passes over the particles, of which none is
//! kept that is not drawn.

use miette::Report;

use super::figure::{self, Line, MOST_PANELS, MOST_POINTS, Panel};
use super::map::{self, MOST_MAPS, Map, Raster};
use crate::exact::solution::Solution;
use crate::experiment::Experiment;
use crate::run::{Abscissa, Field, Kind, Row, View};
use crate::scenario::Extent;
use crate::scenario::linear::Series;

/// Points of the curve of an exact solution.
const POINTS: usize = 1000;

/// Cells of a map along its longer side.
const CELLS: f64 = 128.0;

/// The pictures of a run by the names of their files.
///
/// # Errors
/// A picture that cannot be drawn.
pub fn pictures(experiment: &Experiment) -> Result<Vec<(&'static str, String)>, Report> {
    let outcome = &experiment.outcome;
    let title = format!(
        "{}, {} particles, t = {:.6}\n{}",
        experiment.scenario.name(),
        outcome.particles,
        outcome.time,
        run(experiment)
    );
    let description = experiment.simulation.description();
    let panels = panels(experiment);
    let figure = figure::panels(&title, description.view.label, &panels)?;
    let mut pictures = vec![("figure.svg", figure)];
    if description.dimension == 2 {
        pictures.push(("map.svg", map::maps(&title, &maps(experiment))?));
    }
    pictures.extend(probe(experiment, &title)?.map(|picture| ("probe.svg", picture)));
    pictures.extend(history(experiment)?.map(|picture| ("history.svg", picture)));
    Ok(pictures)
}

/// Which run it was: the second line of titles.
fn run(experiment: &Experiment) -> String {
    let (scalar, digest) = (experiment.scalar.name(), experiment.outcome.digest);
    format!("{scalar}, digest {digest}")
}

/// Where on the abscissa a place is.
fn along(abscissa: Abscissa, position: &[f64; 3]) -> f64 {
    match abscissa {
        Abscissa::Along(axis) => position[axis],
        Abscissa::From(centre) => {
            let from = position.iter().zip(centre);
            from.map(|(x, c)| (x - c) * (x - c)).sum::<f64>().sqrt()
        }
    }
}

/// The place of the curve at a value of the abscissa; at a distance from a centre in the direction of
/// the particle that is furthest from it, so that the curve stays where particles are: along an axis
/// it would leave a periodic box and come back from the other side.
fn point(abscissa: Abscissa, value: f64, middle: [f64; 3], furthest: [f64; 3]) -> [f64; 3] {
    match abscissa {
        Abscissa::Along(axis) => {
            let mut point = middle;
            point[axis] = value;
            point
        }
        Abscissa::From(centre) => {
            let length = along(abscissa, &furthest).max(f64::MIN_POSITIVE);
            std::array::from_fn(|i| centre[i] + (furthest[i] - centre[i]) * (value / length))
        }
    }
}

/// What is drawn of a field.
#[derive(Clone, Copy)]
enum Part {
    /// A component.
    Component(usize),
    /// The length of a vector.
    Length,
}

impl Part {
    /// Of a vector its length over a radius, and over a coordinate the component along it, unless the
    /// exact solution has more in another one: a stream along walls shows nothing across them.
    fn of(field: &Field, abscissa: Abscissa, curve: &[(f64, Vec<f64>)]) -> Self {
        let (Kind::Vector, Abscissa::Along(axis)) = (field.kind, abscissa) else {
            return match field.kind {
                Kind::Vector => Self::Length,
                _ => Self::Component(0),
            };
        };
        let largest = |i: usize| {
            let sizes = curve.iter().map(|(_, values)| values[i].abs());
            sizes.fold(0.0, f64::max)
        };
        let mut found = axis;
        for i in 0..field.components {
            if largest(i) > largest(found) {
                found = i;
            }
        }
        Self::Component(found)
    }

    fn value(self, values: &[f64]) -> f64 {
        match self {
            Self::Component(i) => values[i],
            Self::Length => values.iter().map(|u| u * u).sum::<f64>().sqrt(),
        }
    }

    /// What it is called.
    fn heading(self, field: &Field) -> String {
        match self {
            Self::Component(i) => field.headings().swap_remove(i),
            Self::Length => field.name.clone(),
        }
    }
}

/// Whether a solution changes across the abscissa: what lies away from its curve says nothing of it then.
fn varies_across(
    exact: &dyn Solution,
    fields: &[&Field],
    (window, dimension): (&Extent, usize),
    (abscissa, time): (Abscissa, f64),
) -> bool {
    const LINES: usize = 8;
    let Abscissa::Along(axis) = abscissa else {
        return false;
    };
    let middle = std::array::from_fn(|i| window.middle(i));
    let inside = |i: usize, part: usize| {
        let share = (part as f64 + 0.5) / LINES as f64;
        window.lower[i] + share * (window.upper[i] - window.lower[i])
    };
    // Each field has a unit of its own; the components of one share it.
    let (mut largest, mut off) = (vec![0.0f64; fields.len()], vec![0.0f64; fields.len()]);
    for along in 0..LINES {
        let mut on: [f64; 3] = middle;
        on[axis] = inside(axis, along);
        let right = exact.at(on, time);
        for other in (0..dimension).filter(|&other| other != axis) {
            for line in 0..LINES {
                let mut beside = on;
                beside[other] = inside(other, line);
                let found = exact.at(beside, time);
                let mut first = 0;
                for (i, field) in fields.iter().enumerate() {
                    for j in first..first + field.components {
                        largest[i] = largest[i].max(right[j].abs());
                        off[i] = off[i].max((found[j] - right[j]).abs());
                    }
                    first += field.components;
                }
            }
        }
    }
    off.iter()
        .zip(&largest)
        .any(|(off, largest)| *off > 1e-3 * largest)
}

/// A panel for each field over the window: particles as points, the exact solution as a curve.
fn panels(experiment: &Experiment) -> Vec<Panel> {
    let (simulation, window) = (&experiment.simulation, experiment.scenario.window());
    let description = simulation.description();
    let View {
        abscissa,
        half_width,
        is_cut,
        ..
    } = description.view;
    let fields: Vec<&Field> = description.compared().take(MOST_PANELS).collect();
    let middle: [f64; 3] = std::array::from_fn(|i| window.middle(i));
    let time = experiment.outcome.time;
    let beside = experiment.exact.as_deref().filter(|exact| {
        let room = (window, description.dimension);
        varies_across(*exact, &fields, room, (abscissa, time))
    });
    let half_width = half_width.or(beside.map(|_| 0.5 * description.spacing));
    let is_near = |row: &Row| {
        let is_other = |i: &usize| abscissa != Abscissa::Along(*i);
        let mut others = (0..description.dimension).filter(is_other);
        half_width.is_none_or(|half| others.all(|i| (row.position[i] - middle[i]).abs() <= half))
    };
    let is_inside = |row: &Row| window.contains(&row.position) && is_near(row);
    let (mut inside, mut furthest) = (0usize, middle);
    simulation.each(|row| {
        if is_inside(row) {
            inside += 1;
            if inside == 1 || along(abscissa, &row.position) > along(abscissa, &furthest) {
                furthest = row.position;
            }
        }
    });
    let (lower, upper) = match abscissa {
        Abscissa::Along(axis) => (window.lower[axis], window.upper[axis]),
        Abscissa::From(_) => (0.0, along(abscissa, &furthest)),
    };
    let curves = curves(experiment, &fields, (lower, upper), |x| {
        point(abscissa, x, middle, furthest)
    });
    let parts = fields.iter().zip(&curves);
    let parts: Vec<Part> = parts
        .map(|(field, curve)| Part::of(field, abscissa, curve))
        .collect();
    let mut panels: Vec<Panel> = (fields.iter().zip(&parts).zip(curves))
        .map(|((field, part), curve)| Panel {
            heading: part.heading(field),
            curve: (curve.iter())
                .map(|(x, values)| (*x, part.value(values)))
                .collect(),
            ..Panel::default()
        })
        .collect();
    let stride = inside.div_ceil(MOST_POINTS).max(1);
    let mut number = 0;
    simulation.each(|row| {
        if is_inside(row) {
            let x = along(abscissa, &row.position);
            for ((field, part), panel) in fields.iter().zip(&parts).zip(&mut panels) {
                let point = (x, part.value(&row.values[field.places()]));
                panel.reach(point);
                if number % stride == 0 {
                    panel.points.push(point);
                }
            }
            number += 1;
        }
    });
    for panel in &mut panels {
        panel.stride = stride;
        if is_cut {
            // Where the solution leaves all particles behind, it would leave them no room.
            let most = 3.0 * panel.largest();
            panel.curve.retain(|(_, value)| value.abs() <= most);
        }
    }
    panels
}

/// The exact solution of each field between two values of the abscissa, as all its components; empty
/// without one.
fn curves(
    experiment: &Experiment,
    fields: &[&Field],
    (lower, upper): (f64, f64),
    place: impl Fn(f64) -> [f64; 3],
) -> Vec<Vec<(f64, Vec<f64>)>> {
    let mut curves = vec![Vec::new(); fields.len()];
    let Some(exact) = &experiment.exact else {
        return curves;
    };
    for i in 0..=POINTS {
        let x = lower + (upper - lower) * i as f64 / POINTS as f64;
        let state = exact.at(place(x), experiment.outcome.time);
        let mut rest = &state[..];
        for (field, curve) in fields.iter().zip(&mut curves) {
            let (values, after) = rest.split_at(field.components);
            rest = after;
            curve.push((x, values.to_vec()));
        }
    }
    curves
}

/// Maps of the first fields over the window.
fn maps(experiment: &Experiment) -> Vec<Map> {
    let (simulation, window) = (&experiment.simulation, experiment.scenario.window());
    let description = simulation.description();
    let corner = |at: &[f64]| [at[0], at[1]];
    let (lower, upper) = (corner(&window.lower), corner(&window.upper));
    let size = [upper[0] - lower[0], upper[1] - lower[1]];
    let cell = size[0].max(size[1]) / CELLS;
    let cells = size.map(|length| ((length / cell).round() as usize).max(1));
    let fields: Vec<&Field> = description.compared().take(MOST_MAPS).collect();
    let raster = Raster::new((lower, upper), cells);
    let mut rasters = vec![raster; fields.len()];
    simulation.each(|row| {
        for (field, raster) in fields.iter().zip(&mut rasters) {
            raster.add(corner(&row.position), row.volume, field.length(&row.values));
        }
    });
    let map = |(field, raster): (&&Field, Raster)| Map {
        heading: match field.kind {
            Kind::Vector => description.view.length.to_owned(),
            _ => field.name.clone(),
        },
        cells: raster.means(),
        nx: cells[0],
        ny: cells[1],
        lower,
        upper,
    };
    fields.iter().zip(rasters).map(map).collect()
}

/// What is drawn of a species over time, by its name in the time series and in words.
const SPREAD: [(&str, &str); 3] = [("min", "smallest"), ("mean", "mean"), ("max", "largest")];

/// What walls are driven by over time, and what becomes of the species; `None` where no series
/// drives one.
fn history(experiment: &Experiment) -> Result<Option<String>, Report> {
    let (scenario, outcome) = (&experiment.scenario, &experiment.outcome);
    let driven = scenario.driven();
    if driven.is_empty() {
        return Ok(None);
    }
    let names: Vec<&Field> = experiment.simulation.description().compared().collect();
    let panel = |&(component, series): &(usize, &Series)| {
        let name = &names[component].name;
        let line = |(part, words): (&str, &str)| Line {
            name: words.to_owned(),
            points: (outcome.series.samples.iter().map(|sample| sample.time))
                .zip(outcome.series.of(&format!("{name}_{part}")))
                .collect(),
        };
        let drive = series.times.iter().zip(&series.values);
        let within = drive.filter(|&(&time, _)| time <= scenario.end());
        Panel {
            heading: name.clone(),
            lines: SPREAD.map(line).to_vec(),
            curve: within.map(|(&time, &value)| (time, value)).collect(),
            ..Panel::default()
        }
    };
    let panels: Vec<Panel> = driven.iter().take(MOST_PANELS).map(panel).collect();
    let legend = ["particles", "drives the wall"];
    let time = match scenario.units().time.as_str() {
        "1" => "time".to_owned(),
        unit => format!("time, {unit}"),
    };
    let title = format!("{}, over time\n{}", scenario.name(), run(experiment));
    Ok(Some(figure::legended(&title, &time, legend, &panels)?))
}

/// The picture of the probe: along a line, or over a plane; `None` for other shapes.
fn probe(experiment: &Experiment, title: &str) -> Result<Option<String>, Report> {
    let Some(probe) = experiment.scenario.probe() else {
        return Ok(None);
    };
    let description = experiment.simulation.description();
    let names: Vec<(usize, &Field)> = description.compared().enumerate().collect();
    let p = names.len();
    let value = |point: usize, component: usize| experiment.probe[point * p + component];
    let wide = (0..probe.points.len()).filter(|&i| probe.points[i] > 1);
    let title = title.replacen('\n', ", reconstruction\n", 1);
    Ok(match wide.collect::<Vec<_>>()[..] {
        [axis] => {
            let places = probe.positions();
            let exact = experiment.exact.iter().flat_map(|exact| {
                let at = |x: &[f64; 3]| (x[axis], exact.at(*x, experiment.outcome.time));
                places.iter().map(at)
            });
            let exact: Vec<(f64, Vec<f64>)> = exact.collect();
            let panel = |&(component, field): &(usize, &Field)| Panel {
                heading: field.name.clone(),
                points: (0..places.len())
                    .map(|point| (places[point][axis], value(point, component)))
                    .collect(),
                curve: exact.iter().map(|(x, u)| (*x, u[component])).collect(),
                ..Panel::default()
            };
            let panels: Vec<Panel> = names.iter().take(MOST_PANELS).map(panel).collect();
            Some(figure::panels(&title, ["x", "y", "z"][axis], &panels)?)
        }
        [across, up] => {
            let (nx, ny) = (probe.points[across], probe.points[up]);
            let corner = |at: &[f64]| [at[across], at[up]];
            let map = |&(component, field): &(usize, &Field)| Map {
                heading: field.name.clone(),
                // Points run along `up` first, cells along `across`.
                cells: (0..nx * ny)
                    .map(|cell| value((cell % nx) * ny + cell / nx, component))
                    .collect(),
                nx,
                ny,
                lower: corner(&probe.lower),
                upper: corner(&probe.upper),
            };
            let maps: Vec<Map> = names.iter().take(MOST_MAPS).map(map).collect();
            Some(map::maps(&title, &maps)?)
        }
        _ => None,
    })
}
