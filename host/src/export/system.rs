//! A first-order system as Rust source.

use motes_core::equation::linear::systems::Units;

use super::coefficients::coefficients;
use super::expressions::Expressions;
use super::module::{Constructor, Module, number};
use super::motion;
use crate::families::strengths::Plan;
use crate::scenario::formula::Formula;
use crate::scenario::linear::System;

/// Where the core has the systems.
const SYSTEMS: &str = "motes_core::equation::linear::systems";

/// The system of a plan whose rows have `P` components, with its source.
pub(super) fn system<const D: usize, const P: usize>(
    module: &mut Module,
    plan: &Plan,
) -> Option<Constructor> {
    let own = own::<D, P>(module, plan)?;
    let Some(source) = &plan.source else {
        return Some(own);
    };
    module.import(
        "motes_core::equation::linear",
        ["Addition", "Place", "Sourced"],
    );
    module.frame(plan.frame());
    let formulas = Expressions::of(source);
    let add = |(i, formula): (usize, &Formula)| {
        let value = Expressions::expression(formula, 8);
        format!("        rates[{i}] += FRAME.rate::<S>({value});\n")
    };
    let rows: String = source.iter().enumerate().map(add).collect();
    module.item(format!(
        "/// The source: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct Supply;

impl<S: Scalar> Addition<S, {D}, {P}> for Supply {{
    fn add(&self, {}: &Place<S, {D}>, rates: &mut [S; {P}]) {{
{}{rows}    }}
}}\n",
        formulas.place(),
        formulas.point(),
    ));
    let of_type = own.of_type();
    module.item(format!(
        "/// The equations without that source.
fn unsourced<S: Scalar>() -> {of_type} {{\n    {}\n}}\n",
        own.call
    ));
    Some(Constructor {
        name: "Sourced",
        types: format!("<{of_type}, Supply>"),
        call: "Sourced {
        system: unsourced(),
        source: Supply,
    }"
        .to_owned(),
    })
}

/// The same without the source that comes to it.
fn own<const D: usize, const P: usize>(module: &mut Module, plan: &Plan) -> Option<Constructor> {
    match &plan.system {
        System::Transport { .. } => transport::<D>(module, plan),
        System::Matrices { .. } => {
            let matrices = plan.matrices::<f64, D, P>()?;
            module.import(SYSTEMS, ["Matrices"]);
            module.constant(
                "The matrices, in solver units.",
                "MATRICES",
                &format!("Matrices<f64, {D}, {P}>"),
                &format!("{matrices:?}"),
            );
            Some(Constructor {
                name: "Matrices",
                types: format!("<S, {D}, {P}>"),
                call: "MATRICES.rounded()".to_owned(),
            })
        }
        System::VariableMatrices {
            components,
            flux,
            decay,
            ..
        } => {
            coefficients::<D, P>(module, plan, (*components, flux, decay));
            let (speed, damping) = plan.wave_bounds()?;
            module.import(SYSTEMS, ["MatrixField", "VariableMatrices"]);
            Some(Constructor {
                name: "VariableMatrices",
                types: "<S, Coefficients>".to_owned(),
                call: format!(
                    "VariableMatrices {{
        matrices: Coefficients,
        speed: {},
        damping: {},
    }}",
                    number(speed),
                    number(damping)
                ),
            })
        }
        _ => named::<D>(module, plan),
    }
}

/// Transport, whose velocity may be formulas.
fn transport<const D: usize>(module: &mut Module, plan: &Plan) -> Option<Constructor> {
    let transport = plan.transport::<f64, D>()?;
    let doc = ("Flow", "What carries the quantity");
    let flow = motion::field(module, doc, &transport.velocity);
    module.import(SYSTEMS, ["Transport"]);
    Some(Constructor {
        name: "Transport",
        types: format!("<S, {}>", flow.of_type()),
        call: format!(
            "let velocity = {};
    Transport {{
        velocity,
        decay: {},
        source: {},
    }}",
            flow.call,
            number(transport.decay),
            number(transport.source)
        ),
    })
}

/// One that the core has by name.
fn named<const D: usize>(module: &mut Module, plan: &Plan) -> Option<Constructor> {
    let mut types = "<S>".to_owned();
    let (name, before, arguments) = match &plan.system {
        System::Acoustics {
            density,
            sound_speed,
        } => (
            "Acoustics",
            String::new(),
            format!("{density:?}, {sound_speed:?}"),
        ),
        System::Telegraph {
            inductance,
            capacitance,
            resistance,
            conductance,
        } => (
            "Telegraph",
            format!(
                "    let (capacitance, inductance) = ({capacitance:?}, {inductance:?});
    let (conductance, resistance) = ({conductance:?}, {resistance:?});\n"
            ),
            "[capacitance, inductance], [conductance, resistance]".to_owned(),
        ),
        System::ShallowWater {
            gravity,
            depth,
            coriolis,
        } => (
            "ShallowWater",
            String::new(),
            format!("{gravity:?}, {depth:?}, {coriolis:?}"),
        ),
        System::MaxwellTe {
            permittivity,
            permeability,
        } => (
            "MaxwellTe",
            String::new(),
            format!("{permittivity:?}, {permeability:?}"),
        ),
        System::ElasticWaves {
            density,
            lambda,
            mu,
        } => (
            "ElasticWaves",
            String::new(),
            format!("{density:?}, [{lambda:?}, {mu:?}]"),
        ),
        System::LinearisedGas {
            density,
            pressure,
            gamma,
            velocity,
        } => {
            types = format!("<S, {D}>");
            let sound_speed = (gamma * pressure / density).sqrt();
            let arguments = format!("{density:?}, {sound_speed:?}, {:?}", &velocity[..D]);
            ("LinearisedGas", String::new(), arguments)
        }
        _ => return None,
    };
    module.import(SYSTEMS, [name, "Units"]);
    let Units { length, velocity } = plan.units;
    Some(Constructor {
        name,
        types,
        call: format!(
            "let units = Units {{
        length: {length:?},
        velocity: {velocity:?},
    }};
{before}    {name}::new({arguments}, units)"
        ),
    })
}
