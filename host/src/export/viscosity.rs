//! A pseudo-viscosity as Rust source.

use super::module::Module;
use crate::scenario::{Viscosity, ViscosityKind};

/// Where the core has them.
const VISCOSITY: &str = "motes_core::equation::gas::viscosity";

/// Adds the pseudo-viscosity: a function `viscosity`.
pub(super) fn viscosity(module: &mut Module, viscosity: &Viscosity) {
    module.import(VISCOSITY, ["Named as Viscosity"]);
    module.import("motes_core::scalar", ["Scalar"]);
    let kind = match viscosity.kind {
        // That it sees velocities between the particles is an option of the gas.
        ViscosityKind::Pairwise | ViscosityKind::Limited => Some("Pairwise"),
        ViscosityKind::GingoldMonaghan => Some("GingoldMonaghan"),
        ViscosityKind::VonNeumann => Some("VonNeumann"),
        ViscosityKind::None => None,
    };
    let call = match kind {
        None => "Viscosity::Inviscid".to_owned(),
        Some(kind) => {
            module.import(VISCOSITY, ["Coefficients", kind]);
            let (alpha, beta) = (viscosity.alpha, viscosity.beta);
            format!(
                "Viscosity::{kind}({kind}(Coefficients {{
        alpha: S::from_f64({alpha:?}),
        beta: S::from_f64({beta:?}),
    }}))"
            )
        }
    };
    module.item(format!(
        "/// The pseudo-viscosity.\npub fn viscosity<S: Scalar>() -> Viscosity<S> {{\n    {call}\n}}\n"
    ));
}
