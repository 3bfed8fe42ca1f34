//! Tables as CSV, and plain text.

use std::io::Write;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::comparison::ExactSolution;
use crate::simulation::{Outcome, Sample, Spread};

/// A file that could not be written.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error("cannot write {}", path.display())]
#[diagnostic(help("choose a folder that can be written to with --out"))]
pub struct WriteError {
    path: PathBuf,
    source: std::io::Error,
}

impl WriteError {
    pub(crate) fn new(path: &Path, source: impl Into<std::io::Error>) -> Self {
        Self {
            path: path.to_owned(),
            source: source.into(),
        }
    }
}

/// Makes a folder, and sees whether files can be made in it.
pub fn writable(folder: &Path) -> Result<(), WriteError> {
    let at = |source| WriteError::new(folder, source);
    std::fs::create_dir_all(folder).map_err(at)?;
    NamedTempFile::new_in(folder).map_err(at)?;
    Ok(())
}

/// Writes a file whole or not at all.
pub fn write_text(path: &Path, text: &str) -> Result<(), WriteError> {
    whole(path, |file| file.write_all(text.as_bytes()))
}

/// The name of each component of a vector: `name` itself in one dimension.
pub fn components(name: &str, dimension: usize) -> Vec<String> {
    match dimension {
        1 => vec![name.to_owned()],
        _ => ["x", "y", "z"][..dimension]
            .iter()
            .map(|axis| format!("{name}_{axis}"))
            .collect(),
    }
}

/// The particles at the end, in id order, with the exact solution beside them.
pub fn write_particles(
    path: &Path,
    dimension: usize,
    outcome: &Outcome,
    exact: Option<&ExactSolution>,
) -> Result<(), WriteError> {
    let mut heading = vec!["id".to_owned()];
    heading.extend(components("position", dimension));
    heading.extend(components("velocity", dimension));
    let scalars = [
        "mass",
        "density",
        "pressure",
        "energy",
        "epsilon",
        "neighbours",
        "sound_speed",
        "divergence",
        "viscosity_factor",
        "material",
    ];
    heading.extend(scalars.map(String::from));
    if exact.is_some() {
        heading.push("exact_density".to_owned());
        heading.extend(components("exact_velocity", dimension));
        heading.extend(["exact_pressure", "exact_energy"].map(String::from));
    }
    let rows = outcome.particles.iter().enumerate().map(|(id, p)| {
        let mut row = vec![id as f64];
        row.extend(&p.position[..dimension]);
        row.extend(&p.velocity[..dimension]);
        row.extend([
            p.mass,
            p.density,
            p.pressure,
            p.energy,
            p.epsilon,
            p.neighbours,
            p.sound_speed,
            p.divergence,
            p.viscosity_factor,
            f64::from(p.material),
        ]);
        row.extend(
            exact
                .into_iter()
                .flat_map(|exact| exact.row(p.position, outcome.time)),
        );
        row
    });
    csv(path, &heading, rows)
}

/// The time series of the diagnostics.
pub fn write_series(path: &Path, dimension: usize, series: &[Sample]) -> Result<(), WriteError> {
    let mut heading = ["time", "steps", "time_step", "mass"]
        .map(String::from)
        .to_vec();
    heading.extend(components("momentum", dimension));
    heading.push("energy".to_owned());
    for quantity in ["density", "velocity", "pressure", "neighbours"] {
        heading.extend(["min", "mean", "max"].map(|part| format!("{quantity}_{part}")));
    }
    heading.push("kinetic_energy".to_owned());
    let turns: &[usize] = match dimension {
        1 => &[],
        2 => &[2],
        _ => &[0, 1, 2],
    };
    let axes = ["x", "y", "z"];
    heading.extend(
        turns
            .iter()
            .map(|&i| format!("angular_momentum_{}", axes[i])),
    );
    let rows = series.iter().map(|s| {
        let mut row = vec![s.time, s.steps as f64, s.time_step, s.mass];
        row.extend(&s.momentum[..dimension]);
        row.push(s.energy);
        for Spread { min, mean, max } in [s.density, s.velocity, s.pressure, s.neighbours] {
            row.extend([min, mean, max]);
        }
        row.push(s.kinetic_energy);
        row.extend(turns.iter().map(|&i| s.angular_momentum[i]));
        row
    });
    csv(path, &heading, rows)
}

/// A table of numbers: the shortest digits that read back to the same bits.
pub(super) fn csv(
    path: &Path,
    heading: &[String],
    rows: impl Iterator<Item = Vec<f64>>,
) -> Result<(), WriteError> {
    whole(path, |file| {
        let mut writer = csv::Writer::from_writer(std::io::BufWriter::new(file));
        writer.write_record(heading)?;
        for row in rows {
            writer.write_record(row.iter().map(f64::to_string))?;
        }
        writer.flush()
    })
}

/// Writes beside `path`, then renames.
pub(super) fn whole(
    path: &Path,
    write: impl FnOnce(&mut NamedTempFile) -> std::io::Result<()>,
) -> Result<(), WriteError> {
    let at = |source| WriteError::new(path, source);
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    // Readable by all who may read the folder, as any file a program leaves.
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder).map_err(at)?;
    write(&mut file).map_err(at)?;
    file.persist(path).map_err(|error| at(error.error))?;
    Ok(())
}
