//! The runs of motes compiled for `f32` with approximate square roots.

use motes_core::scalar::Micro;
use motes_solver::compiled::Compiled;

/// `f32` with approximate square roots.
pub static MICROMATH: Compiled = Compiled::new::<Micro>();
