//! Files that a run writes. Each is written beside its place and moved there when whole.

mod levels;
mod linear;
mod series;
mod table;
mod vtu;

pub use levels::write_levels;
pub use linear::{write_cloud, write_history, write_probe};
pub use series::{SnapshotEntry, SnapshotFormat, SnapshotSeries};
pub use table::{WriteError, writable, write_particles, write_series, write_text};
pub(crate) use vtu::escaped;
pub use vtu::{Cloud, write_vtu};
