//! A scenario as Rust source for a device: the first state in solver units, and the exact
//! density to compare with.

use std::fmt::Write;

use motes_core::equation::gas::Width;

use crate::comparison::ExactSolution;
use crate::scenario::Scenario;
use crate::simulation::Plan;

/// Points of the exact profile between two of its jumps.
const POINTS: u32 = 60;

/// The source of a module with a `TUBE`, the capacities it needs, and its exact density.
///
/// Numbers are written with the digits that read back to the same bits.
pub fn tube(scenario: &Scenario, plan: &Plan, exact: Option<&ExactSolution>) -> String {
    let particles = plan.particles();
    let (width, value) = match plan.width {
        Width::Adaptive { eta } => ("Adaptive { eta", eta),
        Width::Constant { epsilon } => ("Constant { epsilon", epsilon),
    };
    let mut text = format!(
        "//! Made by `motes export {name} -n {particles}`: {description}. Not edited by hand.

use motes_core::domain::Side;
use motes_core::equation::gas::{{Stretch, Tube, Width}};

/// The name of the scenario.
pub const NAME: &str = {name:?};

/// Number of particles.
pub const PARTICLES: usize = {particles};

/// Cells they can take, and one.
pub const CELLS: usize = {cells};

/// Linear and quadratic coefficient of the pseudo-viscosity.
pub const VISCOSITY: [f64; 2] = [{alpha:?}, {beta:?}];

/// The tube, in solver units.
pub const TUBE: Tube<'static> = Tube {{
    half_length: {half:?},
    sides: [Side::{low:?}, Side::{high:?}],
    stretches: &[\n",
        name = scenario.name,
        description = scenario.description,
        cells = motes_core::neighbours::cell_bound(particles as u32) + 1,
        alpha = plan.viscosity.alpha,
        beta = plan.viscosity.beta,
        half = plan.half_length,
        low = plan.sides[0],
        high = plan.sides[1],
    );
    for s in &plan.stretches {
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
    width: Width::{width}: {value:?} }},
    courant: {:?},
    end: {:?},
}};",
        plan.gamma, plan.courant, plan.end
    );
    if let Some(exact) = exact {
        profile(&mut text, scenario, plan, exact);
    }
    text
}

/// The exact density at the end, between whose points it is a straight line; a jump is two
/// points at one place.
fn profile(text: &mut String, scenario: &Scenario, plan: &Plan, exact: &ExactSolution) {
    let window = &scenario.output.window;
    let time = scenario.time.end;
    let solver = |x: f64| (x - plan.middle) / plan.units.length;
    let ends = [window.lower[0], window.upper[0]];
    let mut edges = ends.to_vec();
    edges.extend(
        exact
            .edges(time)
            .into_iter()
            .filter(|x| ends[0] < *x && *x < ends[1]),
    );
    edges.sort_by(f64::total_cmp);
    let mut points = Vec::new();
    for edge in edges.windows(2) {
        let length = edge[1] - edge[0];
        for i in 0..=POINTS {
            // Just inside the edges: on them the solution may have either of its values.
            let part = (f64::from(i) / f64::from(POINTS)).clamp(1e-9, 1.0 - 1e-9);
            let x = edge[0] + length * part;
            points.push((solver(x), exact.at(x, time)[0] / plan.units.density()));
        }
    }
    let _ = writeln!(
        text,
        "
/// The window in which errors are measured.
pub const WINDOW: [f64; 2] = [{:?}, {:?}];

/// The exact density at the end: position, density, joined by straight lines.
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
