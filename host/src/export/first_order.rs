//! Any first-order system as Rust source, in one to three dimensions.

use motes_core::neighbours::cell_bound;

use super::module::{Module, number};
use super::run::{Start, domain};
use super::strengths::{cloud, runge_kutta};
use super::{motion, system};
use crate::families::strengths::Plan;

/// The source of a module that runs a first-order system.
pub(super) fn first_order(mut module: Module, name: &str, plan: &Plan) -> Option<String> {
    let module = &mut module;
    match (plan.dimension, plan.row()) {
        (1, 1) => of::<1, 1>(module, name, plan),
        (1, 2) => of::<1, 2>(module, name, plan),
        (1, 3) => of::<1, 3>(module, name, plan),
        (1, 4) => of::<1, 4>(module, name, plan),
        (1, _) => of::<1, 8>(module, name, plan),
        (2, 1) => of::<2, 1>(module, name, plan),
        (2, 2) => of::<2, 2>(module, name, plan),
        (2, 3) => of::<2, 3>(module, name, plan),
        (2, 4) => of::<2, 4>(module, name, plan),
        (2, 5) => of::<2, 5>(module, name, plan),
        (2, _) => of::<2, 8>(module, name, plan),
        (_, 1) => of::<3, 1>(module, name, plan),
        (_, 2) => of::<3, 2>(module, name, plan),
        (_, 4) => of::<3, 4>(module, name, plan),
        (_, 5) => of::<3, 5>(module, name, plan),
        (..) => of::<3, 8>(module, name, plan),
    }
}

/// The same in that dimension, with rows of so many components.
fn of<const D: usize, const P: usize>(
    module: &mut Module,
    name: &str,
    plan: &Plan,
) -> Option<String> {
    let particles = plan.weights.len();
    module.import(
        "motes_core::equation::linear",
        ["FirstOrderSystem", "LinearDynamics"],
    );
    module.import("motes_core::equation::linear", ["LinearStorage"]);
    module.cloud(name, particles);
    module.cells(u64::from(cell_bound(particles as u32)) + 1);
    module.cut_off(plan.cut_off);
    let system = system::system::<D, P>(module, plan)?;
    system.function(module, "system", "The equations.");
    let doc = ("Motion", "What the particles follow");
    let motion = motion::field::<D>(module, doc, &plan.motion());
    let follow = motion.made(module, "motion", "What the particles follow.");
    domain(module, &plan.axes[..D]);
    cloud(module, plan);
    let (system, motion) = (system.of_type(), motion.of_type());
    let (epsilon, courant) = (number(plan.epsilon), number(plan.courant));
    let start = Start {
        dimension: D,
        dynamics: format!("LinearDynamics<S, CutOff, {system}, {motion}, {D}, {P}>"),
        call: format!(
            "    let width = (CUT_OFF, {epsilon});
    let dynamics = LinearDynamics::new(domain(), width, system(), {follow}, {courant});\n"
        ),
        method: runge_kutta(module, plan),
        storage: format!(
            "LinearStorage<
    S,
    <{system} as FirstOrderSystem<S, {D}, {P}>>::Medium,
    {D},
    {P},
    PARTICLES,
    CELLS,
>"
        ),
        lists: None,
        step: plan.step,
        end: plan.end,
    };
    start.write(module);
    Some(module.text())
}
