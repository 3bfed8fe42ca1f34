//! The files of a run of a linear system: tables, pictures, and the scenario as it was run.

use std::path::Path;

use miette::Report;

use super::figure::{self, MOST_PANELS, Panel};
use super::map::{self, MOST_MAPS, Map, rasterised};
use crate::io;
use crate::linear::Experiment;
use crate::scenario::linear::Series;

/// Points of the curve of an exact solution.
const POINTS: usize = 1000;

/// Cells of a map along its longer side.
const CELLS: f64 = 128.0;

/// Writes all result files into a folder.
///
/// # Errors
/// Files that cannot be written.
pub fn write(out: &Path, experiment: &Experiment) -> Result<(), Report> {
    let (scenario, outcome) = (&experiment.scenario, &experiment.outcome);
    let exact = experiment.exact.as_deref();
    let names = &experiment.plan.names;
    io::write_text(&out.join("scenario.toml"), &scenario.text)?;
    for (_, series) in scenario.system.driven() {
        // Beside the scenario, so that it can be run again; one in another folder is still there.
        if Path::new(&series.file).file_name() == Some(series.file.as_ref()) {
            io::write_text(&out.join(&series.file), &series.text)?;
        }
    }
    let dimension = scenario.dimension;
    io::write_cloud(&out.join("particles.csv"), dimension, names, outcome, exact)?;
    io::write_history(&out.join("series.csv"), names, &outcome.series)?;
    if let Some(probe) = &scenario.output.probe {
        io::write_probe(&out.join("probe.csv"), probe, names, outcome, exact)?;
    }
    for (name, picture) in pictures(experiment)? {
        io::write_text(&out.join(name), &picture)?;
    }
    Ok(())
}

/// The pictures of a run by the name of their files: components along x, in two dimensions maps
/// of them, and what the probe saw.
///
/// # Errors
/// A picture that cannot be drawn.
pub fn pictures(experiment: &Experiment) -> Result<Vec<(&'static str, String)>, Report> {
    let outcome = &experiment.outcome;
    let title = format!(
        "{}, {} particles, t = {:.6}",
        experiment.scenario.name,
        outcome.cloud.len(),
        outcome.time
    );
    let panels = panels(experiment);
    let mut pictures = vec![(
        "figure.svg",
        figure::panels(&title, abscissa(experiment), &panels)?,
    )];
    if experiment.scenario.dimension == 2 {
        pictures.push(("map.svg", map::maps(&title, &cloud_maps(experiment))?));
    }
    if let Some((name, picture)) = probe(experiment, &title)? {
        pictures.push((name, picture));
    }
    pictures.extend(history(experiment)?.map(|picture| ("history.svg", picture)));
    Ok(pictures)
}

/// What walls are driven by over time, and what becomes of the species; `None` where no series
/// drives one.
fn history(experiment: &Experiment) -> Result<Option<String>, Report> {
    let (scenario, samples) = (&experiment.scenario, &experiment.outcome.series);
    let driven = scenario.system.driven();
    if driven.is_empty() {
        return Ok(None);
    }
    let panel = |&(component, series): &(usize, &Series)| {
        let spreads = samples.iter().map(|s| (s.time, &s.spreads[component]));
        let points = spreads.flat_map(|(time, spread)| {
            [spread.min, spread.mean, spread.max].map(|value| (time, value))
        });
        let drive = series.times.iter().zip(&series.values);
        let within = drive.filter(|&(&time, _)| time <= scenario.time.end);
        Panel {
            heading: experiment.plan.names[component].clone(),
            points: points.collect(),
            curve: within.map(|(&time, &value)| (time, value)).collect(),
        }
    };
    let panels: Vec<Panel> = driven.iter().take(MOST_PANELS).map(panel).collect();
    let legend = ["smallest, mean, largest", "drives the wall"];
    let time = match scenario.units.time.as_str() {
        "1" => "time".to_owned(),
        unit => format!("time, {unit}"),
    };
    let title = format!("{}, over time", scenario.name);
    Ok(Some(figure::legended(&title, &time, legend, &panels)?))
}

/// What the figure is drawn over.
fn abscissa(experiment: &Experiment) -> &'static str {
    match experiment.scenario.dimension {
        1 => "position",
        _ => "x, along the line through the middle",
    }
}

/// A panel for each component: in one dimension all particles, in more those within half a
/// spacing of the line along x through the middle of the window.
fn panels(experiment: &Experiment) -> Vec<Panel> {
    let (scenario, outcome) = (&experiment.scenario, &experiment.outcome);
    let window = &scenario.output.window;
    let middle: [f64; 3] = std::array::from_fn(|i| window.middle(i));
    let half = 0.5 * experiment.plan.units.length;
    let near = |x: &[f64; 3]| (1..scenario.dimension).all(|i| (x[i] - middle[i]).abs() <= half);
    let cloud = &outcome.cloud;
    let inside: Vec<usize> = (0..cloud.len())
        .filter(|&id| window.contains(&cloud.positions[id]) && near(&cloud.positions[id]))
        .collect();
    let (lower, upper) = (window.lower[0], window.upper[0]);
    let curves: Vec<(f64, Vec<f64>)> = experiment
        .exact
        .iter()
        .flat_map(|exact| {
            (0..=POINTS).map(|i| {
                let mut place = middle;
                place[0] = lower + (upper - lower) * i as f64 / POINTS as f64;
                (place[0], exact.at(place, outcome.time))
            })
        })
        .collect();
    let names = experiment.plan.names.iter().enumerate().take(MOST_PANELS);
    names
        .map(|(component, name)| Panel {
            heading: name.clone(),
            points: inside
                .iter()
                .map(|&id| (cloud.positions[id][0], cloud.value(id)[component]))
                .collect(),
            curve: curves.iter().map(|(x, u)| (*x, u[component])).collect(),
        })
        .collect()
}

/// A map of each of the first components over the window.
fn cloud_maps(experiment: &Experiment) -> Vec<Map> {
    let window = &experiment.scenario.output.window;
    let corner = |at: &[f64]| [at[0], at[1]];
    let (lower, upper) = (corner(&window.lower), corner(&window.upper));
    let size = [upper[0] - lower[0], upper[1] - lower[1]];
    let cell = size[0].max(size[1]) / CELLS;
    let cells = size.map(|length| ((length / cell).round() as usize).max(1));
    let cloud = &experiment.outcome.cloud;
    let positions: Vec<[f64; 2]> = cloud.positions.iter().map(|x| corner(x)).collect();
    let spacing = experiment.plan.units.length;
    let names = experiment.plan.names.iter().enumerate().take(MOST_MAPS);
    names
        .map(|(component, name)| Map {
            heading: name.clone(),
            cells: rasterised(
                &positions,
                &cloud.component(component),
                1.3 * spacing,
                lower,
                upper,
                cells,
            ),
            nx: cells[0],
            ny: cells[1],
            lower,
            upper,
        })
        .collect()
}

/// The picture of the probe: along a line, or over a plane; `None` for other shapes.
fn probe(experiment: &Experiment, title: &str) -> Result<Option<(&'static str, String)>, Report> {
    let Some(probe) = &experiment.scenario.output.probe else {
        return Ok(None);
    };
    let (outcome, names) = (&experiment.outcome, &experiment.plan.names);
    let p = names.len();
    let value = |point: usize, component: usize| outcome.probe[point * p + component];
    let wide: Vec<usize> = (0..probe.points.len())
        .filter(|&i| probe.points[i] > 1)
        .collect();
    let title = format!("{title}, reconstruction");
    let places = probe.positions();
    match wide[..] {
        [axis] => {
            let panel = |(component, name): (usize, &String)| Panel {
                heading: name.clone(),
                points: (0..places.len())
                    .map(|point| (places[point][axis], value(point, component)))
                    .collect(),
                curve: experiment
                    .exact
                    .iter()
                    .flat_map(|exact| {
                        places
                            .iter()
                            .map(|&x| (x[axis], exact.at(x, outcome.time)[component]))
                    })
                    .collect(),
            };
            let panels: Vec<Panel> = names
                .iter()
                .enumerate()
                .take(MOST_PANELS)
                .map(panel)
                .collect();
            let label = ["x", "y", "z"][axis];
            Ok(Some(("probe.svg", figure::panels(&title, label, &panels)?)))
        }
        [across, up] => {
            let (nx, ny) = (probe.points[across], probe.points[up]);
            let corner = |at: &[f64]| [at[across], at[up]];
            let map = |(component, name): (usize, &String)| Map {
                heading: name.clone(),
                // Points run along `up` first, cells along `across`.
                cells: (0..nx * ny)
                    .map(|cell| value((cell % nx) * ny + cell / nx, component))
                    .collect(),
                nx,
                ny,
                lower: corner(&probe.lower),
                upper: corner(&probe.upper),
            };
            let maps: Vec<Map> = names.iter().enumerate().take(MOST_MAPS).map(map).collect();
            Ok(Some(("probe.svg", map::maps(&title, &maps)?)))
        }
        _ => Ok(None),
    }
}
