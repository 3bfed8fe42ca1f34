//! Contacts that the particles of a start will not hold.

use super::regions::{LEAST, mass};
use crate::families::gas::exact::riemann;
use crate::scenario::{Region, Scenario};
use crate::setup::Placed;

/// Of how many times the stiffness `ρ c²` of the other a gas moves away from a contact in lumps.
const STIFF: f64 = 100.0;

/// How many times more than the other a gas is compressed where it does.
const UNLIKE: f64 = 2.0;

/// A contact that is not what the exact solution says by the end: where a gas has spread so thin behind its
/// wave that less than one of its particles lies there, what pushes the other gas is missing; where one is
/// compressed much more than a stiffer one, that one counts the partners that crowd there as its own.
pub(super) fn unheld_contact(scenario: &Scenario, placed: &[Placed]) -> Option<String> {
    let direction = scenario.riemann_direction()?;
    let (solution, ..) = riemann(scenario, false).ok()?;
    let star = solution.star()?;
    let mut sides: Vec<(usize, &Region)> = scenario.regions.iter().enumerate().collect();
    let place = |region: &Region| region.extent.lower[direction];
    sides.sort_by(|a, b| place(a.1).total_cmp(&place(b.1)));
    // Without a shock nothing is pushed.
    sides.iter().find(|side| side.1.pressure < star.pressure)?;
    let densities = [star.left_density, star.right_density];
    let speeds = [
        star.velocity - solution.left_wave()[1],
        solution.right_wave()[0] - star.velocity,
    ];
    let behind = sides.iter().zip(densities.into_iter().zip(speeds));
    let across = behind.map(|(side, (density, speed))| {
        let mass = mass(scenario, placed, side.1).unwrap_or(0.0);
        let spacing = libm::pow(mass / density, 1.0 / scenario.dimension as f64);
        (side.0, speed * scenario.time.end / spacing)
    });
    let (number, across) = across.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let reached = format!(
        "pressure {:.3e} and velocity {:.3e}",
        star.pressure, star.velocity
    );
    if across > 0.0 && across < 1.0 {
        let factor = libm::pow(LEAST / across, scenario.dimension as f64);
        let needed = libm::ceil(factor * placed.len() as f64);
        return Some(format!(
            "by t = {} the gas of region {number} between its wave and the contact is {across:.2} spacings \
             across: the contact does not have {reached}, as it should; use {needed} particles",
            scenario.time.end
        ));
    }
    let stiffness = |(side, density): (&(usize, &Region), f64)| {
        let law = &scenario.materials[side.1.material].law;
        density * law.sound_speed_squared(density, law.energy(density, star.pressure))
    };
    let [left, right] = [0, 1].map(|i| stiffness((&sides[i], densities[i])));
    let compressed = [0, 1].map(|i| densities[i] / sides[i].1.density);
    let unlike = (compressed[0] / compressed[1]).max(compressed[1] / compressed[0]);
    ((left / right).max(right / left) > STIFF && unlike > UNLIKE).then(|| {
        format!(
            "the gases of the contact are compressed {:.2} and {:.2} times, and one is much stiffer: it counts the \
             partners that crowd beyond the contact, its surface runs ahead, and {reached} are reached \
             slowly: compare with four times as many particles",
            compressed[0], compressed[1]
        )
    })
}
