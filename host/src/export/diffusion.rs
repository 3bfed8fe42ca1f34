//! Any convection-diffusion problem as Rust source, in one to three dimensions.

use motes_core::equation::diffusion::Form;
use motes_core::neighbours::cell_bound;

use super::laws::{is_written, written};
use super::module::{Module, number};
use super::motion;
use super::problem::{numbers, room};
use super::run::{Start, domain};
use super::strengths::{cloud, runge_kutta};
use crate::families::diffusion::form;
use crate::families::strengths::Plan;
use crate::scenario::linear::{ConvectionDiffusion, Method};

/// The source of a module that runs a convection-diffusion problem.
pub(super) fn diffusion(
    mut module: Module,
    name: &str,
    (plan, problem): (&Plan, &ConvectionDiffusion),
) -> String {
    let module = &mut module;
    match (plan.dimension, plan.row()) {
        (1, 1) => of::<1, 1>(module, name, (plan, problem)),
        (1, _) => of::<1, 4>(module, name, (plan, problem)),
        (2, 1) => of::<2, 1>(module, name, (plan, problem)),
        (2, 2) => of::<2, 2>(module, name, (plan, problem)),
        (2, _) => of::<2, 4>(module, name, (plan, problem)),
        (_, 1) => of::<3, 1>(module, name, (plan, problem)),
        (..) => of::<3, 4>(module, name, (plan, problem)),
    }
}

/// The same in that dimension, with rows of so many species.
fn of<const D: usize, const P: usize>(
    module: &mut Module,
    name: &str,
    (plan, problem): (&Plan, &ConvectionDiffusion),
) -> String {
    let particles = plan.weights.len();
    let (form, mean) = form(problem);
    let is_direct = form == Form::Direct && plan.method == Method::Rkl2;
    let storage = match is_direct {
        true => "DirectStorage",
        false => "DiffusionStorage",
    };
    module.import(
        "motes_core::equation::diffusion",
        ["DiffusionDynamics", "Form", "Lists", "Mean"],
    );
    module.import("motes_core::equation::diffusion", [storage]);
    module.import("motes_core::integrator", ["DiffusionMethod", "Scheme"]);
    module.cloud(name, particles);
    module.cells(u64::from(cell_bound(particles as u32)) + 1);
    let media = plan.media::<f64>(problem);
    let named = plan.named_problem::<f64, D, P>(problem, &media);
    room(module, &named, "all");
    module.cut_off(plan.cut_off);
    let fields = numbers(module, &named, 4);
    module.item(format!(
        "/// Diffusivities, reaction and walls, in solver units.
#[rustfmt::skip]
pub const PROBLEM: NamedProblem<'static, f64, {D}, {P}> = NamedProblem {{
{fields}}};\n"
    ));
    let (of_type, made) = match is_written(&media.formulas) {
        true => {
            written::<D, P>(module, plan, &media.formulas);
            (
                "Problem<'m, S>".to_owned(),
                "Problem {\n            named: PROBLEM.rounded(lists)?,\n        }",
            )
        }
        false => (
            format!("NamedProblem<'m, S, {D}, {P}>"),
            "PROBLEM.rounded(lists)?",
        ),
    };
    let doc = ("Motion", "What the particles follow");
    let motion = motion::field::<D>(module, doc, &plan.motion());
    let follow = motion.made(module, "motion", "What the particles follow.");
    domain(module, &plan.axes[..D]);
    cloud(module, plan);
    let scheme = match plan.method {
        Method::Rkl2 => format!("Stabilised({})", plan.stages),
        Method::Rk4 | Method::SspRk3 => format!("RungeKutta({})", runge_kutta(module, plan)),
    };
    let start = Start {
        dimension: D,
        dynamics: format!(
            "DiffusionDynamics<S, CutOff, {of_type}, {}, {D}, {P}>",
            motion.of_type()
        ),
        call: format!(
            "    let dynamics = DiffusionDynamics {{
        domain: domain(),
        cut_off: CUT_OFF,
        epsilon: {},
        problem: {made},
        field: {follow},
        form: Form::{form:?},
        mean: Mean::{mean:?},
        courant: {},
    }};\n",
            number(plan.epsilon),
            number(plan.courant)
        ),
        method: format!(
            "DiffusionMethod {{
        scheme: Scheme::{scheme},
        longest: {},
    }}",
            number(plan.longest_step())
        ),
        storage: format!("{storage}<S, {D}, {P}, PARTICLES, CELLS>"),
        lists: Some(("Lists<S, POINTS, LAYERS>".to_owned(), "Lists::new()")),
        step: plan.step,
        end: plan.end,
    };
    start.write(module);
    module.text()
}
