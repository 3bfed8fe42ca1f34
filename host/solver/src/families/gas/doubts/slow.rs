//! Viscous flow at small Mach numbers.
//!
//! Particles under a mean pressure stand in one another's way: neighbours that stream past one another meet a
//! resistance that is a part of `ρ c²`, whatever the spacing, and where that is more than the viscous stress the flow
//! swings like an elastic solid and then melts.

use motes_core::cutoff::CutOff as _;

use crate::scenario::{Arrangement, Profile, Scenario, Side, ViscosityKind, fineness};
use crate::setup::Placed;

/// The Mach number below which pressure differences are small beside the pressure.
const SLOW: f64 = 0.3;

/// A mean pressure of so many `ρ u²`, u the largest velocity, is not felt: with 1.4 a decay rate is as good as
/// with none, with 11 it is 7 % off.
const FELT: f64 = 4.0;

/// Reach of the cut-off in spacings below which disorder is felt: at 3.2 viscous losses are 14 % too large, at 4
/// 5 %, at 6 less than 1 %.
const NARROW: f64 = 4.5;

/// What the particles are like at t = 0.
struct Regime {
    /// The largest difference of a velocity from the mean one.
    speed: f64,
    /// The largest that walls and an acceleration along periodic sides will bring about.
    driven: f64,
    sound_speed: f64,
    spacing: f64,
    /// Lowest and mean.
    pressures: [f64; 2],
    /// Mean.
    density: f64,
}

impl Regime {
    fn of(scenario: &Scenario, placed: &[Placed]) -> Self {
        let total = |of: &dyn Fn(&Placed) -> f64| placed.iter().map(of).sum::<f64>();
        let (mass, volume) = (total(&|p| p.mass), total(&|p| p.mass / p.density));
        let mean = [0, 1, 2].map(|i| total(&|p| p.mass * p.velocity[i]) / mass);
        let squared = |p: &Placed| {
            let apart = p.velocity.iter().zip(mean).map(|(u, mean)| u - mean);
            apart.map(|u| u * u).sum::<f64>()
        };
        let law = |p: &Placed| &scenario.materials[usize::from(p.material)].law;
        let sound = |p: &Placed| law(p).sound_speed_squared(p.density, p.energy);
        let pressure = |p: &Placed| law(p).pressure(p.density, p.energy);
        let largest = |of: &dyn Fn(&Placed) -> f64| placed.iter().map(of).fold(0.0, f64::max);
        Self {
            speed: largest(&squared).sqrt(),
            driven: driven(scenario, mean),
            sound_speed: largest(&sound).sqrt(),
            spacing: libm::pow(
                volume / placed.len().max(1) as f64,
                1.0 / scenario.dimension as f64,
            ),
            pressures: [
                placed.iter().map(pressure).fold(f64::INFINITY, f64::min),
                total(&|p| pressure(p) * (p.mass / p.density)) / volume,
            ],
            density: mass / volume,
        }
    }
}

/// The largest difference from a velocity that walls move with, or that an acceleration along periodic sides
/// reaches, `a t`, at most the `a h²/(8 ν)` of Poiseuille between walls at a distance of h.
fn driven(scenario: &Scenario, mean: [f64; 3]) -> f64 {
    let apart = |wall: &Vec<f64>| {
        let squares = wall
            .iter()
            .zip(mean)
            .map(|(u, mean)| (u - mean) * (u - mean));
        squares.sum::<f64>().sqrt()
    };
    let walls = scenario.walls.iter().flatten().flatten().map(apart);
    let extent = &scenario.domain.extent;
    let widths = scenario
        .walls
        .iter()
        .enumerate()
        .filter(|(_, ends)| ends.iter().all(Option::is_some));
    let width = widths
        .map(|(axis, _)| extent.upper[axis] - extent.lower[axis])
        .fold(f64::INFINITY, f64::min);
    let until = scenario
        .time
        .end
        .min(width * width / (8.0 * scenario.diffusion.viscosity));
    let along = scenario.acceleration.iter().zip(&scenario.domain.sides);
    let pulled = along.filter(|(_, sides)| sides.contains(&Side::Periodic));
    let pulled = pulled.map(|(component, _)| component.abs() * until);
    walls.chain(pulled).fold(0.0, f64::max)
}

/// Slow viscous flow that particles resist like a solid.
pub(super) fn solid(scenario: &Scenario, placed: &[Placed]) -> Option<String> {
    let is_wave = matches!(scenario.profile, Some(Profile::SoundWave { .. }));
    if scenario.dimension == 1 || is_wave || !(scenario.diffusion.viscosity > 0.0) {
        return None;
    }
    let start = Regime::of(scenario, placed);
    let speed = start.speed.max(start.driven);
    let mach = speed / start.sound_speed;
    // Where particles stay beside their neighbours nothing melts.
    let passes = speed * scenario.time.end > start.spacing;
    if !(mach < SLOW && passes) {
        return None;
    }
    let mut cures = Vec::new();
    let [lowest, mean] = start.pressures;
    let felt = FELT * start.density * speed * speed;
    let is_closed = |side: &Side| matches!(side, Side::Periodic | Side::Mirror);
    let sides = || scenario.domain.sides.iter().flatten();
    if mean - scenario.background > felt && sides().all(is_closed) {
        // In round numbers, to a quarter of what may stay.
        let digits = libm::floor(libm::log10(0.25 * felt));
        let step = libm::pow(10.0, digits);
        let background = libm::floor(lowest / step) * step;
        let places = (-digits).max(0.0) as usize;
        cures.push(format!("force.background = {background:.places$}"));
    }
    // Rows that walls shear stay rows, unless pressure makes a solid of them.
    if cures.is_empty() && start.driven > start.speed {
        return None;
    }
    let cut_off = &scenario.cut_off;
    let fineness = fineness(placed.len(), scenario.dimension);
    let epsilon = cut_off.width.epsilon(start.spacing, fineness) / start.spacing;
    if epsilon * f64::from(cut_off.shape.support()) < NARROW {
        cures.push("cut-off.name = \"wendland-c2\" with cut-off.eta = 3".to_owned());
    }
    let arrangement = &scenario.resolution.arrangement;
    if !matches!(arrangement, Arrangement::Glass | Arrangement::File(_)) {
        cures.push("resolution.arrangement = \"glass\"".to_owned());
    }
    let viscosity = &scenario.viscosity;
    let is_spared = viscosity.switch.is_some() || viscosity.kind == ViscosityKind::Limited;
    if viscosity.alpha > 0.0 && !is_spared {
        cures.push("viscosity.kind = \"none\" where there is no shock".to_owned());
    }
    if cures.is_empty() {
        return None;
    }
    if matches!(arrangement, Arrangement::File(_)) {
        cures.push("particles that begin as a glass, not as a lattice".to_owned());
    }
    let last = cures.pop()?;
    let cures = match cures.is_empty() {
        true => last,
        false => format!("{} and {last}", cures.join(", ")),
    };
    Some(format!(
        "viscous flow at Mach {mach:.2}: particles resist one another like a solid, which swings and melts, and \
         the flow loses its energy too fast at any resolution; use {cures}"
    ))
}

/// A background that more of the gas is below than above: it pulls.
pub(super) fn pulled(scenario: &Scenario, placed: &[Placed]) -> Option<String> {
    let background = scenario.background;
    if !(background > 0.0) {
        return None;
    }
    let [lowest, mean] = Regime::of(scenario, placed).pressures;
    (background > mean).then(|| {
        format!(
            "force.background = {background} is above the mean pressure, {mean:.6}: what is left pulls particles \
             together; use the lowest pressure, {lowest:.6}"
        )
    })
}

#[cfg(test)]
mod tests {
    use crate::families::gas::doubts::tests::told;

    const FEW: &str = "resolution.particles=1024";

    /// The defaults of a file that does not say, one cure after the other.
    #[test]
    fn slow_viscous_flow_is_told_until_it_is_cured() {
        let worst = [
            "resolution.arrangement=square",
            "force.background=0",
            "cut-off.eta=0.65",
            "viscosity.kind=pairwise",
        ];
        let told = |changes: &[&str]| told("taylor-green", &[&[FEW], changes].concat());
        let all = told(&worst);
        assert!(all.starts_with("viscous flow at Mach 0.10"), "{all}");
        // The lowest pressure is 70.93.
        for cure in [
            "force.background = 70.9",
            "eta = 3",
            "\"glass\"",
            "\"none\"",
        ] {
            assert!(all.contains(cure), "{cure}: {all}");
        }
        let narrow = told(&["cut-off.eta=0.65"]);
        assert!(
            narrow.ends_with("use cut-off.name = \"wendland-c2\" with cut-off.eta = 3"),
            "{narrow}"
        );
        assert_eq!(told(&[]), "");
    }

    #[test]
    fn what_does_not_melt_is_not_told() {
        let told = |name: &str, changes: &[&str]| {
            let all = told(name, &[&[FEW, "force.background=0"], changes].concat());
            all.contains("like a solid")
        };
        assert!(told("taylor-green", &[]));
        // Over before a particle has moved by a spacing; without viscosity; fast.
        assert!(!told("taylor-green", &["time.end=0.01"]));
        assert!(!told("taylor-green", &["diffusion.viscosity=0"]));
        assert!(!told("taylor-green", &["profile.pressure=5"]));
        let viscous = "diffusion.viscosity=0.01";
        assert!(!told("gresho", &[viscous]));
        assert!(told("gresho", &[viscous, "profile.mach=0.1"]));
    }

    /// Couette's flow of a gas under a pressure of `ρ c²/2`, and Poiseuille's, lose their shape to it; without
    /// pressure, or without a wall that moves, nothing does.
    #[test]
    fn gas_under_pressure_that_walls_drive_is_told() {
        let under_pressure = "material.density=0.5";
        for name in ["couette", "poiseuille"] {
            let solid = told(name, &[under_pressure]);
            assert!(
                solid.contains("use force.background = 50"),
                "{name}: {solid}"
            );
            assert_eq!(told(name, &[]), "", "{name}");
        }
        let still = [under_pressure, "wall.1.velocity=[0.0, 0.0]"];
        assert_eq!(told("couette", &still), "");
        assert_eq!(
            told(
                "poiseuille",
                &[under_pressure, "force.acceleration=[0.0, 0.0]"]
            ),
            ""
        );
    }

    #[test]
    fn a_background_above_the_pressure_is_told() {
        let high = told("taylor-green", &[FEW, "force.background=72"]);
        assert!(high.contains("above the mean pressure, 71.428"), "{high}");
        assert!(high.contains("70.9"), "{high}");
    }
}
