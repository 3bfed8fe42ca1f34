//! What a run tells people and programs.

pub mod convergence;
pub mod figure;
pub mod linear;
pub mod linear_summary;
mod log_axis;
mod log_log;
pub mod map;
mod raster;
pub mod results;
pub mod suite;
pub mod summary;
