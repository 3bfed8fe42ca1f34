//! The gas far beyond an outflow side, which waves come in from.

use super::material::{EquationOfState, Material};
use crate::bound::POSITIVE;
use crate::entry::{ANY, Bound};
use crate::error::Fault;
use crate::geometry::AXES;
use crate::section::Section;
use crate::{Domain, Side};

/// What is known of the gas far beyond the outflow sides; what is not is that of the gas next to
/// the side at t = 0.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Outflow {
    /// Density * velocity^2.
    pub pressure: Option<f64>,
    /// Length / time; not into the domain. What is across the flow plays no part.
    pub velocity: Option<Vec<f64>>,
}

/// `[outflow]`, which goes with an outflow side.
pub(super) fn outflow(
    root: &Section<'_>,
    domain: &Domain,
    materials: &[Material],
) -> Result<Outflow, Fault> {
    let Some(entry) = root.optional("outflow") else {
        return Ok(Outflow::default());
    };
    let mut sides = outflows(domain);
    let Some((axis, end)) = sides.next() else {
        return Err(entry.does_not_fit(
            "no side of the domain is an outflow".to_owned(),
            "take [outflow] out, or write for example sides = [[\"inflow\", \"outflow\"]]",
        ));
    };
    let has_two = sides.next().is_some();
    let section = entry.section()?;
    let pressure = section.optional("pressure");
    let pressure = pressure.map(|entry| entry.number(allowed(materials)));
    let Some(entry) = section.optional("velocity") else {
        return Ok(Outflow {
            pressure: pressure.transpose()?,
            velocity: None,
        });
    };
    let velocity = entry.vector(domain.extent.lower.len())?;
    let axis_name = AXES[axis];
    if has_two {
        let reason = format!("gas goes out at both sides along {axis_name}");
        let cure = "take `velocity` out: one velocity is not outwards at both";
        return Err(entry.does_not_fit(reason, cure));
    }
    if [-1.0, 1.0][end] * velocity[axis] < 0.0 {
        let (side, sign) = [("lower", "negative"), ("upper", "positive")][end];
        let reason = format!("it goes out at the {side} side along {axis_name}");
        let cure = format!("make it point out of the domain: a {sign} number along {axis_name}");
        return Err(entry.does_not_fit(reason, &cure));
    }
    Ok(Outflow {
        pressure: pressure.transpose()?,
        velocity: Some(velocity),
    })
}

/// The directions and ends (0: lower, 1: upper) of the outflow sides.
fn outflows(domain: &Domain) -> impl Iterator<Item = (usize, usize)> {
    let ends = domain.sides.iter().enumerate();
    let ends = ends.flat_map(|(axis, sides)| [(axis, 0, sides[0]), (axis, 1, sides[1])]);
    ends.filter_map(|(axis, end, side)| (side == Side::Outflow).then_some((axis, end)))
}

/// The pressures that some of the materials can have: only stiff ones pull.
fn allowed(materials: &[Material]) -> Bound {
    let is_stiff = |material: &Material| {
        matches!(
            material.law,
            EquationOfState::StiffenedGas { .. } | EquationOfState::Tait { .. }
        )
    };
    match materials.iter().any(is_stiff) {
        true => ANY,
        false => POSITIVE,
    }
}
