//! What there is to see of a cloud of strengths.

use super::balance::Source;
use super::plan::Plan;
use crate::run::{Abscissa, Description, Kind, View, fields};

/// What there is to see of a cloud.
pub(super) fn description(plan: &Plan) -> Description {
    let (dimension, spacing) = (plan.dimension, plan.units.length);
    let mut all = vec![("position", Kind::Vector), ("weight", Kind::Scalar)];
    all.extend(plan.names.iter().map(|name| (name.as_str(), Kind::Scalar)));
    all.push(("neighbours", Kind::Integer));
    let last = all.len() - 1;
    let mut diagnostics = ["energy_norm", "energy_bound"].map(String::from).to_vec();
    diagnostics.extend(plan.names.iter().map(|name| format!("total_{name}")));
    for quantity in plan.names.iter().map(String::as_str).chain(["neighbours"]) {
        diagnostics.extend(["min", "mean", "max"].map(|part| format!("{quantity}_{part}")));
    }
    let sources = Source::all(plan).into_iter();
    diagnostics.extend(sources.map(|source| source.column(&plan.names)));
    Description {
        dimension,
        particles: plan.weights.len(),
        spacing,
        duration: plan.duration,
        fields: fields(dimension, &all),
        compared: (2..last).collect(),
        is_state: true,
        snapshot: (1..=last).collect(),
        diagnostics,
        sums: plan.names.clone(),
        known: plan.budget.known.clone(),
        is_conserving: plan.budget.is_conserving(),
        leak: "sources or walls change the sums",
        view: View {
            abscissa: Abscissa::Along(0),
            label: match dimension {
                1 => "position",
                _ => "x, along the line through the middle",
            },
            half_width: (dimension > 1).then_some(0.5 * spacing),
            is_cut: false,
            length: "",
        },
    }
}
