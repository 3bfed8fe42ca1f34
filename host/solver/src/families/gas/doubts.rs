//! Why a gas may not be at rest, or not resolved, where it starts.

mod contact;
mod regions;
mod slow;

use crate::scenario::{Arrangement, Ball, Exact, Profile, Region, Scenario, Side};
use crate::setup::Placed;
use contact::unheld_contact;
use regions::{LEAST, mass};

/// Of how many of the smallest spacings one is that was not chosen, but left over.
const COARSE: f64 = 1.25;

/// What a careful reader should know of a gas at t = 0.
pub(super) fn doubts(scenario: &Scenario, placed: &[Placed]) -> Vec<String> {
    let starved = starved(scenario, placed).into_iter();
    starved
        .chain(unheld_contact(scenario, placed))
        .chain(uneven_walls(scenario))
        .chain(melting(scenario))
        .chain(other_equations(scenario))
        .chain(slow::solid(scenario, placed))
        .chain(slow::pulled(scenario, placed))
        .collect()
}

/// A solution of Euler's equations beside a run of others: what those do counts as an error.
fn other_equations(scenario: &Scenario) -> Option<String> {
    if matches!(scenario.output.exact?, Exact::Channel | Exact::Formula) {
        return None;
    }
    let diffusion = &scenario.diffusion;
    let viscosities = match scenario.profile {
        // Its solution has both: nothing is compressed.
        Some(Profile::TaylorGreen { .. }) => [0.0; 2],
        _ => [diffusion.viscosity, diffusion.bulk_viscosity],
    };
    let diffuses = [viscosities[0], viscosities[1], diffusion.heat]
        .iter()
        .any(|&diffusivity| diffusivity > 0.0);
    let is_heavy = scenario
        .acceleration
        .iter()
        .any(|&component| component != 0.0);
    let what = match (diffuses, is_heavy) {
        (true, false) => "[diffusion]",
        (false, true) => "[force]",
        (true, true) => "[diffusion] and [force]",
        (false, false) => return None,
    };
    Some(format!(
        "output.exact is of a gas without {what}: the errors count what that does; take output.exact or \
         {what} out"
    ))
}

/// Regions that are but a few spacings wide, and have larger ones than others: where all are alike, that
/// is what was asked for.
fn starved(scenario: &Scenario, placed: &[Placed]) -> Vec<String> {
    let dimension = scenario.dimension;
    let spacing = |region: &Region| {
        let mass = mass(scenario, placed, region)?;
        Some(libm::pow(mass / region.density, 1.0 / dimension as f64))
    };
    let spacings: Vec<Option<f64>> = scenario.regions.iter().map(spacing).collect();
    let finest = spacings
        .iter()
        .flatten()
        .copied()
        .fold(f64::INFINITY, f64::min);
    let of_region = |(number, region): (usize, &Region)| {
        let spacing = spacings[number].filter(|spacing| *spacing > COARSE * finest)?;
        let across = narrowest(scenario, region)? / spacing;
        (across < LEAST).then(|| {
            let factor = libm::pow(LEAST / across, dimension as f64);
            let needed = libm::ceil(factor * placed.len() as f64);
            format!(
                "region {number} is {across:.1} spacings across, and what happens in it takes ten and more: \
                 use {needed} particles, or resolution.share = \"volume\""
            )
        })
    };
    let regions = scenario.regions.iter().enumerate();
    regions.filter_map(of_region).collect()
}

/// The width of a region where it ends before the domain does; `None` where it is all of it.
fn narrowest(scenario: &Scenario, region: &Region) -> Option<f64> {
    if let Some(Ball { radius, .. }) = region.ball {
        return Some(2.0 * radius);
    }
    let domain = &scenario.domain.extent;
    let ends = region.extent.lower.iter().zip(&region.extent.upper);
    let whole = domain.lower.iter().zip(&domain.upper);
    ends.zip(whole)
        .filter(|((lower, upper), (first, last))| lower > first || upper < last)
        .map(|((lower, upper), _)| upper - lower)
        .reduce(f64::min)
}

/// Lattices that do not go on in a mirror.
fn uneven_walls(scenario: &Scenario) -> Option<String> {
    let name = match scenario.resolution.arrangement {
        Arrangement::Hexagonal => "hexagonal",
        Arrangement::ClosePacked => "close-packed",
        _ => return None,
    };
    let is_mirror = |sides: &[Side; 2]| sides.contains(&Side::Mirror);
    scenario.domain.sides.iter().any(is_mirror).then(|| {
        format!(
            "a {name} lattice does not go on as one behind a mirror: the density of its last rows is some \
             percent off, and they move; use resolution.arrangement = \"glass\", or a square or cubic lattice"
        )
    })
}

/// Lattices that a weight shears.
fn melting(scenario: &Scenario) -> Option<String> {
    let is_square = match scenario.resolution.arrangement {
        Arrangement::Square | Arrangement::Cubic => true,
        Arrangement::EqualMass => scenario.profile.is_none(),
        _ => false,
    };
    // Along a period everything falls together, and nothing bears a weight.
    let mut directions = scenario.acceleration.iter().zip(&scenario.domain.sides);
    let is_heavy =
        directions.any(|(&component, sides)| component != 0.0 && *sides != [Side::Periodic; 2]);
    (is_square && is_heavy && scenario.dimension > 1).then(|| {
        "a square or cubic lattice gives way under a weight: its rows slip and it melts, with velocities \
         of a percent of the speed of sound; use resolution.arrangement = \"glass\""
            .to_owned()
    })
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::scenario::Source;
    use crate::setup::particles;

    pub(in crate::families::gas) fn told(name: &str, changes: &[&str]) -> String {
        let changes: Vec<String> = changes.iter().map(|change| (*change).to_owned()).collect();
        let scenario = Scenario::read(Source::from(name), &changes).unwrap();
        doubts(&scenario, &particles(&scenario).unwrap()).join("\n")
    }

    /// The thin side of Sod's tube has a ninth of the particles.
    #[test]
    fn a_region_of_few_spacings_is_told_with_what_it_takes() {
        let few = told("sod", &["resolution.particles=54"]);
        assert!(few.contains("region 1 is 6.0 spacings across"), "{few}");
        assert!(few.contains("use 90 particles"), "{few}");
        assert_eq!(told("sod", &["resolution.particles=90"]), "");
        // By volume both sides have half of them.
        let even = ["resolution.particles=54", "resolution.share=volume"];
        assert_eq!(told("sod", &even), "");
        // A ball of nine spacings, as wide as those around it; and of air in water.
        assert_eq!(told("wind-tunnel", &[]), "");
        let thin = ["region.1.density=0.1", "resolution.share=mass"];
        let ball = told("wind-tunnel", &thin);
        assert!(ball.contains("region 1 is"), "{ball}");
    }

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

    #[test]
    fn a_solution_of_other_equations_is_told() {
        let told = |changes: &[&str]| told("sod", changes);
        let viscous = told(&["diffusion.viscosity=0.001"]);
        assert!(
            viscous.contains("without [diffusion]: the errors"),
            "{viscous}"
        );
        let both = ["diffusion.heat=0.001", "force.acceleration=[1.0]"];
        assert!(told(&both).contains("without [diffusion] and [force]"));
        assert!(told(&["diffusion.viscosity=0"]).is_empty());
    }

    #[test]
    fn lattices_that_do_not_stay_are_told() {
        // It falls along a period, and has a solution of its own equations.
        assert_eq!(told("poiseuille", &[]), "");
        let walls = ["domain.sides=[\"mirror\", \"mirror\"]"];
        let lattice = |name: &str| format!("resolution.arrangement={name}");
        let (hexagonal, square) = (lattice("hexagonal"), lattice("square"));
        let told = |changes: &[&str]| told("sod2d", changes);
        let uneven = told(&[walls[0], &hexagonal]);
        assert!(uneven.contains("behind a mirror"), "{uneven}");
        assert!(!told(&[walls[0], &square]).contains("behind a mirror"));
        assert!(!told(&[&hexagonal]).contains("behind a mirror"));
        let weight = "force.acceleration=[0.0, -1.0]";
        let melting = told(&[walls[0], &square, weight]);
        assert!(melting.contains("gives way under a weight"), "{melting}");
        let glass = lattice("glass");
        assert!(!told(&[walls[0], &glass, weight]).contains("gives way"));
    }
}
