//! How many particles there are, and how they are placed.

use std::path::{Path, PathBuf};

use crate::bound::DISTORTION;
use crate::error::Fault;
use crate::resolution::{file, particles};
use crate::section::Section;

/// How many particles, and how they are placed.
#[derive(Debug, Clone, PartialEq)]
pub struct Resolution {
    /// At least 1; exact in one dimension, elsewhere about that many. 0 for a file, which
    /// says how many.
    pub particles: usize,
    /// How they are placed.
    pub arrangement: Arrangement,
}

/// How the particles are placed at t = 0.
#[derive(Debug, Clone, PartialEq)]
pub enum Arrangement {
    /// In the middle of equal cells.
    Lattice,
    /// A lattice under a smooth map of the domain onto itself.
    Distorted {
        /// The largest displacement in lengths of the domain, in (0, 0.15].
        amplitude: f64,
    },
    /// Points of a sequence of low discrepancy, with equal weights.
    LowDiscrepancy,
    /// As a CSV file says: `position_x`, .., `weight` and, without an initial state, the
    /// components by their names.
    File(PathBuf),
}

const ARRANGEMENTS: &[(&str, Arrangement)] = &[
    ("lattice", Arrangement::Lattice),
    ("distorted", Arrangement::Distorted { amplitude: 0.05 }),
    ("low-discrepancy", Arrangement::LowDiscrepancy),
    ("file", Arrangement::File(PathBuf::new())),
];

/// `[resolution]`; a file is looked for in `folder`.
pub(super) fn resolution(section: &Section<'_>, folder: &Path) -> Result<Resolution, Fault> {
    let mut arrangement = match section.optional("arrangement") {
        Some(entry) => entry.choice(ARRANGEMENTS)?,
        None => Arrangement::Lattice,
    };
    let (name, own): (_, &[&str]) = match &mut arrangement {
        Arrangement::Lattice => ("a lattice", &["particles"]),
        Arrangement::Distorted { amplitude } => {
            *amplitude = section.number_or("amplitude", *amplitude, DISTORTION)?;
            ("a distorted lattice", &["particles", "amplitude"])
        }
        Arrangement::LowDiscrepancy => ("a sequence", &["particles"]),
        Arrangement::File(path) => {
            *path = file(section, folder)?;
            ("arrangement = \"file\"", &["file"])
        }
    };
    section.only(name, &["arrangement"], own)?;
    Ok(Resolution {
        particles: match arrangement {
            Arrangement::File(_) => 0,
            _ => particles(section)?,
        },
        arrangement,
    })
}
