//! Convection-diffusion in one dimension as Rust source: its problem and its cloud.

use std::fmt::Write;

use motes_core::domain::Side;
use motes_core::equation::diffusion::{
    Conductor, Drive, DrivenCondition, Mean, Modulation, NamedProblem, Slab,
};
use motes_core::equation::linear::{Particle, Still};
use motes_core::neighbours::{Grid, cell_bound};

use super::line::{Constructor, motion};
use super::one_line;
use crate::families::strengths::Plan;
use crate::scenario::linear::{
    Conductor as ConductorName, ConvectionDiffusion, Drive as DriveName, Form, Mean as MeanName,
    Method, Reaction as ReactionName,
};

/// A scenario of convection-diffusion that a device cannot be given as a slab.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error("`motes export` does not write `{name}`: {reason}")]
#[diagnostic(help(
    "of convection-diffusion it writes one species in dimension 1, between walls or periodic sides, \
     with form = \"direct\" and method = \"rkl2\"; a device can run another problem, but its \
     DiffusionDynamics must be made by hand as that of motes_core::equation::diffusion::Slab is"
))]
pub struct NoSlab {
    name: String,
    reason: String,
}

/// The source of a module with a `SLAB`, its `motion` and the capacities it needs.
///
/// `name`: of the scenario; `command`: what made it, for its first line.
///
/// # Errors
/// What the help of [`NoSlab`] does not list.
pub(super) fn slab(
    name: &str,
    (plan, of): (&Plan, &ConvectionDiffusion),
    command: &str,
) -> Result<String, NoSlab> {
    let refused = |reason: &str| NoSlab {
        name: name.to_owned(),
        reason: reason.to_owned(),
    };
    if let Some(reason) = obstacle(plan, of) {
        return Err(refused(&reason));
    }
    let motion = motion(plan).ok_or_else(|| refused("its motion is of more than one dimension"))?;
    let media = plan.media::<f64>(of);
    let cloud: Vec<_> = plan.particles().collect();
    let slab = Slab {
        half_length: plan.axes[0].upper,
        sides: plan.axes[0].sides,
        problem: plan.named_problem(of, &media),
        mean: match of.mean {
            MeanName::Arithmetic => Mean::Arithmetic,
            MeanName::Harmonic => Mean::Harmonic,
        },
        cloud: &cloud,
        epsilon: plan.epsilon,
        courant: plan.courant,
        stages: plan.stages,
        longest: plan.longest_step(),
        step: plan.step,
        end: plan.end,
    };
    let cells = cells(&slab, plan).ok_or_else(|| refused("its width does not fit its length"))?;
    let mut text = head(name, (plan, &slab), &motion, command, cells);
    write_slab(&mut text, &slab);
    Ok(text)
}

/// Why a device cannot have it as a slab.
fn obstacle(plan: &Plan, of: &ConvectionDiffusion) -> Option<String> {
    let dimension = plan.dimension;
    if dimension != 1 {
        return Some(format!(
            "it is convection-diffusion in dimension {dimension}"
        ));
    }
    if of.species.len() != 1 {
        return Some(format!("it has {} species", of.species.len()));
    }
    let is_formula = matches!(of.profile, ConductorName::Formula { .. })
        || matches!(of.reaction, ReactionName::Formula { .. })
        || (of.walls.iter().flatten().flatten())
            .any(|wall| matches!(wall.drive(), Some(DriveName::Formula(_))));
    if is_formula {
        return Some("its diffusivity, its reaction or what drives a wall is a formula".to_owned());
    }
    if of.form == Form::Mixed {
        return Some("its form is mixed".to_owned());
    }
    if plan.method != Method::Rkl2 {
        return Some(format!("its method is {}", plan.method.name()));
    }
    let is_free = plan.axes[0].sides.contains(&Side::Free);
    is_free.then(|| "it has free sides".to_owned())
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

/// All before the slab itself.
fn head(
    name: &str,
    (plan, slab): (&Plan, &Slab<'_>),
    motion: &Constructor,
    command: &str,
    cells: u64,
) -> String {
    let [[[lower], [upper]]] = &slab.problem.walls;
    let points = series(lower).map_or(0, <[_]>::len) + series(upper).map_or(0, <[_]>::len);
    let layers = match slab.problem.conductor {
        Conductor::Layers { factors, .. } => factors.len(),
        _ => 0,
    };
    let drive = match (drive(lower), drive(upper)) {
        (None, None) => "",
        _ => "Drive, ",
    };
    format!(
        "//! Made by `{command}`, not by hand.
//!
//! Before a device runs it in a scalar, `motes run` tells whether the scalar can hold it.

use motes_core::cutoff::Named as CutOff;
use motes_core::domain::Side;
use motes_core::equation::diffusion::{{
    Conductor, {drive}DrivenCondition, Mean, Modulation, NamedProblem, Reaction, Slab,
}};
use motes_core::equation::linear::{{{cloud}}};
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = {name:?};

/// Number of particles.
pub const PARTICLES: usize = {particles};

/// Cells they can take, and one.
pub const CELLS: usize = {cells};

/// Points of the series at both walls.
pub const POINTS: usize = {points};

/// Layers of the conductor.
pub const LAYERS: usize = {layers};

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::{cut_off:?};

/// What the particles follow.
pub fn motion<S: Scalar>() -> {motion_name}{motion_types} {{
    {motion_call}
}}
",
        command = one_line(command),
        cloud = super::line::sorted(["Particle", motion.name]),
        particles = slab.cloud.len(),
        cut_off = plan.cut_off,
        motion_name = motion.name,
        motion_types = motion.types,
        motion_call = motion.call,
    )
}

/// The slab.
fn write_slab(text: &mut String, slab: &Slab<'_>) {
    let NamedProblem {
        diffusivity,
        conductor,
        modulation,
        reaction,
        walls: [[[lower], [upper]]],
        ..
    } = &slab.problem;
    let Modulation {
        amplitude,
        frequency,
    } = modulation;
    let _ = write!(
        text,
        "
/// The slab, in solver units.
#[rustfmt::skip]
pub const SLAB: Slab<'static> = Slab {{
    half_length: {half:?},
    sides: [Side::{low:?}, Side::{high:?}],
    problem: NamedProblem {{
        diffusivity: {diffusivity:?},
        conductor: {conductor},
        modulation: Modulation {{ amplitude: {amplitude:?}, frequency: {frequency:?} }},
        tensor: None,
        reaction: Reaction::{reaction:?},
        walls: [[
            [{lower}],
            [{upper}],
        ]],
    }},
    mean: Mean::{mean:?},
    cloud: &[\n",
        half = slab.half_length,
        low = slab.sides[0],
        high = slab.sides[1],
        conductor = conductor_source(conductor),
        lower = wall_source(lower),
        upper = wall_source(upper),
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
}

fn conductor_source(conductor: &Conductor<'_, f64>) -> String {
    match conductor {
        Conductor::Layers { bounds, factors } => {
            format!("Conductor::Layers {{ bounds: &{bounds:?}, factors: &{factors:?} }}")
        }
        plain => format!("Conductor::{plain:?}"),
    }
}

fn wall_source(wall: &DrivenCondition<'_, f64>) -> String {
    let driven = drive(wall).map(drive_source).unwrap_or_default();
    match wall {
        DrivenCondition::NoFlux => "DrivenCondition::NoFlux".to_owned(),
        DrivenCondition::Value(_) => format!("DrivenCondition::Value({driven})"),
        DrivenCondition::Flux(_) => format!("DrivenCondition::Flux({driven})"),
        DrivenCondition::Exchange { rate, .. } => {
            format!("DrivenCondition::Exchange {{ rate: {rate:?}, outside: {driven} }}")
        }
    }
}

fn drive_source(drive: &Drive<'_, f64>) -> String {
    match drive {
        Drive::Constant(value) => format!("Drive::Constant({value:?})"),
        Drive::Series(points) => {
            let rows = points
                .iter()
                .map(|point| format!("                {point:?},\n"));
            format!(
                "Drive::Series(&[\n{}            ])",
                rows.collect::<String>()
            )
        }
    }
}

/// What drives a wall.
fn drive<'a, 's>(wall: &'a DrivenCondition<'s, f64>) -> Option<&'a Drive<'s, f64>> {
    match wall {
        DrivenCondition::NoFlux => None,
        DrivenCondition::Value(drive)
        | DrivenCondition::Flux(drive)
        | DrivenCondition::Exchange { outside: drive, .. } => Some(drive),
    }
}

/// The points that drive a wall.
fn series<'s>(wall: &DrivenCondition<'s, f64>) -> Option<&'s [(f64, f64)]> {
    match drive(wall)? {
        Drive::Series(points) => Some(points),
        Drive::Constant(_) => None,
    }
}
