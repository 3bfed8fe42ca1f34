//! A scenario as Rust source for a device: numbers in solver units, written with the digits that
//! read back to the same bits.

mod line;
mod slab;
mod tube;

pub use line::NoLine;
pub use slab::NoSlab;
pub use tube::{NoTube, tube};

use crate::linear::Plan;
use crate::scenario::linear::System;

/// A scenario of `[system]` that is not written.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error(transparent)]
#[diagnostic(transparent)]
pub enum NoSource {
    /// A first-order system.
    Line(#[from] NoLine),
    /// Convection-diffusion.
    Slab(#[from] NoSlab),
}

/// The source of a module for a scenario of `[system]`: a `LINE` of a first-order system or a `SLAB`
/// of convection-diffusion, what it moves with and the capacities it needs.
///
/// `name`: of the scenario; `command`: what made it, for its first line.
///
/// # Errors
/// What is not of one dimension, and more: the help of the error lists what is written.
pub fn linear(name: &str, plan: &Plan, command: &str) -> Result<String, NoSource> {
    Ok(match &plan.system {
        System::ConvectionDiffusion(of) => slab::slab(name, (plan, of), command)?,
        _ => line::line(name, plan, command)?,
    })
}

/// The command that made a file, fit for a line of comment.
fn one_line(command: &str) -> String {
    command.split_whitespace().collect::<Vec<_>>().join(" ")
}
