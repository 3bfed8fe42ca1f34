//! The runs of motes compiled for IEEE floats.

use motes_solver::compiled::Compiled;

/// IEEE double precision.
pub static F64: Compiled = Compiled::fast::<f64>();
/// IEEE single precision.
pub static F32: Compiled = Compiled::fast::<f32>();
