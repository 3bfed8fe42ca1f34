//! Files that a run writes. Each is written beside its place and moved there when whole.

mod checkpoint;
mod folder;
mod formats;
mod levels;
mod run;
mod series;
mod table;
mod vtu;

pub use checkpoint::{Checkpoint, CheckpointError, Header, Input, Origin, write_checkpoint};
pub use folder::{FolderError, RunFolder};
pub use formats::write_formats;
pub use levels::write_levels;
pub use run::{write_particles, write_probe, write_series};
pub use series::{SNAPSHOTS, SnapshotEntry, SnapshotFormat, SnapshotSeries};
pub use table::{WriteError, writable, write_text};
pub(crate) use vtu::escaped;
pub use vtu::{Cloud, write_vtu};
