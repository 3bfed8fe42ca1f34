//! From the name of a scalar to the code that runs with it.

use fixed::types::extra::{U12, U16, U18, U19, U20, U22, U32, U40, U48};
use motes_core::cutoff::{CubicSpline, Named as NamedCutOff};
use motes_core::equation::gas::viscosity::{
    Coefficients, GingoldMonaghan, Named as NamedViscosity, Pairwise, VonNeumann,
};
use motes_core::scalar::{Checked, Micro, Q32, Q64};

use super::outcome::Outcome;
use super::plan::Plan;
use super::run::{Control, RunError, run_with};
use crate::engine::{HostScalar, Threads};
use crate::scenario::ViscosityKind;

macro_rules! scalars {
    ($($variant:ident, $name:literal, $what:literal, $type:ty;)*) => {
        /// A scalar that runs can be made with.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum ScalarName {
            $(#[doc = $what] $variant,)*
        }

        impl ScalarName {
            /// All of them, with what they are.
            pub const ALL: &'static [(Self, &'static str, &'static str)] =
                &[$((Self::$variant, $name, $what),)*];

            /// Runs `plan` with this scalar; `checked` marks overflow and stops at the first.
            fn run(
                self,
                plan: &Plan,
                checked: bool,
                engine: &mut Threads,
                control: &mut Control<'_>,
            ) -> Result<Outcome, RunError> {
                match self {
                    $(Self::$variant if checked => {
                        run_named::<Checked<$type>>(plan, $name, engine, control)
                    })*
                    $(Self::$variant => run_as::<$type>(plan, $name, engine, control),)*
                }
            }
        }
    };
}
scalars! {
    F64, "f64", "IEEE double precision", f64;
    F32, "f32", "IEEE single precision", f32;
    Micromath, "micromath", "f32 with approximate square roots", Micro;
    Q9p22, "q9.22", "32-bit fixed point, 22 fractional bits", Q32<U22>;
    Q11p20, "q11.20", "32-bit fixed point, 20 fractional bits", Q32<U20>;
    Q12p19, "q12.19", "32-bit fixed point, 19 fractional bits", Q32<U19>;
    Q13p18, "q13.18", "32-bit fixed point, 18 fractional bits", Q32<U18>;
    Q15p16, "q15.16", "32-bit fixed point, 16 fractional bits", Q32<U16>;
    Q19p12, "q19.12", "32-bit fixed point, 12 fractional bits", Q32<U12>;
    Q15p48, "q15.48", "64-bit fixed point, 48 fractional bits", Q64<U48>;
    Q23p40, "q23.40", "64-bit fixed point, 40 fractional bits", Q64<U40>;
    Q31p32, "q31.32", "64-bit fixed point, 32 fractional bits", Q64<U32>;
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
    scalar.run(plan, checked, engine, control)
}

/// The default cut-off and viscosity are compiled together, the others are looked up for
/// each pair: the same bits, slower.
fn run_as<S: HostScalar>(
    plan: &Plan,
    name: &str,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    match (plan.cut_off, viscosity::<S>(plan)) {
        (NamedCutOff::CubicSpline, NamedViscosity::Pairwise(viscosity)) => {
            run_with(plan, name, CubicSpline, viscosity, engine, control)
        }
        _ => run_named::<S>(plan, name, engine, control),
    }
}

fn run_named<S: HostScalar>(
    plan: &Plan,
    name: &str,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    run_with(
        plan,
        name,
        plan.cut_off,
        viscosity::<S>(plan),
        engine,
        control,
    )
}

fn viscosity<S: HostScalar>(plan: &Plan) -> NamedViscosity<S> {
    let coefficients = Coefficients {
        alpha: S::from_f64(plan.viscosity.alpha),
        beta: S::from_f64(plan.viscosity.beta),
    };
    match plan.viscosity.kind {
        ViscosityKind::Pairwise => NamedViscosity::Pairwise(Pairwise(coefficients)),
        ViscosityKind::GingoldMonaghan => {
            NamedViscosity::GingoldMonaghan(GingoldMonaghan(coefficients))
        }
        ViscosityKind::VonNeumann => NamedViscosity::VonNeumann(VonNeumann(coefficients)),
        // `Plan::new` refuses `Limited`.
        ViscosityKind::None | ViscosityKind::Limited => NamedViscosity::Inviscid,
    }
}
