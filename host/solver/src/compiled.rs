//! The simulations of one scalar, as what a crate can hold compiled.

use crate::engine::{HostScalar, Threads};
use crate::families::{self, Plan};
use crate::run::{RunError, Simulation};

/// What makes the simulations of one scalar: from a plan of any family and the name of the scalar,
/// for messages.
pub type Start = fn(Plan, &str, &mut Threads) -> Result<Box<dyn Simulation>, RunError>;

/// The simulations of one scalar.
///
/// A `static` of this type is where the code for its scalar is made: minutes of work for the
/// compiler, which several crates share.
#[derive(Clone, Copy, Debug)]
pub struct Compiled {
    /// A simulation at its start.
    pub start: Start,
}

impl Compiled {
    /// All of them.
    pub const fn new<S: HostScalar>() -> Self {
        Self {
            start: families::start::<S>,
        }
    }
}
