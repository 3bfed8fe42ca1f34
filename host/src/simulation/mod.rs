//! A run: the state in memory, the solver around it, what is measured of it.

mod arrays;
mod outcome;
mod plan;
mod run;
mod scalars;

pub use arrays::GasArrays;
pub use outcome::{Drift, Lonely, Outcome, ParticleRow, Sample, Spread};
pub use plan::{Plan, PlanError};
pub use run::{Control, RunError};
pub use scalars::{ScalarName, UnknownScalar, run};
