//! The runs of motes compiled for IEEE double precision.

use motes_solver::compiled::Compiled;

/// IEEE double precision.
pub static F64: Compiled = Compiled::new::<f64>();
