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

pub mod diffusion;
mod error;
pub mod gas;
mod linear;
pub mod strengths;

use std::sync::Arc;

use motes_core::equation::linear::FirstOrderSystem;

use crate::engine::{HostScalar, Threads};
use crate::exact::linear::error::SolutionError;
use crate::exact::solution::Solution;
use crate::run::{RECONSTRUCTION, RunError, STATE, Simulation};
use crate::scenario::AnyScenario;
use crate::scenario::linear::{LinearScenario, System};
pub use error::PlanError;

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
        (Some(initial), System::ConvectionDiffusion(of)) => {
            diffusion::start(scenario, of, initial).map(Some)
        }
        _ => linear::solution(scenario),
    }
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
    let scenario = match scenario {
        AnyScenario::Gas(scenario) => {
            let solution = gas::ExactSolution::of(scenario)?;
            return Ok(solution.map(|solution| Box::new(solution) as Box<dyn Solution>));
        }
        AnyScenario::Linear(scenario) => scenario,
    };
    if !scenario.output.exact {
        return Ok(None);
    }
    Ok(match (&scenario.initial, &scenario.system) {
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
            names.extend([STATE, RECONSTRUCTION].map(String::from));
            names
        }
    }
}

/// A simulation at its start; `scalar` is the name of the scalar, for messages.
///
/// # Errors
/// Numbers that the scalar cannot hold, too little memory, and what the solver finds.
pub fn start<S: HostScalar>(
    plan: Plan,
    scalar: &str,
    engine: &mut Threads,
) -> Result<Box<dyn Simulation>, RunError> {
    let plan = match plan {
        Plan::Gas(plan) => {
            return match plan.dimension {
                1 => gas::start::<S, 1>(*plan, scalar, engine),
                2 => gas::start::<S, 2>(*plan, scalar, engine),
                _ => gas::start::<S, 3>(*plan, scalar, engine),
            };
        }
        Plan::Strengths(plan) => *plan,
    };
    use strengths::Plan as Of;
    let (dimension, components) = (plan.dimension, plan.names.len());
    let call = Call {
        plan,
        scalar,
        engine,
    };
    match (call.plan.system.clone(), dimension, components) {
        (System::Transport { .. }, 1, _) => call.system::<S, _, 1, 1>(Of::transport),
        (System::Transport { .. }, 2, _) => call.system::<S, _, 2, 1>(Of::transport),
        (System::Transport { .. }, ..) => call.system::<S, _, 3, 1>(Of::transport),
        (System::Acoustics { .. }, 1, _) => call.system::<S, _, 1, 2>(Of::acoustics),
        (System::Acoustics { .. }, 2, _) => call.system::<S, _, 2, 3>(Of::acoustics),
        (System::Acoustics { .. }, ..) => call.system::<S, _, 3, 4>(Of::acoustics),
        (System::Telegraph { .. }, ..) => call.system::<S, _, 1, 2>(Of::telegraph),
        (System::ShallowWater { .. }, ..) => call.system::<S, _, 2, 3>(Of::shallow_water),
        (System::MaxwellTe { .. }, ..) => call.system::<S, _, 2, 3>(Of::maxwell),
        (System::ElasticWaves { .. }, ..) => call.system::<S, _, 2, 5>(Of::elastic_waves),
        (System::LinearisedGas { .. }, 1, _) => call.system::<S, _, 1, 3>(Of::linearised_gas),
        (System::LinearisedGas { .. }, 2, _) => call.system::<S, _, 2, 4>(Of::linearised_gas),
        (System::LinearisedGas { .. }, ..) => call.system::<S, _, 3, 5>(Of::linearised_gas),
        // Of a system given by its matrices: the least that hold its components.
        (System::Matrices { .. }, 1, 0..=2) => call.system::<S, _, 1, 2>(Of::matrices),
        (System::Matrices { .. }, 1, 3..=4) => call.system::<S, _, 1, 4>(Of::matrices),
        (System::Matrices { .. }, 1, _) => call.system::<S, _, 1, 8>(Of::matrices),
        (System::Matrices { .. }, 2, 0..=2) => call.system::<S, _, 2, 2>(Of::matrices),
        (System::Matrices { .. }, 2, 3..=4) => call.system::<S, _, 2, 4>(Of::matrices),
        (System::Matrices { .. }, 2, _) => call.system::<S, _, 2, 8>(Of::matrices),
        (System::Matrices { .. }, _, 0..=2) => call.system::<S, _, 3, 2>(Of::matrices),
        (System::Matrices { .. }, _, 3..=4) => call.system::<S, _, 3, 4>(Of::matrices),
        (System::Matrices { .. }, ..) => call.system::<S, _, 3, 8>(Of::matrices),
        (System::ConvectionDiffusion(of), 1, 1) => call.diffusion::<S, 1, 1>(&of),
        (System::ConvectionDiffusion(of), 1, _) => call.diffusion::<S, 1, 4>(&of),
        (System::ConvectionDiffusion(of), 2, 1) => call.diffusion::<S, 2, 1>(&of),
        (System::ConvectionDiffusion(of), 2, 2) => call.diffusion::<S, 2, 2>(&of),
        (System::ConvectionDiffusion(of), 2, _) => call.diffusion::<S, 2, 4>(&of),
        (System::ConvectionDiffusion(of), _, 1) => call.diffusion::<S, 3, 1>(&of),
        (System::ConvectionDiffusion(of), ..) => call.diffusion::<S, 3, 4>(&of),
    }
}

/// A simulation of strengths with everything but its types chosen.
struct Call<'a> {
    plan: strengths::Plan,
    scalar: &'a str,
    engine: &'a mut Threads,
}

impl Call<'_> {
    /// A first-order system.
    fn system<S, F, const D: usize, const P: usize>(
        self,
        system: impl Fn(&strengths::Plan) -> Option<F>,
    ) -> Result<Box<dyn Simulation>, RunError>
    where
        S: HostScalar,
        F: FirstOrderSystem<S, D, P> + Send + 'static,
        F::Medium: Send,
    {
        let Some(system) = system(&self.plan) else {
            unreachable!("the table above asks a plan for its own system");
        };
        let solver = |plan: &Arc<strengths::Plan>| linear::FirstOrder::new(plan, system);
        strengths::start::<S, linear::FirstOrder<S, F, D, P>, D, P>(
            self.plan,
            solver,
            self.scalar,
            self.engine,
        )
    }

    /// Convection-diffusion.
    fn diffusion<S: HostScalar, const D: usize, const P: usize>(
        self,
        of: &crate::scenario::linear::ConvectionDiffusion,
    ) -> Result<Box<dyn Simulation>, RunError> {
        let solver = |plan: &Arc<strengths::Plan>| diffusion::Diffusion::new(plan, of);
        strengths::start::<S, diffusion::Diffusion<S>, D, P>(
            self.plan,
            solver,
            self.scalar,
            self.engine,
        )
    }
}
