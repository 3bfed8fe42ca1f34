//! Tables of a run of a linear system.

use std::path::Path;

use super::table::{WriteError, components, csv};
use crate::exact::linear::solution::Solution;
use crate::linear::{Outcome, Sample};
use crate::scenario::linear::Probe;
use crate::simulation::Spread;

/// The particles at the end, in id order, with the reconstruction (1.13) and the exact solution
/// beside them. With its `position`, `weight` and components it can be read as a cloud.
pub fn write_cloud(
    path: &Path,
    dimension: usize,
    names: &[String],
    outcome: &Outcome,
    exact: Option<&dyn Solution>,
) -> Result<(), WriteError> {
    let mut heading = vec!["id".to_owned()];
    heading.extend(components("position", dimension));
    heading.push("weight".to_owned());
    heading.extend(names.iter().cloned());
    heading.push("neighbours".to_owned());
    heading.extend(names.iter().map(|name| format!("reconstructed_{name}")));
    if exact.is_some() {
        heading.extend(names.iter().map(|name| format!("exact_{name}")));
    }
    let (cloud, p) = (&outcome.cloud, names.len());
    let rows = (0..cloud.len()).map(|id| {
        let mut row = vec![id as f64];
        row.extend(&cloud.positions[id][..dimension]);
        row.push(cloud.weights[id]);
        row.extend(cloud.value(id));
        row.push(cloud.neighbours[id]);
        row.extend(&outcome.reconstruction[id * p..(id + 1) * p]);
        if let Some(exact) = exact {
            row.extend(exact.at(cloud.positions[id], outcome.time));
        }
        row
    });
    csv(path, &heading, rows)
}

/// The time series of the diagnostics.
pub fn write_history(path: &Path, names: &[String], series: &[Sample]) -> Result<(), WriteError> {
    let mut heading = ["time", "steps", "time_step", "energy_norm", "energy_bound"]
        .map(String::from)
        .to_vec();
    heading.extend(names.iter().map(|name| format!("total_{name}")));
    let quantities = names.iter().map(String::as_str).chain(["neighbours"]);
    for quantity in quantities {
        heading.extend(["min", "mean", "max"].map(|part| format!("{quantity}_{part}")));
    }
    let rows = series.iter().map(|s| {
        let mut row = vec![s.time, s.steps as f64, s.time_step];
        row.extend([s.energy.norm, s.energy.bound]);
        row.extend(&s.totals);
        for Spread { min, mean, max } in s.spreads.iter().chain([&s.neighbours]) {
            row.extend([min, mean, max]);
        }
        row
    });
    csv(path, &heading, rows)
}

/// The reconstruction at the points of a probe, with the exact solution beside it.
pub fn write_probe(
    path: &Path,
    probe: &Probe,
    names: &[String],
    outcome: &Outcome,
    exact: Option<&dyn Solution>,
) -> Result<(), WriteError> {
    let dimension = probe.points.len();
    let mut heading = components("position", dimension);
    heading.extend(names.iter().cloned());
    if exact.is_some() {
        heading.extend(names.iter().map(|name| format!("exact_{name}")));
    }
    let values = outcome.probe.chunks_exact(names.len());
    let rows = probe.positions().into_iter().zip(values).map(|(x, u)| {
        let mut row = x[..dimension].to_vec();
        row.extend(u);
        if let Some(exact) = exact {
            row.extend(exact.at(x, outcome.time));
        }
        row
    });
    csv(path, &heading, rows)
}
