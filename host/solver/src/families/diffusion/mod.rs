//! Convection-diffusion (4.1).

mod exact;
mod formulas;
mod memory;
mod problem;
mod solver;

pub(super) use exact::{solution, start};
pub use formulas::RunProblem;
pub use problem::Media;
pub(super) use solver::Diffusion;
