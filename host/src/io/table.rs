//! Tables as CSV, and plain text.

use std::io::Write;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::comparison::{ExactSolution, FIELDS};
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

/// The particles at the end, in id order, with the exact solution beside them.
pub fn write_particles(
    path: &Path,
    outcome: &Outcome,
    exact: Option<&ExactSolution>,
) -> Result<(), WriteError> {
    let mut heading = vec![
        "id",
        "position",
        "velocity",
        "mass",
        "density",
        "pressure",
        "energy",
        "epsilon",
        "neighbours",
    ];
    let exact_heading = FIELDS.map(|field| format!("exact_{field}"));
    if exact.is_some() {
        heading.extend(exact_heading.iter().map(String::as_str));
    }
    let rows = outcome.particles.iter().enumerate().map(|(id, p)| {
        let mut row = vec![
            id as f64,
            p.position,
            p.velocity,
            p.mass,
            p.density,
            p.pressure,
            p.energy,
            p.epsilon,
            p.neighbours,
        ];
        row.extend(
            exact
                .into_iter()
                .flat_map(|exact| exact.at(p.position, outcome.time)),
        );
        row
    });
    csv(path, &heading, rows)
}

/// The time series of the diagnostics.
pub fn write_series(path: &Path, series: &[Sample]) -> Result<(), WriteError> {
    let mut heading: Vec<String> = ["time", "steps", "time_step", "mass", "momentum", "energy"]
        .map(String::from)
        .into();
    for quantity in ["density", "velocity", "pressure", "neighbours"] {
        heading.extend(["min", "mean", "max"].map(|part| format!("{quantity}_{part}")));
    }
    let heading: Vec<&str> = heading.iter().map(String::as_str).collect();
    let rows = series.iter().map(|s| {
        let mut row = vec![
            s.time,
            s.steps as f64,
            s.time_step,
            s.mass,
            s.momentum,
            s.energy,
        ];
        for Spread { min, mean, max } in [s.density, s.velocity, s.pressure, s.neighbours] {
            row.extend([min, mean, max]);
        }
        row
    });
    csv(path, &heading, rows)
}

/// A table of numbers: the shortest digits that read back to the same bits.
pub(super) fn csv(
    path: &Path,
    heading: &[&str],
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
