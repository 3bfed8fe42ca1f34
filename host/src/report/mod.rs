//! What a run tells people and programs.

pub mod figure;
pub mod map;
mod raster;
pub mod results;
pub mod suite;
pub mod summary;
