//! Contacts that the particles of a start will not hold.

use super::doubts::{LEAST, mass};
use super::exact::riemann;
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

#[cfg(test)]
mod tests {
    use crate::families::gas::doubts::tests::told;

    /// Gas at 1e4 times pressure and density of another spreads to 0.0077 between its wave and the contact.
    #[test]
    fn a_contact_that_no_particle_holds_is_told() {
        let dense = [
            "region.0.density=1e6",
            "region.0.pressure=1e6",
            "resolution.share=volume",
        ];
        let told_of = |changes: &[&str]| told("sod", changes);
        let unheld = told_of(&dense);
        assert!(
            unheld.contains("the gas of region 0 between its wave"),
            "{unheld}"
        );
        assert_eq!(told_of(&dense[2..]), "");
        // Air that water throws before it is compressed threefold.
        let thrown = told("water-air", &["region.1.density=1.2"]);
        assert!(
            thrown.contains("compressed 0.80 and 2.93 times"),
            "{thrown}"
        );
        assert_eq!(told("water-air", &["region.1.pressure=9e8"]), "");
        // Two rarefactions leave but a little gas, and push nothing.
        assert!(!told("toro2", &["resolution.particles=40"]).contains("the contact"));
    }
}
