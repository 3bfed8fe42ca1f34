//! Tables as CSV, and plain text.

use std::io::Write;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

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
    tempfile::Builder::new()
        .prefix(PREFIX)
        .tempfile_in(folder)
        .map_err(at)?;
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

/// Writes a table of numbers: the shortest digits that read back to the same bits, nothing where
/// there is no finite number.
pub(super) fn table(
    path: &Path,
    heading: &[String],
    fill: impl FnOnce(&mut Rows<'_>) -> std::io::Result<()>,
) -> Result<(), WriteError> {
    whole(path, |file| {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(heading)?;
        let mut rows = Rows {
            writer,
            digits: String::new(),
        };
        fill(&mut rows)?;
        rows.writer.flush()
    })
}

/// The rows of a table that is being written.
pub(super) struct Rows<'a> {
    writer: csv::Writer<&'a mut NamedTempFile>,
    digits: String,
}

impl Rows<'_> {
    /// Adds a row.
    pub fn write(&mut self, row: &[f64]) -> std::io::Result<()> {
        use std::fmt::Write;
        for number in row {
            self.digits.clear();
            // Where there is no number, as a bound that nothing gives: no table reads `inf`.
            if number.is_finite() {
                // Writing to a string cannot fail.
                let _ = write!(self.digits, "{number}");
            }
            self.writer.write_field(&self.digits)?;
        }
        self.writer.write_record(None::<&[u8]>)?;
        Ok(())
    }
}

/// What the names of files begin with that are not whole yet.
pub(super) const PREFIX: &str = ".motes-";

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
    builder.prefix(PREFIX);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder).map_err(at)?;
    write(&mut file).map_err(at)?;
    // Before it takes its name: a name without the bytes would outlive a loss of power.
    file.as_file().sync_all().map_err(at)?;
    file.persist(path).map_err(|error| at(error.error))?;
    // The name itself; a file system that syncs no folders has its own way.
    #[cfg(unix)]
    if let Ok(folder) = std::fs::File::open(folder) {
        let _ = folder.sync_all();
    }
    Ok(())
}
