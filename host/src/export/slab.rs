//! Convection-diffusion in one dimension as Rust source: its problem and its cloud.

use std::fmt::Write;

use motes_core::cloud::{Particle, Still};
use motes_core::domain::Side;
use motes_core::equation::diffusion::{Form, Slab};
use motes_core::neighbours::{Grid, cell_bound};

use super::laws::is_written;
use super::module::Module;
use super::motion;
use super::problem::{numbers, room};
use crate::families::diffusion::form;
use crate::families::strengths::{Plan, RunField};
use crate::scenario::linear::{ConvectionDiffusion, Method};

/// The source of a module with a `SLAB`, its `motion` and the capacities it needs; `None` of anything but
/// one species in one dimension, between walls or periodic sides, in the direct form with rkl2 and without
/// formulas.
pub(super) fn slab(
    mut module: Module,
    name: &str,
    (plan, of): (&Plan, &ConvectionDiffusion),
) -> Option<String> {
    let (form, mean) = form(of);
    let is_stabilised = form == Form::Direct && plan.method == Method::Rkl2;
    let is_bound = !plan.axes[0].sides.contains(&Side::Free);
    if !(plan.dimension == 1 && of.species.len() == 1 && is_stabilised && is_bound) {
        return None;
    }
    let field = plan.motion::<f64, 1>();
    let media = plan.media::<f64>(of);
    if is_written(&media.formulas) || !matches!(field, RunField::Named(_)) {
        return None;
    }
    let cloud: Vec<_> = plan.particles().collect();
    let slab = Slab {
        half_length: plan.axes[0].upper,
        sides: plan.axes[0].sides,
        problem: plan.named_problem(of, &media),
        mean,
        cloud: &cloud,
        epsilon: plan.epsilon,
        courant: plan.courant,
        stages: plan.stages,
        longest: plan.longest_step(),
        step: plan.step,
        end: plan.end,
    };
    let cells = cells(&slab, plan)?;
    let module = &mut module;
    module.import("motes_core::domain", ["Side"]);
    module.import("motes_core::equation::diffusion", ["Mean", "Slab"]);
    module.import("motes_core::equation::linear", ["Particle"]);
    module.cloud(name, cloud.len());
    module.cells(cells);
    room(module, &slab.problem, "both");
    module.cut_off(plan.cut_off);
    let motion = motion::field(module, ("Motion", ""), &field);
    motion.function(module, "motion", "What the particles follow.");
    write_slab(module, &slab);
    Some(module.text())
}

/// Cells it takes, one that rounding may add in a coarse scalar, and one: fewer than those of a
/// cloud of which nothing is known.
fn cells(slab: &Slab<'_>, plan: &Plan) -> Option<u64> {
    let solver = slab.dynamics(plan.cut_off, slab.problem, Still);
    let positions: Vec<_> = slab
        .cloud
        .iter()
        .map(|particle| particle.position)
        .collect();
    let grid = Grid::fit(&solver.domain, &positions, solver.reach()).ok()?;
    let most = u64::from(cell_bound(positions.len() as u32)) + 1;
    Some(most.min(grid.cells() + 2))
}

/// The slab.
fn write_slab(module: &mut Module, slab: &Slab<'_>) {
    let problem = numbers(module, &slab.problem, 8);
    let mut text = format!(
        "/// The slab, in solver units.
#[rustfmt::skip]
pub const SLAB: Slab<'static> = Slab {{
    half_length: {half:?},
    sides: [Side::{low:?}, Side::{high:?}],
    problem: NamedProblem {{
{problem}    }},
    mean: Mean::{mean:?},
    cloud: &[\n",
        half = slab.half_length,
        low = slab.sides[0],
        high = slab.sides[1],
        mean = slab.mean,
    );
    for Particle {
        position,
        weight,
        value,
    } in slab.cloud
    {
        let _ = writeln!(
            text,
            "        Particle {{ position: {position:?}, weight: {weight:?}, value: {value:?} }},"
        );
    }
    let _ = writeln!(
        text,
        "    ],
    epsilon: {:?},
    courant: {:?},
    stages: {},
    longest: {:?},
    step: {:?},
    end: {:?},
}};",
        slab.epsilon, slab.courant, slab.stages, slab.longest, slab.step, slab.end
    );
    module.item(text);
}
