//! Convection-diffusion (4.1).

mod exact;
mod formulas;
mod memory;
mod problem;
mod solver;

pub(super) use exact::{solution, start};
pub use formulas::{DrivenWall, Formulas, MARGIN, RunProblem};
pub use problem::{Media, form};
pub(super) use solver::Diffusion;
