//! Runs of linear systems and convection-diffusion: from a scenario to a plan in solver units, its
//! particles stepped to the end, and the result compared with the exact solution.

mod arrays;
mod choice;
mod comparison;
mod diffusion;
mod doubts;
mod field;
mod growth;
mod limits;
mod outcome;
mod plan;
mod quadrature;
mod run;
mod solution;
mod solver;
mod systems;

pub use choice::in_dimensions;
pub use comparison::{RECONSTRUCTION, STATE, errors};
pub use diffusion::Media;
pub use doubts::{doubts, undamped};
pub use limits::LinearError;
pub use outcome::{Cloud, Energy, Outcome, Sample};
pub use plan::Plan;
pub use quadrature::{Quadrature, QuadratureError};
pub use run::{Control, Look};
pub use solution::solution;
