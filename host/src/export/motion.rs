//! A velocity field as Rust source.

use motes_core::cloud::{NamedField, VelocityField};

use super::expressions::Expressions;
use super::module::{Constructor, Module, number, vector};
use crate::families::strengths::{RunField, ScaledField};

/// A field; the numbers of one that the core has are those that a run rounds to its scalar. One of formulas
/// becomes a type of that name.
pub(super) fn field<const D: usize>(
    module: &mut Module,
    (name, doc): (&'static str, &str),
    field: &RunField<f64, D>,
) -> Constructor {
    let field = match field {
        RunField::Named(field) => {
            let constructor = named(field);
            module.import("motes_core::equation::linear", [constructor.name]);
            return constructor;
        }
        RunField::Formula(field) => field,
    };
    written::<D>(module, (name, doc), field);
    Constructor {
        name,
        types: String::new(),
        call: name.to_owned(),
    }
}

/// One that the core has.
fn named<const D: usize>(field: &NamedField<f64, D>) -> Constructor {
    let (name, types, fields) = match field {
        NamedField::Still => {
            return Constructor {
                name: "Still",
                types: String::new(),
                call: "Still".to_owned(),
            };
        }
        NamedField::Uniform(field) => (
            "Uniform",
            format!("<S, {D}>"),
            vec![("velocity", vector(&field.velocity))],
        ),
        NamedField::Rotation(field) => ("Rotation", format!("<S, {D}>"), {
            vec![
                ("rate", number(field.rate)),
                ("center", vector(&field.center)),
            ]
        }),
        NamedField::Shear(field) => ("Shear", format!("<S, {D}>"), {
            vec![
                ("rate", number(field.rate)),
                ("center", vector(&field.center)),
            ]
        }),
        NamedField::Compression(field) => ("Compression", format!("<S, {D}>"), {
            vec![
                ("rate", number(field.rate)),
                ("center", vector(&field.center)),
            ]
        }),
        NamedField::Wave(field) => (
            "Wave",
            "<S>".to_owned(),
            vec![
                ("amplitude", number(field.amplitude)),
                ("length", number(field.length)),
                ("phase", number(field.phase)),
            ],
        ),
    };
    let fields = fields
        .iter()
        .map(|(field, value)| format!("        {field}: {value},\n"));
    Constructor {
        name,
        types,
        call: format!("{name} {{\n{}    }}", fields.collect::<String>()),
    }
}

/// A field of formulas: an item of the module.
fn written<const D: usize>(module: &mut Module, (name, doc): (&str, &str), field: &ScaledField) {
    module.import("motes_core::equation::linear", ["Place", "VelocityField"]);
    module.frame(field.frame());
    let formulas = field.formulas();
    let velocity = Expressions::of(&formulas.velocity);
    let diagonal: Vec<_> = formulas.slopes.iter().step_by(D + 1).cloned().collect();
    let divergence = Expressions::of(&diagonal);
    module.item(format!(
        "/// {doc}: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct {name};

impl<S: Scalar> VelocityField<S, {D}> for {name} {{
    fn velocity(&self, {velocity_place}: &Place<S, {D}>) -> [S; {D}] {{
{velocity_point}        [
{velocity}        ]
    }}
    fn divergence(&self, {slope_place}: &Place<S, {D}>) -> S {{
{slope_point}        FRAME.rate({slopes})
    }}
    fn gradient(&self) -> S {{
        {gradient}
    }}
    fn convergence(&self) -> S {{
        {convergence}
    }}
}}\n",
        velocity_place = velocity.place(),
        velocity_point = velocity.point(),
        velocity = velocity.rows("FRAME.velocity", D),
        slope_place = divergence.place(),
        slope_point = divergence.point(),
        slopes = divergence.sum(),
        gradient = number(VelocityField::<f64, D>::gradient(field)),
        convergence = number(VelocityField::<f64, D>::convergence(field)),
    ));
}
