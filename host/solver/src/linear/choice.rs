//! From a plan to the code that runs it: system, dimension, components and cut-off.

use motes_core::cutoff::{CutOff, Named, QuinticSpline, Smooth};
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

/// Every system.
///
/// # Errors
/// What [`LinearError`] lists.
pub fn in_floats<S: HostScalar>(
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
    call.in_floats::<S>()
}

/// The systems of one dimension that a device may want; others are refused.
///
/// # Errors
/// What [`LinearError`] lists.
pub fn in_fixed_point<S: HostScalar>(
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
    call.in_fixed_point::<S>()
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
    fn in_floats<S: HostScalar>(self) -> Result<Outcome, LinearError> {
        match (&self.plan.system, self.plan.dimension) {
            (System::Transport { .. }, 2) => self.fast::<S, _, 2, 1>(Plan::transport),
            (System::Transport { .. }, 3) => self.with::<S, _, 3, 1>(Plan::transport),
            (System::Acoustics { .. }, 2) => self.fast::<S, _, 2, 3>(Plan::acoustics),
            (System::Acoustics { .. }, 3) => self.with::<S, _, 3, 4>(Plan::acoustics),
            (System::ShallowWater { .. }, _) => self.fast::<S, _, 2, 3>(Plan::shallow_water),
            (System::MaxwellTe { .. }, _) => self.fast::<S, _, 2, 3>(Plan::maxwell),
            (System::ElasticWaves { .. }, _) => self.fast::<S, _, 2, 5>(Plan::elastic_waves),
            (System::LinearisedGas { .. }, 1) => self.with::<S, _, 1, 3>(Plan::linearised_gas),
            (System::LinearisedGas { .. }, 2) => self.fast::<S, _, 2, 4>(Plan::linearised_gas),
            (System::LinearisedGas { .. }, _) => self.with::<S, _, 3, 5>(Plan::linearised_gas),
            (System::Matrices { .. }, 1) => in_components!(self, S, 1),
            (System::Matrices { .. }, 2) => in_components!(self, S, 2),
            (System::Matrices { .. }, _) => in_components!(self, S, 3),
            (System::ConvectionDiffusion(_), 1) if self.plan.names.len() > 1 => {
                self.diffusion::<S, 1, 4>()
            }
            (System::ConvectionDiffusion(_), 2) => match self.plan.names.len() {
                0..=1 => self.fast_diffusion::<S, 2, 1>(),
                2 => self.fast_diffusion::<S, 2, 2>(),
                _ => self.diffusion::<S, 2, 4>(),
            },
            (System::ConvectionDiffusion(_), 3) => match self.plan.names.len() {
                0..=1 => self.fast_diffusion::<S, 3, 1>(),
                _ => self.diffusion::<S, 3, 4>(),
            },
            _ => self.in_fixed_point::<S>(),
        }
    }

    /// The systems for which a fixed-point format is compiled: those of one dimension that a
    /// device may want.
    fn in_fixed_point<S: HostScalar>(self) -> Result<Outcome, LinearError> {
        match (&self.plan.system, self.plan.dimension) {
            (System::Transport { .. }, 1) => self.with::<S, _, 1, 1>(Plan::transport),
            (System::Acoustics { .. }, 1) => self.with::<S, _, 1, 2>(Plan::acoustics),
            (System::Telegraph { .. }, _) => self.with::<S, _, 1, 2>(Plan::telegraph),
            (System::ConvectionDiffusion(of), 1) if of.species.len() == 1 => {
                self.diffusion::<S, 1, 1>()
            }
            _ => Err(self.refused()),
        }
    }

    /// With a cut-off that is looked up for each pair.
    fn with<
        S: HostScalar,
        F: FirstOrderSystem<S, D, P> + 'static,
        const D: usize,
        const P: usize,
    >(
        self,
        system: impl Fn(&Plan) -> Option<F>,
    ) -> Result<Outcome, LinearError> {
        let cut_off = self.plan.cut_off;
        self.with_cut_off::<S, _, F, D, P>(cut_off, system)
    }

    /// With the cut-offs that scenarios use most compiled into the loops: the same bits faster.
    fn fast<
        S: HostScalar,
        F: FirstOrderSystem<S, D, P> + 'static,
        const D: usize,
        const P: usize,
    >(
        self,
        system: impl Fn(&Plan) -> Option<F>,
    ) -> Result<Outcome, LinearError> {
        match self.plan.cut_off {
            Named::QuinticSpline => self.with_cut_off::<S, _, F, D, P>(QuinticSpline, system),
            Named::SmoothFour => self.with_cut_off::<S, _, F, D, P>(Smooth::<7, 4>, system),
            _ => self.with::<S, F, D, P>(system),
        }
    }

    fn with_cut_off<S, C, F, const D: usize, const P: usize>(
        self,
        cut_off: C,
        system: impl Fn(&Plan) -> Option<F>,
    ) -> Result<Outcome, LinearError>
    where
        S: HostScalar,
        C: CutOff,
        F: FirstOrderSystem<S, D, P> + 'static,
    {
        let Some(system) = system(self.plan) else {
            return Err(self.refused());
        };
        let plan = self.plan;
        let solver = FirstOrder {
            dynamics: LinearDynamics::new(
                plan.domain(),
                (cut_off, S::from_f64(plan.epsilon)),
                system,
                plan.motion(),
                S::from_f64(plan.courant),
            ),
            method: plan.runge_kutta(),
        };
        let bytes = LinearArrays::<S, F::Medium, D, P>::bytes_per_particle();
        self.complete(solver, bytes)
    }

    /// Convection-diffusion, with a cut-off that is looked up for each pair.
    fn diffusion<S: HostScalar, const D: usize, const P: usize>(
        self,
    ) -> Result<Outcome, LinearError> {
        let cut_off = self.plan.cut_off;
        self.diffusion_with::<S, _, D, P>(cut_off)
    }

    /// The same with the usual cut-off compiled into the loops.
    fn fast_diffusion<S: HostScalar, const D: usize, const P: usize>(
        self,
    ) -> Result<Outcome, LinearError> {
        match self.plan.cut_off {
            Named::QuinticSpline => self.diffusion_with::<S, _, D, P>(QuinticSpline),
            _ => self.diffusion::<S, D, P>(),
        }
    }

    fn diffusion_with<S: HostScalar, C: CutOff, const D: usize, const P: usize>(
        self,
        cut_off: C,
    ) -> Result<Outcome, LinearError> {
        let plan = self.plan;
        let Some(problem) = plan.convection_diffusion() else {
            return Err(self.refused());
        };
        let media = plan.media(problem);
        let (form, mean) = form(problem);
        let solver = Diffusion {
            dynamics: DiffusionDynamics {
                domain: plan.domain(),
                cut_off,
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

    fn refused(&self) -> LinearError {
        LinearError::NoFixedPoint {
            system: self.plan.system.name(),
            dimension: self.plan.dimension,
            scalar: self.scalar.to_owned(),
        }
    }
}
