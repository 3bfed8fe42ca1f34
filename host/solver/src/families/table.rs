//! The table of everything that can be run: family, system, dimension and components, in a scalar.

use motes_core::equation::linear::{FirstOrderSystem, Sourced};

use super::diffusion::Diffusion;
use super::linear::{FirstOrder, SourceFormulas};
use super::strengths::Maker;
use super::{Plan, gas, strengths};
use crate::engine::{HostScalar, Threads};
use crate::run::{RunError, Simulation};
use crate::scenario::linear::System;

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
    let maker = match (&plan.system, plan.dimension, plan.row()) {
        (System::Transport { .. }, 1, _) => first_order::<S, _, 1, 1>(&plan, plan.transport()),
        (System::Transport { .. }, 2, _) => first_order::<S, _, 2, 1>(&plan, plan.transport()),
        (System::Transport { .. }, ..) => first_order::<S, _, 3, 1>(&plan, plan.transport()),
        (System::Acoustics { .. }, 1, _) => first_order::<S, _, 1, 2>(&plan, plan.acoustics()),
        (System::Acoustics { .. }, 2, _) => first_order::<S, _, 2, 3>(&plan, plan.acoustics()),
        (System::Acoustics { .. }, ..) => first_order::<S, _, 3, 4>(&plan, plan.acoustics()),
        (System::Telegraph { .. }, ..) => first_order::<S, _, 1, 2>(&plan, plan.telegraph()),
        (System::ShallowWater { .. }, ..) => first_order::<S, _, 2, 3>(&plan, plan.shallow_water()),
        (System::MaxwellTe { .. }, ..) => first_order::<S, _, 2, 3>(&plan, plan.maxwell()),
        (System::ElasticWaves { .. }, ..) => first_order::<S, _, 2, 5>(&plan, plan.elastic_waves()),
        (System::LinearisedGas { .. }, 1, _) => {
            first_order::<S, _, 1, 3>(&plan, plan.linearised_gas())
        }
        (System::LinearisedGas { .. }, 2, _) => {
            first_order::<S, _, 2, 4>(&plan, plan.linearised_gas())
        }
        (System::LinearisedGas { .. }, ..) => {
            first_order::<S, _, 3, 5>(&plan, plan.linearised_gas())
        }
        (System::Matrices { .. }, 1, 2) => first_order::<S, _, 1, 2>(&plan, plan.matrices()),
        (System::Matrices { .. }, 1, 4) => first_order::<S, _, 1, 4>(&plan, plan.matrices()),
        (System::Matrices { .. }, 1, _) => first_order::<S, _, 1, 8>(&plan, plan.matrices()),
        (System::Matrices { .. }, 2, 2) => first_order::<S, _, 2, 2>(&plan, plan.matrices()),
        (System::Matrices { .. }, 2, 4) => first_order::<S, _, 2, 4>(&plan, plan.matrices()),
        (System::Matrices { .. }, 2, _) => first_order::<S, _, 2, 8>(&plan, plan.matrices()),
        (System::Matrices { .. }, _, 2) => first_order::<S, _, 3, 2>(&plan, plan.matrices()),
        (System::Matrices { .. }, _, 4) => first_order::<S, _, 3, 4>(&plan, plan.matrices()),
        (System::Matrices { .. }, ..) => first_order::<S, _, 3, 8>(&plan, plan.matrices()),
        (System::VariableMatrices { .. }, 1, 2) => {
            first_order::<S, _, 1, 2>(&plan, plan.variable_matrices())
        }
        (System::VariableMatrices { .. }, 1, _) => {
            first_order::<S, _, 1, 8>(&plan, plan.variable_matrices())
        }
        (System::VariableMatrices { .. }, 2, 4) => {
            first_order::<S, _, 2, 4>(&plan, plan.variable_matrices())
        }
        (System::VariableMatrices { .. }, 2, _) => {
            first_order::<S, _, 2, 8>(&plan, plan.variable_matrices())
        }
        (System::VariableMatrices { .. }, _, 4) => {
            first_order::<S, _, 3, 4>(&plan, plan.variable_matrices())
        }
        (System::VariableMatrices { .. }, ..) => {
            first_order::<S, _, 3, 8>(&plan, plan.variable_matrices())
        }
        (System::ConvectionDiffusion(of), 1, 1) => Diffusion::<S, 1, 1>::maker(of),
        (System::ConvectionDiffusion(of), 1, _) => Diffusion::<S, 1, 4>::maker(of),
        (System::ConvectionDiffusion(of), 2, 1) => Diffusion::<S, 2, 1>::maker(of),
        (System::ConvectionDiffusion(of), 2, 2) => Diffusion::<S, 2, 2>::maker(of),
        (System::ConvectionDiffusion(of), 2, _) => Diffusion::<S, 2, 4>::maker(of),
        (System::ConvectionDiffusion(of), _, 1) => Diffusion::<S, 3, 1>::maker(of),
        (System::ConvectionDiffusion(of), ..) => Diffusion::<S, 3, 4>::maker(of),
    };
    strengths::start(plan, maker, scalar, engine)
}

impl strengths::Plan {
    /// Components of a row in the memory of a run: those beyond the plan's own stay 0. Of a system that is
    /// given by its matrices, and of several species, runs are compiled for some numbers only.
    pub fn row(&self) -> usize {
        match (&self.system, self.dimension, self.names.len()) {
            (System::VariableMatrices { .. }, 2.., 0..=4) => 4,
            (System::VariableMatrices { .. }, 1, 3..) => 8,
            (System::Matrices { .. } | System::VariableMatrices { .. }, _, 0..=2) => 2,
            (System::Matrices { .. }, _, 3..=4) => 4,
            (System::Matrices { .. } | System::VariableMatrices { .. }, ..) => 8,
            (System::ConvectionDiffusion(_), 2, 2) => 2,
            (System::ConvectionDiffusion(_), _, 2..) => 4,
            (_, _, components) => components,
        }
    }
}

/// Makes the solver of a first-order system, which the table above asks a plan of that system for.
fn first_order<S, F, const D: usize, const P: usize>(
    plan: &strengths::Plan,
    system: Option<F>,
) -> Maker<S>
where
    S: HostScalar,
    F: FirstOrderSystem<S, D, P> + Send + 'static,
    F::Medium: Send,
{
    match system {
        Some(system) => FirstOrder::<S, _, D, P>::maker(Sourced {
            system,
            source: SourceFormulas::of(plan),
        }),
        None => unreachable!("the table asks a plan for its own system"),
    }
}
