//! What a scalar must hold of a gas.

use motes_core::domain::Side;
use motes_core::equation::gas::{Particle, Width};
use motes_core::scalar::Scalar;

use super::opening::OpenSides;
use super::plan::Plan;
use crate::run::{RunError, check_numbers};

/// Refuses a plan with a number that the format cannot hold to 1 %.
pub(super) fn check_format<S: Scalar>(plan: &Plan, scalar: &str) -> Result<(), RunError> {
    let width = match plan.width {
        Width::Adaptive { eta, .. } => ("eta", eta),
        Width::Constant { epsilon } => ("epsilon", epsilon),
    };
    let mut numbers = vec![
        width,
        ("the duration", plan.end),
        ("courant", plan.courant),
        ("the number of particles", plan.particles.len() as f64),
    ];
    for axis in &plan.axes[..plan.dimension] {
        // Free sides mean nothing to the solver.
        if axis.sides != [Side::Free; 2] {
            numbers.push(("the length of the domain", axis.upper - axis.lower));
        }
    }
    for i in 0..plan.dimension {
        let places = plan.particles.iter().map(|p| p.position[i].abs());
        numbers.push(("a position", places.fold(0.0, f64::max)));
    }
    // The largest of each: what is small beside it may be lost.
    let largest =
        |of: &dyn Fn(&Particle<f64, 3>) -> f64| plan.particles.iter().map(of).fold(0.0, f64::max);
    numbers.extend([
        ("the mass of a particle", largest(&|p| p.mass)),
        ("an internal energy", largest(&|p| p.energy)),
    ]);
    for i in 0..plan.dimension {
        numbers.push(("a velocity", largest(&|p| p.velocity[i].abs())));
    }
    if let Some(incoming) = plan.opening.as_ref().and_then(OpenSides::incoming) {
        let particle = &incoming.particle;
        numbers.extend([
            ("the spacing of the inflow", incoming.spacing),
            ("the mass of a particle of the inflow", particle.mass),
            ("the internal energy of the inflow", particle.energy),
        ]);
        for velocity in &particle.velocity[..plan.dimension] {
            numbers.push(("a velocity of the inflow", *velocity));
        }
    }
    for velocity in plan.options.walls.velocity.iter().flatten().flatten() {
        let components = velocity[..plan.dimension].iter();
        numbers.extend(components.map(|u| ("the velocity of a wall", *u)));
    }
    for far in plan.options.plain.far.iter().flatten() {
        let stiffness = far.density * far.sound_speed * far.sound_speed;
        numbers.extend([
            ("the density beyond an open side", far.density),
            ("the sound speed beyond an open side", far.sound_speed),
        ]);
        // What is small beside sound may be lost.
        let large = [
            ("the pressure beyond an open side", far.pressure, stiffness),
            (
                "the velocity beyond an open side",
                far.velocity,
                far.sound_speed,
            ),
        ];
        let large = large
            .iter()
            .filter(|(_, value, of)| value.abs() > 0.01 * of);
        numbers.extend(large.map(|&(what, value, _)| (what, value)));
    }
    check_numbers::<S>(&numbers, scalar)
}
