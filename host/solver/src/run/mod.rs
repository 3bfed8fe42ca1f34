//! A run that can be held: stepped by one verb, looked into through a description of its fields.
//!
//! Knows no equation. What every family of equations is seen as stands in `simulation` and
//! `description`, the run loop in `complete`, what it measures on its way in `logbook`, what it leaves in
//! `outcome`;
//! `pace` says whether it ends in a time that one waits for.

mod balance;
mod complete;
mod derived;
mod description;
mod error;
mod limits;
mod logbook;
mod norms;
mod outcome;
mod pace;
mod schedule;
mod simulation;
mod spread;

pub use balance::Balance;
pub(crate) use balance::{inflow, side};
pub use complete::{Control, Keep, complete, pass_run};
pub(crate) use description::fields;
pub use description::{Abscissa, Description, Field, Kind, View};
pub use error::RunError;
pub(crate) use limits::{check_memory, check_numbers, check_step};
pub use logbook::Logbook;
pub use norms::{ENERGY, NormSums, Norms, Portion, RECONSTRUCTION, STATE, Window, errors};
pub use outcome::{Outcome, Sample, Series};
pub use pace::{Mark, Pace};
pub use schedule::Schedule;
pub(crate) use schedule::Stops;
pub use simulation::{EnergyNorm, Measures, Particulars, Row, Simulation, Step, Sum};
pub use spread::{Spread, Spreading};
