//! The table of everything that can be run: family, system, dimension and components, in a scalar.

use std::sync::Arc;

use motes_core::equation::linear::FirstOrderSystem;

use super::diffusion::Diffusion;
use super::linear::FirstOrder;
use super::strengths::Plan as Cloud;
use super::{Plan, gas, strengths};
use crate::engine::{HostScalar, Threads};
use crate::run::{RunError, Simulation};
use crate::scenario::linear::{ConvectionDiffusion, System};

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
    let (dimension, components) = (plan.dimension, plan.names.len());
    let call = Call {
        plan,
        scalar,
        engine,
    };
    match (call.plan.system.clone(), dimension, components) {
        (System::Transport { .. }, 1, _) => call.system::<S, _, 1, 1>(Cloud::transport),
        (System::Transport { .. }, 2, _) => call.system::<S, _, 2, 1>(Cloud::transport),
        (System::Transport { .. }, ..) => call.system::<S, _, 3, 1>(Cloud::transport),
        (System::Acoustics { .. }, 1, _) => call.system::<S, _, 1, 2>(Cloud::acoustics),
        (System::Acoustics { .. }, 2, _) => call.system::<S, _, 2, 3>(Cloud::acoustics),
        (System::Acoustics { .. }, ..) => call.system::<S, _, 3, 4>(Cloud::acoustics),
        (System::Telegraph { .. }, ..) => call.system::<S, _, 1, 2>(Cloud::telegraph),
        (System::ShallowWater { .. }, ..) => call.system::<S, _, 2, 3>(Cloud::shallow_water),
        (System::MaxwellTe { .. }, ..) => call.system::<S, _, 2, 3>(Cloud::maxwell),
        (System::ElasticWaves { .. }, ..) => call.system::<S, _, 2, 5>(Cloud::elastic_waves),
        (System::LinearisedGas { .. }, 1, _) => call.system::<S, _, 1, 3>(Cloud::linearised_gas),
        (System::LinearisedGas { .. }, 2, _) => call.system::<S, _, 2, 4>(Cloud::linearised_gas),
        (System::LinearisedGas { .. }, ..) => call.system::<S, _, 3, 5>(Cloud::linearised_gas),
        // Of a system given by its matrices: the least that hold its components.
        (System::Matrices { .. }, 1, 0..=2) => call.system::<S, _, 1, 2>(Cloud::matrices),
        (System::Matrices { .. }, 1, 3..=4) => call.system::<S, _, 1, 4>(Cloud::matrices),
        (System::Matrices { .. }, 1, _) => call.system::<S, _, 1, 8>(Cloud::matrices),
        (System::Matrices { .. }, 2, 0..=2) => call.system::<S, _, 2, 2>(Cloud::matrices),
        (System::Matrices { .. }, 2, 3..=4) => call.system::<S, _, 2, 4>(Cloud::matrices),
        (System::Matrices { .. }, 2, _) => call.system::<S, _, 2, 8>(Cloud::matrices),
        (System::Matrices { .. }, _, 0..=2) => call.system::<S, _, 3, 2>(Cloud::matrices),
        (System::Matrices { .. }, _, 3..=4) => call.system::<S, _, 3, 4>(Cloud::matrices),
        (System::Matrices { .. }, ..) => call.system::<S, _, 3, 8>(Cloud::matrices),
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
    plan: Cloud,
    scalar: &'a str,
    engine: &'a mut Threads,
}

impl Call<'_> {
    /// A first-order system.
    fn system<S, F, const D: usize, const P: usize>(
        self,
        system: impl Fn(&Cloud) -> Option<F>,
    ) -> Result<Box<dyn Simulation>, RunError>
    where
        S: HostScalar,
        F: FirstOrderSystem<S, D, P> + Send + 'static,
        F::Medium: Send,
    {
        let Some(system) = system(&self.plan) else {
            unreachable!("the table above asks a plan for its own system");
        };
        let solver = |plan: &Arc<Cloud>| FirstOrder::new(plan, system);
        strengths::start::<S, FirstOrder<S, F, D, P>, D, P>(
            self.plan,
            solver,
            self.scalar,
            self.engine,
        )
    }

    /// Convection-diffusion.
    fn diffusion<S: HostScalar, const D: usize, const P: usize>(
        self,
        of: &ConvectionDiffusion,
    ) -> Result<Box<dyn Simulation>, RunError> {
        let solver = |plan: &Arc<Cloud>| Diffusion::new(plan, of);
        strengths::start::<S, Diffusion<S>, D, P>(self.plan, solver, self.scalar, self.engine)
    }
}
