//! Linear first-order systems (1.18).

mod exact;
mod memory;
mod problem;
mod solver;
mod source;
mod variable;

pub(super) use exact::solution;
pub(super) use solver::FirstOrder;
pub(super) use source::SourceFormulas;
