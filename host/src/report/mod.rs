//! What a run tells people and programs.

pub mod comparison;
pub mod convergence;
pub mod figure;
mod log_axis;
mod log_log;
pub mod map;
pub mod pictures;
mod png;
mod raster;
pub mod results;
pub mod suite;
pub mod summary;
