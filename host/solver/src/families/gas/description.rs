//! What there is to see of a gas.

use super::balance::columns;
use super::exact::FIELDS;
use super::plan::Plan;
use crate::run::{Abscissa, Description, Kind, View, fields};

/// What there is to see of a gas.
pub(super) fn description(plan: &Plan) -> Description {
    let dimension = plan.dimension;
    let fields = fields(
        dimension,
        &[
            ("position", Kind::Vector),
            ("velocity", Kind::Vector),
            ("mass", Kind::Scalar),
            ("density", Kind::Scalar),
            ("pressure", Kind::Scalar),
            ("energy", Kind::Scalar),
            ("epsilon", Kind::Scalar),
            ("neighbours", Kind::Integer),
            ("sound_speed", Kind::Scalar),
            ("divergence", Kind::Scalar),
            ("viscosity_factor", Kind::Scalar),
            ("material", Kind::Integer),
        ],
    );
    let place = |name: &&str| fields.iter().position(|field| field.name == **name);
    let snapshot = [
        "mass",
        "density",
        "pressure",
        "energy",
        "sound_speed",
        "divergence",
        "viscosity_factor",
        "epsilon",
        "velocity",
        "neighbours",
        "material",
    ];
    let components = |name: &str| match dimension {
        1 => vec![name.to_owned()],
        n => ["x", "y", "z"][..n]
            .iter()
            .map(|axis| format!("{name}_{axis}"))
            .collect(),
    };
    let mut diagnostics = vec!["mass".to_owned()];
    diagnostics.extend(components("momentum"));
    diagnostics.push("energy".to_owned());
    for quantity in ["density", "velocity", "pressure", "neighbours"] {
        diagnostics.extend(["min", "mean", "max"].map(|part| format!("{quantity}_{part}")));
    }
    diagnostics.push("kinetic_energy".to_owned());
    let axes = ["x", "y", "z"];
    let turns = turns(dimension).iter();
    diagnostics.extend(turns.map(|&i| format!("angular_momentum_{}", axes[i])));
    let columns = columns(plan.opening.as_ref()).into_iter();
    diagnostics.extend(columns.map(|(_, column)| column));
    diagnostics.extend(plan.force_columns().into_iter().map(|(_, column)| column));
    diagnostics.extend(plan.work_column());
    Description {
        dimension,
        particles: plan.particles.len(),
        spacing: plan.units.length,
        duration: plan.end * plan.units.time(),
        compared: FIELDS.iter().filter_map(place).collect(),
        snapshot: snapshot.iter().filter_map(place).collect(),
        fields,
        is_state: false,
        diagnostics,
        sums: ["mass", "momentum", "angular_momentum", "energy"]
            .map(String::from)
            .to_vec(),
        known: vec![plan.opening.is_none(); 4],
        is_conserving: plan.opening.is_none(),
        leak: "gas flows through the sides",
        view: View {
            abscissa: plan.abscissa,
            label: match plan.abscissa {
                Abscissa::Along(0) => "position",
                Abscissa::Along(1) => "y",
                Abscissa::Along(_) => "z",
                Abscissa::From(_) => "radius",
            },
            half_width: None,
            is_cut: true,
            length: "speed",
        },
    }
}

/// The axes about which a gas can turn.
pub(super) fn turns(dimension: usize) -> &'static [usize] {
    match dimension {
        1 => &[],
        2 => &[2],
        _ => &[0, 1, 2],
    }
}
