//! The runs of motes compiled for IEEE single precision.

use motes_solver::compiled::Compiled;

/// IEEE single precision.
pub static F32: Compiled = Compiled::new::<f32>();
