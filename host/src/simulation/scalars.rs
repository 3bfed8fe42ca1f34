//! From the name of a scalar to the code that runs with it.
//!
//! Every scalar is compiled in every dimension, which takes most of the time of a build; unit
//! tests do without those that none of them runs.

#[cfg(all(feature = "every-scalar", not(test)))]
use fixed::types::extra::{U12, U16, U18, U19, U20, U22, U32, U40, U48};
use motes_core::cutoff::{
    CubicSpline, CutOff, Named as NamedCutOff, QuinticSpline, WendlandC2, WendlandC6,
};
#[cfg(all(feature = "every-scalar", not(test)))]
use motes_core::scalar::{Checked, Micro, Q32, Q64};

use super::limits::RunError;
use super::outcome::Outcome;
use super::plan::Plan;
use super::run::{Control, run_with};
use crate::engine::{HostScalar, Threads};

macro_rules! scalars {
    ($($(#[$only:meta])? $variant:ident, $name:literal, $what:literal, $run:expr;)*) => {
        /// A scalar that runs can be made with.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum ScalarName {
            $($(#[$only])? #[doc = $what] $variant,)*
        }

        impl ScalarName {
            /// All of them, with what they are.
            pub const ALL: &'static [(Self, &'static str, &'static str)] =
                &[$($(#[$only])? (Self::$variant, $name, $what),)*];

            /// How runs are made with it.
            fn runner(self) -> Runner {
                match self {
                    $($(#[$only])? Self::$variant => $run,)*
                }
            }
        }
    };
}

/// Runs a plan with one scalar; `true` marks overflow and stops at the first.
type Runner = fn(&Plan, &str, bool, &mut Threads, &mut Control<'_>) -> Result<Outcome, RunError>;

scalars! {
    F64, "f64", "IEEE double precision", in_floats::<f64>;
    F32, "f32", "IEEE single precision", in_floats::<f32>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Micromath, "micromath", "f32 with approximate square roots", in_dimensions::<Micro>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Q9p22, "q9.22", "32-bit fixed point, 22 fractional bits", in_fixed_point::<Q32<U22>>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Q11p20, "q11.20", "32-bit fixed point, 20 fractional bits", in_fixed_point::<Q32<U20>>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Q12p19, "q12.19", "32-bit fixed point, 19 fractional bits", in_fixed_point::<Q32<U19>>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Q13p18, "q13.18", "32-bit fixed point, 18 fractional bits", in_fixed_point::<Q32<U18>>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Q15p16, "q15.16", "32-bit fixed point, 16 fractional bits", in_fixed_point::<Q32<U16>>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Q19p12, "q19.12", "32-bit fixed point, 12 fractional bits", in_fixed_point::<Q32<U12>>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Q15p48, "q15.48", "64-bit fixed point, 48 fractional bits", in_fixed_point::<Q64<U48>>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Q23p40, "q23.40", "64-bit fixed point, 40 fractional bits", in_fixed_point::<Q64<U40>>;
    #[cfg(all(feature = "every-scalar", not(test)))]
    Q31p32, "q31.32", "64-bit fixed point, 32 fractional bits", in_fixed_point::<Q64<U32>>;
}

/// A name that no scalar has.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error("unknown scalar `{name}`")]
#[diagnostic(help("this build has {}", ScalarName::list()))]
pub struct UnknownScalar {
    /// The name.
    pub name: String,
}

impl ScalarName {
    /// The names, separated by commas.
    pub fn list() -> String {
        let names: Vec<_> = Self::ALL.iter().map(|(_, name, _)| *name).collect();
        names.join(", ")
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        let row = Self::ALL.iter().find(|(scalar, ..)| *scalar == self);
        row.map_or("", |(_, name, _)| name)
    }
}

impl std::str::FromStr for ScalarName {
    type Err = UnknownScalar;

    fn from_str(name: &str) -> Result<Self, UnknownScalar> {
        let row = Self::ALL.iter().find(|(_, known, _)| *known == name);
        row.map(|(scalar, ..)| *scalar)
            .ok_or_else(|| UnknownScalar {
                name: name.to_owned(),
            })
    }
}

/// Runs `plan` to its end.
///
/// # Errors
/// What [`RunError`] lists.
pub fn run(
    plan: &Plan,
    scalar: ScalarName,
    checked: bool,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    (scalar.runner())(plan, scalar.name(), checked, engine, control)
}

/// The cut-offs that scenarios of each dimension use most are compiled into the loops, others
/// are looked up for each pair: the same bits at less than half the speed.
fn in_floats<S: HostScalar>(
    plan: &Plan,
    name: &str,
    checked: bool,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    // Unit tests are built in half the time without, and have the same bits.
    if cfg!(test) {
        return in_dimensions::<S>(plan, name, checked, engine, control);
    }
    match (plan.dimension, plan.cut_off) {
        (1, NamedCutOff::CubicSpline) => with::<S, _, 1>(CubicSpline, plan, name, engine, control),
        (1, NamedCutOff::QuinticSpline) => {
            with::<S, _, 1>(QuinticSpline, plan, name, engine, control)
        }
        (2, NamedCutOff::WendlandC2) => with::<S, _, 2>(WendlandC2, plan, name, engine, control),
        (2, NamedCutOff::WendlandC6) => with::<S, _, 2>(WendlandC6, plan, name, engine, control),
        (3, NamedCutOff::WendlandC2) => with::<S, _, 3>(WendlandC2, plan, name, engine, control),
        (3, NamedCutOff::QuinticSpline) => {
            with::<S, _, 3>(QuinticSpline, plan, name, engine, control)
        }
        _ => in_dimensions::<S>(plan, name, checked, engine, control),
    }
}

#[cfg(all(feature = "every-scalar", not(test)))]
fn in_fixed_point<S>(
    plan: &Plan,
    name: &str,
    checked: bool,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError>
where
    S: HostScalar,
    Checked<S>: HostScalar,
{
    if checked {
        in_dimensions::<Checked<S>>(plan, name, checked, engine, control)
    } else {
        in_dimensions::<S>(plan, name, checked, engine, control)
    }
}

fn in_dimensions<S: HostScalar>(
    plan: &Plan,
    name: &str,
    _: bool,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    match plan.dimension {
        1 => with::<S, _, 1>(plan.cut_off, plan, name, engine, control),
        2 => with::<S, _, 2>(plan.cut_off, plan, name, engine, control),
        _ => with::<S, _, 3>(plan.cut_off, plan, name, engine, control),
    }
}

fn with<S: HostScalar, C: CutOff, const D: usize>(
    cut_off: C,
    plan: &Plan,
    name: &str,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    let (viscosity, options) = (plan.viscosity::<S>(), plan.options::<S, D>());
    if options.need_exchange() {
        run_with(plan, name, (cut_off, viscosity, options), engine, control)
    } else {
        let law = (cut_off, viscosity, options.plain);
        run_with(plan, name, law, engine, control)
    }
}
