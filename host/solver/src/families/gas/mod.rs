//! Gas dynamics.

mod background;
mod balance;
mod description;
mod doubts;
mod exact;
mod far;
mod fitness;
mod limits;
mod measures;
mod memory;
mod opening;
mod packing;
mod plan;
mod planning;
mod simulation;
mod walls;
mod warnings;

pub use exact::{ExactError, ExactSolution, FIELDS};
pub use memory::{GasArrays, OptionsArrays, PlainArrays};
pub use opening::{Incoming, OpenSides, OpenZone};
pub use plan::{Plan, SMALLEST_OMEGA};
pub(super) use simulation::start;
