//! The files of a run: tables, pictures, and the scenario as it was run.

use std::path::Path;

use miette::Report;

use super::pictures::pictures;
use crate::experiment::Experiment;
use crate::io::{self, RunFolder};

/// Writes all result files into a folder; the name of the one to open first.
///
/// # Errors
/// Files that cannot be written.
pub fn write(out: &mut RunFolder, experiment: &Experiment) -> Result<&'static str, Report> {
    let (scenario, simulation) = (&experiment.scenario, &*experiment.simulation);
    let exact = experiment.exact.as_deref();
    out.write("scenario.toml", scenario.text())?;
    for (_, series) in scenario.driven() {
        // Beside the scenario, so that it can be run again; one in another folder is still there.
        if Path::new(&series.file).file_name() == Some(series.file.as_ref()) {
            out.write(&series.file, &series.text)?;
        }
    }
    let particles = out.place("particles.csv")?;
    io::write_particles(&particles, simulation, &experiment.reconstruction, exact)?;
    io::write_series(&out.place("series.csv")?, &experiment.outcome.series)?;
    if let Some(probe) = scenario.probe() {
        let values = (probe, &experiment.probe[..]);
        io::write_probe(&out.place("probe.csv")?, values, simulation, exact)?;
    }
    let pictures = pictures(experiment)?;
    for (name, picture) in &pictures {
        out.write(name, picture)?;
    }
    // The map where there is one: it says more of a plane than a line does.
    let map = pictures.iter().find(|(name, _)| *name == "map.svg");
    Ok(map.or(pictures.first()).map_or("", |(name, _)| name))
}
