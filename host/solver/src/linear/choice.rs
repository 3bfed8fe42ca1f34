//! From a plan to the code that runs it: system, dimension, components.

use motes_core::equation::diffusion::DiffusionDynamics;
use motes_core::equation::linear::{FirstOrderSystem, LinearDynamics};

use super::arrays::{DiffusionArrays, LinearArrays};
use super::diffusion::{Diffusion, Stepping, form};
use super::limits::LinearError;
use super::outcome::Outcome;
use super::plan::Plan;
use super::run::{Control, run_with};
use super::solver::{FirstOrder, Solver};
use crate::engine::{HostScalar, Threads};
use crate::scenario::linear::{Method, System};

/// A run with everything but its types chosen.
struct Call<'a, 'c, 'd> {
    plan: &'a Plan,
    scalar: &'a str,
    engine: &'a mut Threads,
    control: &'c mut Control<'d>,
}

/// Runs a plan with its system in its dimension.
///
/// # Errors
/// What [`LinearError`] lists.
pub fn in_dimensions<S: HostScalar>(
    plan: &Plan,
    scalar: &str,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, LinearError> {
    let call = Call {
        plan,
        scalar,
        engine,
        control,
    };
    call.run::<S>()
}

/// How many components a system given by its matrices is compiled for: the least that hold them.
macro_rules! in_components {
    ($call:expr, $scalar:ty, $d:literal) => {
        match $call.plan.names.len() {
            0..=2 => $call.with::<$scalar, _, $d, 2>(|plan| plan.matrices()),
            3..=4 => $call.with::<$scalar, _, $d, 4>(|plan| plan.matrices()),
            _ => $call.with::<$scalar, _, $d, 8>(|plan| plan.matrices()),
        }
    };
}

impl Call<'_, '_, '_> {
    fn run<S: HostScalar>(self) -> Result<Outcome, LinearError> {
        let components = self.plan.names.len();
        match (&self.plan.system, self.plan.dimension) {
            (System::Transport { .. }, 1) => self.with::<S, _, 1, 1>(Plan::transport),
            (System::Transport { .. }, 2) => self.with::<S, _, 2, 1>(Plan::transport),
            (System::Transport { .. }, _) => self.with::<S, _, 3, 1>(Plan::transport),
            (System::Acoustics { .. }, 1) => self.with::<S, _, 1, 2>(Plan::acoustics),
            (System::Acoustics { .. }, 2) => self.with::<S, _, 2, 3>(Plan::acoustics),
            (System::Acoustics { .. }, _) => self.with::<S, _, 3, 4>(Plan::acoustics),
            (System::Telegraph { .. }, _) => self.with::<S, _, 1, 2>(Plan::telegraph),
            (System::ShallowWater { .. }, _) => self.with::<S, _, 2, 3>(Plan::shallow_water),
            (System::MaxwellTe { .. }, _) => self.with::<S, _, 2, 3>(Plan::maxwell),
            (System::ElasticWaves { .. }, _) => self.with::<S, _, 2, 5>(Plan::elastic_waves),
            (System::LinearisedGas { .. }, 1) => self.with::<S, _, 1, 3>(Plan::linearised_gas),
            (System::LinearisedGas { .. }, 2) => self.with::<S, _, 2, 4>(Plan::linearised_gas),
            (System::LinearisedGas { .. }, _) => self.with::<S, _, 3, 5>(Plan::linearised_gas),
            (System::Matrices { .. }, 1) => in_components!(self, S, 1),
            (System::Matrices { .. }, 2) => in_components!(self, S, 2),
            (System::Matrices { .. }, _) => in_components!(self, S, 3),
            (System::ConvectionDiffusion(_), dimension) => match (dimension, components) {
                (1, 1) => self.diffusion::<S, 1, 1>(),
                (1, _) => self.diffusion::<S, 1, 4>(),
                (2, 1) => self.diffusion::<S, 2, 1>(),
                (2, 2) => self.diffusion::<S, 2, 2>(),
                (2, _) => self.diffusion::<S, 2, 4>(),
                (_, 1) => self.diffusion::<S, 3, 1>(),
                _ => self.diffusion::<S, 3, 4>(),
            },
        }
    }

    /// A first-order system.
    fn with<S, F, const D: usize, const P: usize>(
        self,
        system: impl Fn(&Plan) -> Option<F>,
    ) -> Result<Outcome, LinearError>
    where
        S: HostScalar,
        F: FirstOrderSystem<S, D, P> + 'static,
    {
        let plan = self.plan;
        let Some(system) = system(plan) else {
            unreachable!("the table above asks a plan for its own system");
        };
        let solver = FirstOrder {
            dynamics: LinearDynamics::new(
                plan.domain(),
                (plan.cut_off, S::from_f64(plan.epsilon)),
                system,
                plan.motion(),
                S::from_f64(plan.courant),
            ),
            method: plan.runge_kutta(),
        };
        let bytes = LinearArrays::<S, F::Medium, D, P>::bytes_per_particle();
        self.complete(solver, bytes)
    }

    /// Convection-diffusion.
    fn diffusion<S: HostScalar, const D: usize, const P: usize>(
        self,
    ) -> Result<Outcome, LinearError> {
        let plan = self.plan;
        let Some(problem) = plan.convection_diffusion() else {
            unreachable!("the table above asks a plan for its own system");
        };
        let media = plan.media(problem);
        let (form, mean) = form(problem);
        let solver = Diffusion {
            dynamics: DiffusionDynamics {
                domain: plan.domain(),
                cut_off: plan.cut_off,
                epsilon: S::from_f64(plan.epsilon),
                problem: plan.problem::<S, D, P>(problem, &media),
                field: plan.motion::<S, D>(),
                form,
                mean,
                courant: S::from_f64(plan.courant),
            },
            stepping: match plan.method {
                Method::Rkl2 => Stepping::Stabilised(plan.stages),
                Method::Rk4 | Method::SspRk3 => Stepping::RungeKutta(plan.runge_kutta()),
            },
            longest: S::from_f64(plan.longest_step()),
        };
        let bytes = DiffusionArrays::<S, D, P>::bytes_per_particle();
        self.complete(solver, bytes)
    }

    /// Runs a solver that takes so many bytes a particle.
    fn complete<S: HostScalar, V: Solver<S, D, P>, const D: usize, const P: usize>(
        self,
        solver: V,
        bytes: usize,
    ) -> Result<Outcome, LinearError> {
        run_with(
            self.plan,
            self.scalar,
            (solver, bytes),
            self.engine,
            self.control,
        )
    }
}
