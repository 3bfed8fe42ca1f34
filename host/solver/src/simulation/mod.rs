//! A run: the state in memory, the solver around it, what is measured of it.

mod arrays;
mod choice;
mod limits;
mod opening;
mod outcome;
mod plan;
mod planning;
mod run;

pub use arrays::{GasArrays, OptionsArrays, PlainArrays};
pub use choice::in_dimensions;
pub use limits::RunError;
pub(crate) use limits::{check_memory, check_numbers, check_step};
pub use opening::{Incoming, OpenSides, OpenZone};
pub use outcome::{Drift, Lonely, Outcome, ParticleRow, Sample, Spread};
pub use plan::Plan;
pub use planning::PlanError;
pub use run::{Control, Look};
