//! What a run tells people and programs.

pub mod convergence;
pub mod figure;
<<<<<<< HEAD
pub mod linear;
pub mod linear_summary;
=======
mod log_axis;
mod log_log;
>>>>>>> converge
pub mod map;
mod raster;
pub mod results;
pub mod suite;
pub mod summary;
