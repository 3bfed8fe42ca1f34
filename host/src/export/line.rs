//! A linear system in one dimension as Rust source: its equations, its motion and its cloud.

use std::fmt::Write;

use motes_core::neighbours::cell_bound;

use super::module::Module;
use super::strengths::runge_kutta;
use super::{motion, system};
use crate::families::strengths::{Plan, RunField};
use crate::scenario::linear::System;

/// The source of a module with a `LINE`, its `system`, its `motion` and the capacities it needs; `None` of
/// anything but acoustics and the telegraph line in one dimension without formulas.
pub(super) fn line(mut module: Module, name: &str, plan: &Plan) -> Option<String> {
    let field = plan.motion::<f64, 1>();
    let is_named = matches!(
        plan.system,
        System::Acoustics { .. } | System::Telegraph { .. }
    );
    let is_plain = plan.source.is_none() && matches!(field, RunField::Named(_));
    if !(plan.dimension == 1 && is_named && is_plain) {
        return None;
    }
    let particles = plan.weights.len();
    let module = &mut module;
    module.import("motes_core::domain", ["Side"]);
    module.import("motes_core::equation::linear", ["Line", "Particle"]);
    module.import("motes_core::integrator", ["RungeKutta"]);
    module.cloud(name, particles);
    module.cells(u64::from(cell_bound(particles as u32)) + 1);
    module.cut_off(plan.cut_off);
    let method = runge_kutta(module, plan);
    module.constant("The time integrator.", "METHOD", "RungeKutta", &method);
    let system = system::system::<1, 2>(module, plan)?;
    let doc = "The equations: from the scenario's numbers and units to the solver's.";
    system.function(module, "system", doc);
    let motion = motion::field(module, ("Motion", ""), &field);
    motion.function(module, "motion", "What the particles follow.");
    let mut text = format!(
        "/// The line, in solver units.
#[rustfmt::skip]
pub const LINE: Line<'static, {components}> = Line {{
    half_length: {half:?},
    sides: [Side::{low:?}, Side::{high:?}],
    cloud: &[\n",
        components = plan.names.len(),
        half = plan.axes[0].upper,
        low = plan.axes[0].sides[0],
        high = plan.axes[0].sides[1],
    );
    let values = plan.values.chunks_exact(plan.names.len());
    for (([x, ..], w), u) in plan.positions.iter().zip(&plan.weights).zip(values) {
        let _ = writeln!(
            text,
            "        Particle {{ position: [{x:?}], weight: {w:?}, value: {u:?} }},"
        );
    }
    let _ = writeln!(
        text,
        "    ],
    epsilon: {:?},
    courant: {:?},
    step: {:?},
    end: {:?},
}};",
        plan.epsilon, plan.courant, plan.step, plan.end
    );
    module.item(text);
    Some(module.text())
}
