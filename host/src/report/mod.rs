//! What a run tells people and programs.

pub mod figure;
pub mod linear;
pub mod linear_summary;
pub mod map;
mod raster;
pub mod results;
pub mod suite;
pub mod summary;
