//! The families of equations: from a scenario to a plan, from a plan to a simulation.
//!
//! | family | equations | from |
//! |---|---|---|
//! | [`gas`] | gas dynamics (3.7), (3.10)-(3.13) | a scenario without `[system]` |
//! | `linear` | first-order systems (1.18) | `[system]` of any other kind |
//! | [`diffusion`] | convection-diffusion (4.1) | `[system]` of kind `convection-diffusion` |
//!
//! The latter two solve for strengths on a cloud that follows a field: [`strengths`] holds what
//! they share. [`start`] is the one table of everything that can be run.

mod apart;
pub mod diffusion;
mod error;
pub mod gas;
mod linear;
pub mod strengths;
mod table;

use crate::exact::formula::FormulaSolution;
use crate::exact::linear::error::SolutionError;
use crate::exact::solution::Solution;
use crate::run::{ENERGY, RECONSTRUCTION, STATE};
use crate::scenario::AnyScenario;
use crate::scenario::formula::Formula;
use crate::scenario::linear::{Exact, Initial, LinearScenario, System};
pub use error::PlanError;
pub use table::start;

/// What a simulation is made of, in solver units, every number still an `f64`.
#[derive(Clone, Debug, PartialEq)]
pub enum Plan {
    /// A gas.
    Gas(Box<gas::Plan>),
    /// A linear system or convection-diffusion.
    Strengths(Box<strengths::Plan>),
}

impl Plan {
    /// The plan of a scenario.
    ///
    /// # Errors
    /// What [`PlanError`] lists.
    pub fn new(scenario: &AnyScenario) -> Result<Self, PlanError> {
        Ok(match scenario {
            AnyScenario::Gas(scenario) => Self::Gas(Box::new(gas::Plan::new(scenario)?)),
            AnyScenario::Linear(scenario) => {
                let start = || self::initial(scenario);
                Self::Strengths(Box::new(strengths::Plan::new(scenario, start)?))
            }
        })
    }

    /// Refuses more particles than can be counted or fit into memory, before any is placed.
    ///
    /// # Errors
    /// That.
    pub fn check_size(scenario: &AnyScenario) -> Result<(), PlanError> {
        match scenario {
            AnyScenario::Gas(scenario) => gas::Plan::check_size(scenario),
            AnyScenario::Linear(scenario) => Ok(strengths::Quadrature::check_size(scenario)?),
        }
    }
}

/// What the state at t = 0 is taken from; `None` where a file holds it.
fn initial(scenario: &LinearScenario) -> Result<Option<Box<dyn Solution>>, SolutionError> {
    match (&scenario.initial, &scenario.system) {
        (Some(Initial::Formula { state } | Initial::Manufactured { state }), _) => {
            Ok(Some(formulas(state)))
        }
        (Some(initial), System::ConvectionDiffusion(of)) => {
            diffusion::start(scenario, of, initial).map(Some)
        }
        _ => linear::solution(scenario),
    }
}

/// What formulas say.
fn formulas(components: &[Formula]) -> Box<dyn Solution> {
    let components = components.to_vec();
    Box::new(FormulaSolution { components })
}

/// Why a scenario has no exact solution after all.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum NoSolution {
    /// Of a gas.
    #[error(transparent)]
    Gas(#[from] gas::ExactError),
    /// Of a linear system or convection-diffusion.
    #[error("the exact solution does not exist: {0}")]
    Strengths(#[from] SolutionError),
}

/// The exact solution that a scenario asks to be compared with, if it does.
///
/// # Errors
/// Data that it does not exist for.
pub fn solution(scenario: &AnyScenario) -> Result<Option<Box<dyn Solution>>, NoSolution> {
    solution_watched(scenario, &mut |_| ())
}

/// The same; `progress` hears the part that is done of what takes long.
///
/// # Errors
/// Data that it does not exist for.
pub fn solution_watched(
    scenario: &AnyScenario,
    progress: &mut dyn FnMut(f64),
) -> Result<Option<Box<dyn Solution>>, NoSolution> {
    let scenario = match scenario {
        AnyScenario::Gas(scenario) => {
            let solution = gas::ExactSolution::watched(scenario, progress)?;
            return Ok(solution.map(|solution| Box::new(solution) as Box<dyn Solution>));
        }
        AnyScenario::Linear(scenario) => scenario,
    };
    match &scenario.output.exact {
        None => return Ok(None),
        Some(Exact::Formula(components)) => return Ok(Some(formulas(components))),
        Some(Exact::Initial) => {}
    }
    Ok(match (&scenario.initial, &scenario.system) {
        (Some(Initial::Manufactured { state }), _) => Some(formulas(state)),
        (Some(initial), System::ConvectionDiffusion(of)) => {
            Some(diffusion::solution(scenario, of, initial)?)
        }
        _ => linear::solution(scenario)?,
    })
}

/// The names of what is compared with an exact solution.
pub fn compared(scenario: &AnyScenario) -> Vec<String> {
    match scenario {
        AnyScenario::Gas(_) => gas::FIELDS.map(String::from).to_vec(),
        AnyScenario::Linear(scenario) => {
            let mut names = scenario.system.names(scenario.dimension);
            let has_units = !matches!(scenario.system, System::ConvectionDiffusion(_));
            let energy = (has_units && names.len() > 1).then_some(ENERGY);
            let whole = [Some(STATE), energy, Some(RECONSTRUCTION)];
            names.extend(whole.into_iter().flatten().map(String::from));
            names
        }
    }
}
