//! A linear system in one dimension as Rust source: its equations, its motion and its cloud.

use std::fmt::Write;

use motes_core::equation::linear::NamedField;
use motes_core::equation::linear::systems::Units;

use super::one_line;
use crate::families::strengths::{Plan, RunField};
use crate::scenario::linear::System;

/// A linear scenario that a device cannot be given as a line.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error("`motes export` does not write `{name}`: it is {system} in dimension {dimension}")]
#[diagnostic(help(
    "it writes gas tubes, and acoustics, telegraph and convection-diffusion in dimension 1; a device \
     can run another system, but its LinearDynamics must be made by hand as that of \
     motes_core::equation::linear::Line is"
))]
pub struct NoLine {
    name: String,
    system: &'static str,
    dimension: usize,
}

/// What a constructor of the core is called, and how it is called.
pub(super) struct Constructor {
    pub name: &'static str,
    pub types: &'static str,
    pub call: String,
}

/// The source of a module with a `LINE`, its `system`, its `motion` and the capacities it needs.
///
/// `name`: of the scenario; `command`: what made it, for its first line.
///
/// # Errors
/// Anything but acoustics and the telegraph line in one dimension.
pub(super) fn line(name: &str, plan: &Plan, command: &str) -> Result<String, NoLine> {
    let refused = || NoLine {
        name: name.to_owned(),
        system: plan.system.name(),
        dimension: plan.dimension,
    };
    let (Some(system), Some(motion), None) = (system(plan), motion(plan), &plan.source) else {
        return Err(refused());
    };
    let particles = plan.weights.len();
    let mut text = format!(
        "//! Made by `{command}`, not by hand.
//!
//! Before a device runs it in a scalar, `motes run` tells whether the scalar can hold it.

use motes_core::cutoff::Named as CutOff;
use motes_core::domain::Side;
use motes_core::equation::linear::systems::{{{system_name}, Units}};
use motes_core::equation::linear::{{{cloud}}};
use motes_core::integrator::{{{integrator}}};
use motes_core::scalar::Scalar;

/// The name of the scenario.
pub const NAME: &str = {name:?};

/// Number of particles.
pub const PARTICLES: usize = {particles};

/// Cells they can take, and one.
pub const CELLS: usize = {cells};

/// The cut-off.
pub const CUT_OFF: CutOff = CutOff::{cut_off:?};

/// The time integrator.
pub const METHOD: RungeKutta = {method};

/// The equations: from the scenario's numbers and units to the solver's.
pub fn system<S: Scalar>() -> {system_name}{system_types} {{
    {system_call}
}}

/// What the particles follow.
pub fn motion<S: Scalar>() -> {motion_name}{motion_types} {{
    {motion_call}
}}

/// The line, in solver units.
#[rustfmt::skip]
pub const LINE: Line<'static, {components}> = Line {{
    half_length: {half:?},
    sides: [Side::{low:?}, Side::{high:?}],
    cloud: &[\n",
        command = one_line(command),
        system_name = system.name,
        system_types = system.types,
        system_call = system.call,
        cloud = sorted(["Line", "Particle", motion.name]),
        integrator = sorted(["RungeKutta", &method(plan)]),
        motion_name = motion.name,
        motion_types = motion.types,
        motion_call = motion.call,
        method = method(plan),
        cells = motes_core::neighbours::cell_bound(particles as u32) + 1,
        cut_off = plan.cut_off,
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
    Ok(text)
}

/// A list of imports, as rustfmt has it.
pub(super) fn sorted<const N: usize>(mut names: [&str; N]) -> String {
    names.sort_unstable();
    names.join(", ")
}

/// The name of the method in the core.
fn method(plan: &Plan) -> String {
    plan.method.name().to_uppercase().replace('-', "_")
}

/// The equations, where a device can have them.
fn system(plan: &Plan) -> Option<Constructor> {
    let Units { length, velocity } = plan.units;
    let units = format!(
        "Units {{
        length: {length:?},
        velocity: {velocity:?},
    }}"
    );
    let (name, call) = match (&plan.system, plan.dimension) {
        (
            System::Acoustics {
                density,
                sound_speed,
            },
            1,
        ) => (
            "Acoustics",
            format!(
                "let units = {units};\n    Acoustics::new({density:?}, {sound_speed:?}, units)"
            ),
        ),
        (
            System::Telegraph {
                inductance,
                capacitance,
                resistance,
                conductance,
            },
            1,
        ) => (
            "Telegraph",
            format!(
                "let units = {units};
    let (capacitance, inductance) = ({capacitance:?}, {inductance:?});
    let (conductance, resistance) = ({conductance:?}, {resistance:?});
    Telegraph::new([capacitance, inductance], [conductance, resistance], units)"
            ),
        ),
        _ => return None,
    };
    Some(Constructor {
        name,
        types: "<S>",
        call,
    })
}

/// What the particles follow, where it is of one dimension. The numbers are those that a run
/// rounds to its scalar.
pub(super) fn motion(plan: &Plan) -> Option<Constructor> {
    let RunField::Named(field) = plan.motion::<f64, 1>() else {
        return None;
    };
    let (name, types, fields) = match field {
        NamedField::Still => return Some(still()),
        NamedField::Uniform(field) => (
            "Uniform",
            "<S, 1>",
            vec![("velocity", vector(field.velocity))],
        ),
        NamedField::Compression(field) => (
            "Compression",
            "<S, 1>",
            vec![
                ("rate", number(field.rate)),
                ("center", vector(field.center)),
            ],
        ),
        NamedField::Wave(field) => (
            "Wave",
            "<S>",
            vec![
                ("amplitude", number(field.amplitude)),
                ("length", number(field.length)),
                ("phase", number(field.phase)),
            ],
        ),
        NamedField::Rotation(_) | NamedField::Shear(_) => return None,
    };
    let fields = fields
        .iter()
        .map(|(field, value)| format!("        {field}: {value},\n"));
    Some(Constructor {
        name,
        types,
        call: format!("{name} {{\n{}    }}", fields.collect::<String>()),
    })
}

fn still() -> Constructor {
    Constructor {
        name: "Still",
        types: "",
        call: "Still".to_owned(),
    }
}

fn number(value: f64) -> String {
    format!("S::from_f64({value:?})")
}

fn vector([value]: [f64; 1]) -> String {
    format!("[{}]", number(value))
}
