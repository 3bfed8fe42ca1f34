//! How many particles there are, whatever is simulated.

use std::path::{Path, PathBuf};

use crate::error::Fault;
use crate::section::Section;

/// How many particles there are in the whole domain.
pub(super) fn particles(section: &Section<'_>) -> Result<usize, Fault> {
    section.required("particles")?.count(
        u32::MAX,
        "1 to 4294967295",
        "give the number of particles in the whole domain, for example 900",
    )
}

/// The file that holds the particles.
pub(super) fn file(section: &Section<'_>, folder: &Path) -> Result<PathBuf, Fault> {
    Ok(folder.join(section.required("file")?.text()?))
}
