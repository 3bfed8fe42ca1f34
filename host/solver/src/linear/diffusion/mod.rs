//! Convection-diffusion: its problem in solver units, its solver, its state at t = 0 and its exact
//! solution.

mod problem;
pub(super) mod solution;
mod solver;

pub use problem::Media;
pub(super) use problem::form;
pub(super) use solver::{Diffusion, Stepping};
