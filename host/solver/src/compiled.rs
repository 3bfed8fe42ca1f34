//! The runs of one scalar, as what a crate can hold compiled.

use crate::engine::{HostScalar, Threads};
use crate::linear::{self, LinearError};
use crate::simulation::{self, RunError};

/// Runs a plan of gas dynamics; the text is the name of the scalar, for messages.
pub type RunGas = fn(
    &simulation::Plan,
    &str,
    &mut Threads,
    &mut simulation::Control<'_>,
) -> Result<simulation::Outcome, RunError>;

/// Runs a plan of a linear system or of convection-diffusion.
pub type RunLinear = fn(
    &linear::Plan,
    &str,
    &mut Threads,
    &mut linear::Control<'_>,
) -> Result<linear::Outcome, LinearError>;

/// The runs of one scalar.
///
/// A `static` of this type is where the code for its scalar is made: minutes of work for the
/// compiler, which several crates share.
#[derive(Clone, Copy, Debug)]
pub struct Compiled {
    /// Gas dynamics.
    pub gas: RunGas,
    /// Linear systems and convection-diffusion.
    pub linear: RunLinear,
}

impl Compiled {
    /// All of them.
    pub const fn new<S: HostScalar>() -> Self {
        Self {
            gas: simulation::in_dimensions::<S>,
            linear: linear::in_dimensions::<S>,
        }
    }
}
