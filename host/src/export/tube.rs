//! A tube of gas as Rust source: the first state in solver units, and the exact density to compare
//! with.

use std::fmt::Write;

use motes_core::equation::gas::Width;
use motes_core::neighbours::cell_bound;

use super::module::Module;
use super::viscosity::viscosity;
use crate::families::gas::{ExactSolution, Plan};
use crate::scenario::{Extent, Scenario};

/// Points of the exact profile between two of its jumps.
const POINTS: u32 = 60;

/// The source of a module with a `TUBE`, the capacities it needs, and its exact density; `None` where
/// the scenario is no tube of one ideal gas: see [`Plan::tube`].
pub(super) fn tube(
    mut module: Module,
    scenario: &Scenario,
    plan: &Plan,
    exact: Option<&ExactSolution>,
) -> Option<String> {
    let tube = plan.tube()?;
    let particles = plan.particles.len();
    let width = match plan.width {
        Width::Adaptive { eta, .. } => format!("adaptive({eta:?})"),
        Width::Constant { epsilon } => format!("Constant {{ epsilon: {epsilon:?} }}"),
    };
    module.import("motes_core::domain", ["Side"]);
    module.import("motes_core::equation::gas", ["Stretch", "Tube", "Width"]);
    module.cloud(&scenario.name, particles);
    module.cells(u64::from(cell_bound(particles as u32)) + 1);
    module.cut_off(plan.cut_off);
    viscosity(&mut module, &plan.viscosity);
    let mut text = format!(
        "/// The tube, in solver units.
pub const TUBE: Tube<'static> = Tube {{
    half_length: {half:?},
    sides: [Side::{low:?}, Side::{high:?}],
    stretches: &[\n",
        half = tube.half_length,
        low = tube.sides[0],
        high = tube.sides[1],
    );
    for s in tube.stretches {
        let _ = write!(
            text,
            "        Stretch {{
            lower: {:?},
            upper: {:?},
            particles: {},
            mass: {:?},
            velocity: {:?},
            energy: {:?},
        }},\n",
            s.lower, s.upper, s.particles, s.mass, s.velocity, s.energy
        );
    }
    let _ = writeln!(
        text,
        "    ],
    gamma: {:?},
    width: Width::{width},
    courant: {:?},
    end: {:?},
}};",
        tube.gamma, tube.courant, tube.end
    );
    profile(&mut text, scenario, plan, exact);
    module.item(text);
    Some(module.text())
}

/// The exact density at the end, between whose points it is a straight line; a jump is two
/// points at one place.
fn profile(text: &mut String, scenario: &Scenario, plan: &Plan, exact: Option<&ExactSolution>) {
    let window = &scenario.output.window;
    let time = scenario.time.end;
    let solver = |x: f64| (x - plan.middle[0]) / plan.units.length;
    let mut points = Vec::new();
    for edge in smooth_parts(window, time, exact).windows(2) {
        let length = edge[1] - edge[0];
        for i in 0..=POINTS {
            // Just inside the edges: on them the solution may have either of its values.
            let part = (f64::from(i) / f64::from(POINTS)).clamp(1e-9, 1.0 - 1e-9);
            let x = edge[0] + length * part;
            let density = exact.map_or(0.0, |exact| exact.state([x, 0.0, 0.0], time).density);
            points.push((solver(x), density / plan.units.density()));
        }
    }
    let _ = writeln!(
        text,
        "
/// The window in which errors are measured.
pub const WINDOW: [f64; 2] = [{:?}, {:?}];

/// The exact density at the end: position, density, joined by straight lines; empty without
/// an exact solution.
pub const EXACT_DENSITY: [(f64, f64); {}] = [",
        solver(window.lower[0]),
        solver(window.upper[0]),
        points.len()
    );
    for (x, density) in points {
        let _ = writeln!(text, "    ({x:?}, {density:?}),");
    }
    let _ = writeln!(text, "];");
}

/// The ends of the window and the places in it where the solution is not smooth; nothing
/// without a solution.
fn smooth_parts(window: &Extent, time: f64, exact: Option<&ExactSolution>) -> Vec<f64> {
    let Some(exact) = exact else {
        return Vec::new();
    };
    let ends = [window.lower[0], window.upper[0]];
    let inside = |x: &f64| ends[0] < *x && *x < ends[1];
    let mut parts: Vec<f64> = exact
        .edges(time)
        .into_iter()
        .filter(inside)
        .chain(ends)
        .collect();
    parts.sort_by(f64::total_cmp);
    parts
}
