//! What linear systems and convection-diffusion share: their particles, their method.

use std::fmt::Write;

use super::module::{Module, literal};
use crate::families::strengths::Plan;

/// The particles at the start: a static `CLOUD`. Components beyond those of the plan are 0.
pub(super) fn cloud(module: &mut Module, plan: &Plan) {
    module.import("motes_core::equation::linear", ["Particle"]);
    let (dimension, row) = (plan.dimension, plan.row());
    let mut text = format!(
        "/// The particles at the start, in solver units.
#[rustfmt::skip]
pub static CLOUD: [Particle<f64, {dimension}, {row}>; PARTICLES] = [\n"
    );
    let values = plan.values.chunks_exact(plan.names.len());
    for ((x, &w), u) in plan.positions.iter().zip(&plan.weights).zip(values) {
        let mut u = u.to_vec();
        u.resize(row, 0.0);
        let (x, w) = (&x[..dimension], literal(w));
        let _ = writeln!(
            text,
            "    Particle {{ position: {x:?}, weight: {w}, value: {u:?} }},"
        );
    }
    module.item(text + "];\n");
}

/// The name of its Runge-Kutta method in the core, imported.
pub(super) fn runge_kutta(module: &mut Module, plan: &Plan) -> String {
    let name = plan.method.name().to_uppercase().replace('-', "_");
    module.import("motes_core::integrator", [name.as_str()]);
    name
}
