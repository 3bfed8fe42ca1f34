//! Why a scenario cannot be planned.

use super::strengths::QuadratureError;
use crate::exact::linear::error::SolutionError;
use crate::run::RunError;
use crate::setup::SetupError;
use crate::symmetriser::SymmetriserError;

/// A scenario that cannot be planned.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum PlanError {
    /// The particles cannot be placed.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Setup(#[from] SetupError),
    /// A cut-off that reaches too few or too many particles.
    #[error("{given} makes the cut-off `{cut_off}` reach {reach} spacings: need {least} to {most}")]
    #[diagnostic(help(
        "set cut-off.eta between {} and {} (with theta: eta N^((1-theta)/D)), or cut-off.epsilon to as \
         many spacings",
        least / support,
        most / support
    ))]
    Reach {
        /// What the scenario says, in spacings.
        given: String,
        /// Name of the cut-off.
        cut_off: &'static str,
        /// Its support in units of its width.
        support: f64,
        /// Their product.
        reach: f64,
        /// The least that works.
        least: f64,
        /// The most that is allowed.
        most: f64,
    },
    /// Numbers so large or small that the solver's units are not finite.
    #[error("the unit of {unit} would be {value:e}")]
    #[diagnostic(help("give the scenario in units in which its numbers are nearer to 1"))]
    Extreme {
        /// Which solver unit.
        unit: &'static str,
        /// What it would be.
        value: f64,
    },
    /// Layers that are jumped over.
    #[error(
        "{what} smooths layers over epsilon = {epsilon:e} and would lose some {percent:.1} % of what \
         they resist"
    )]
    #[diagnostic(help("{cure}, which carries a layer of any thickness as a resistance"))]
    Layers {
        /// What would.
        what: &'static str,
        /// How much.
        percent: f64,
        /// The width of the cut-off.
        epsilon: f64,
        /// What to do.
        cure: &'static str,
    },
    /// More particles than fit into memory.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Memory(#[from] RunError),
    /// The points and weights.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Quadrature(#[from] QuadratureError),
    /// A value at the start that is no number.
    #[error("at t = 0 {component} = {value} at x = {position:?}")]
    #[diagnostic(help(
        "change [initial] so that it is an ordinary number everywhere in the domain"
    ))]
    Start {
        /// Which component.
        component: String,
        /// What it is.
        value: f64,
        /// Where, in the scenario's units.
        position: Vec<f64>,
    },
    /// A formula that is no number somewhere.
    #[error("{what} is {value} at x = {position:?}, t = {time}")]
    #[diagnostic(help(
        "change its formula so that it is an ordinary number everywhere in the domain, up to time.end"
    ))]
    NotFinite {
        /// What it gives.
        what: &'static str,
        /// What it is there.
        value: f64,
        /// Where, in the scenario's units.
        position: Vec<f64>,
        /// When.
        time: f64,
    },
    /// A diffusivity that is negative or no number.
    #[error(
        "the diffusivity of {species} is {value} at x = {position:?}, t = {time}: need 0 or more"
    )]
    #[diagnostic(help(
        "change system.diffusivity so that it is so everywhere in the domain, up to time.end"
    ))]
    Diffusivity {
        /// Of which species.
        species: String,
        /// What it is.
        value: f64,
        /// Where, in the scenario's units.
        position: Vec<f64>,
        /// When.
        time: f64,
    },
    /// The exact solution, which the state at t = 0 is taken from.
    #[error("the scenario has no initial state: {0}")]
    Solution(#[from] SolutionError),
    /// Matrices of formulas that are of no hyperbolic system somewhere.
    #[error("at x = {position:?}, t = {time}: {source}")]
    #[diagnostic(help("change system.flux so that it has a symmetriser everywhere (Remark 1)"))]
    Place {
        /// Where, in the scenario's units.
        position: Vec<f64>,
        /// When.
        time: f64,
        /// What is wrong there.
        source: SymmetriserError,
    },
    /// The matrices.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Symmetriser(#[from] SymmetriserError),
}
