//! Files that a run writes. Each is written beside its place and moved there when whole.

mod table;

pub use table::{WriteError, writable, write_particles, write_series, write_text};
