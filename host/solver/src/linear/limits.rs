//! Why a run of a linear system cannot be, or did not end.

use motes_core::error::Error;

use crate::exact::linear::error::SolutionError;
use crate::simulation::RunError;
use crate::symmetriser::SymmetriserError;

use super::quadrature::QuadratureError;

/// A run that did not reach its end, or was not begun.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum LinearError {
    /// As of any run.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Run(#[from] RunError),
    /// The particles.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Quadrature(#[from] QuadratureError),
    /// The exact solution, which the state at t = 0 is taken from.
    #[error("the scenario has no initial state: {0}")]
    Solution(#[from] SolutionError),
    /// A cut-off that does not go with the cloud.
    #[error("epsilon = {epsilon:e} is {spacings:.3} spacings: {error}")]
    #[diagnostic(help(
        "epsilon = eta h^theta, with h as a number of the unit of length, so eta goes with that \
         unit: give another eta, or epsilon itself; 1.5 to 4 spacings are usual"
    ))]
    Width {
        /// ε, in the scenario's unit of length.
        epsilon: f64,
        /// The same in mean spacings.
        spacings: f64,
        /// What the solver says of it.
        error: Error,
    },
    /// The matrices.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Symmetriser(#[from] SymmetriserError),
    /// A step that is not stable.
    #[error("time.step = {step:e} is above the stable limit {limit:.6e} at t = {time:?}")]
    #[diagnostic(help("use a smaller step, a larger epsilon, or leave time.step out"))]
    Step {
        /// The step asked for.
        step: f64,
        /// The largest stable one.
        limit: f64,
        /// When.
        time: f64,
    },
    /// A norm that grows faster than that of any solution.
    #[error(
        "at t = {time:?} the energy norm is {norm:.6e}, but no solution grows beyond {bound:.6e}"
    )]
    #[diagnostic(help(
        "the run has become unstable or the cloud too thin: use a smaller time.courant, a larger \
         epsilon or more particles; time.growth-margin is how much more is let pass"
    ))]
    Growth {
        /// When.
        time: f64,
        /// What it has grown to.
        norm: f64,
        /// What it may have grown to.
        bound: f64,
    },
    /// A norm that is no number.
    #[error("at t = {time:?} the energy norm is no number any more")]
    #[diagnostic(help(
        "the run has become unstable, or a reaction grows without end: use a smaller time.courant or \
         time.step, or a slower reaction"
    ))]
    Lost {
        /// When.
        time: f64,
    },
}
