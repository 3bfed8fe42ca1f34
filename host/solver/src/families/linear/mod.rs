//! Linear first-order systems (1.18).

mod exact;
mod memory;
mod problem;
mod solver;

pub(super) use exact::solution;
pub(super) use solver::FirstOrder;
