//! Tables of a run.

use std::path::Path;

use super::table::{WriteError, components, table};
use crate::exact::solution::Solution;
use crate::run::{Series, Simulation};
use crate::scenario::linear::Probe;

/// The particles in id order, with their reconstruction (1.13) and the exact solution beside them,
/// row by row: the cloud is not copied. A cloud of strengths can be read again as one.
pub fn write_particles(
    path: &Path,
    simulation: &dyn Simulation,
    reconstruction: &[f64],
    exact: Option<&dyn Solution>,
) -> Result<(), WriteError> {
    let (description, time) = (simulation.description(), simulation.time());
    let mut heading = vec!["id".to_owned()];
    heading.extend(description.headings());
    let mut smoothed = 0;
    if description.is_state {
        heading.extend(description.exact_headings("reconstructed_"));
        smoothed = description.compared.len();
    }
    let mut solution = vec![0.0; exact.map_or(0, Solution::components)];
    if exact.is_some() {
        heading.extend(description.exact_headings("exact_"));
    }
    table(path, &heading, |rows| {
        let (mut id, mut line) = (0, Vec::with_capacity(heading.len()));
        simulation.visit(|row| {
            line.clear();
            line.push(id as f64);
            line.extend(&row.values);
            line.extend(&reconstruction[id * smoothed..(id + 1) * smoothed]);
            if let Some(exact) = exact {
                exact.write(row.position, time, &mut solution);
                line.extend(&solution);
            }
            id += 1;
            rows.write(&line)
        })
    })
}

/// The time series of the diagnostics.
pub fn write_series(path: &Path, series: &Series) -> Result<(), WriteError> {
    let mut heading = ["time", "steps", "time_step"].map(String::from).to_vec();
    heading.extend(series.names.iter().cloned());
    table(path, &heading, |rows| {
        series.samples.iter().try_for_each(|sample| {
            let mut line = vec![sample.time, sample.steps as f64, sample.time_step];
            line.extend(&sample.values);
            rows.write(&line)
        })
    })
}

/// The reconstruction at the points of a probe, with the exact solution beside it.
pub fn write_probe(
    path: &Path,
    (probe, values): (&Probe, &[f64]),
    simulation: &dyn Simulation,
    exact: Option<&dyn Solution>,
) -> Result<(), WriteError> {
    let (description, dimension) = (simulation.description(), probe.points.len());
    let mut heading = components("position", dimension);
    heading.extend(description.exact_headings(""));
    if exact.is_some() {
        heading.extend(description.exact_headings("exact_"));
    }
    table(path, &heading, |rows| {
        let values = values.chunks_exact(description.compared.len());
        let mut points = probe.positions().into_iter().zip(values);
        points.try_for_each(|(x, u)| {
            let mut line = x[..dimension].to_vec();
            line.extend(u);
            line.extend(
                exact
                    .into_iter()
                    .flat_map(|exact| exact.at(x, simulation.time())),
            );
            rows.write(&line)
        })
    })
}
