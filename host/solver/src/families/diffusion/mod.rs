//! Convection-diffusion (4.1).

mod exact;
mod memory;
mod problem;
mod solver;

pub(super) use exact::{solution, start};
pub use problem::Media;
pub(super) use solver::Diffusion;
