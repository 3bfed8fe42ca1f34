//! Boxes, balls and deposits.

use std::f64::consts::PI;

use super::super::regions::clipped;
use super::*;
use crate::scenario::{Ball, Extent};

/// The unit square of density 1, and what lies on it.
fn square_with(more: &str, resolution: &str) -> Scenario {
    let corners = "lower = [0.0, 0.0]\nupper = [1.0, 1.0]\n";
    let gas = format!(
        "[[region]]\n{corners}density = 1.0\nvelocity = [0.0, 0.0]\npressure = 1.0\n{more}{IDEAL}"
    );
    let domain = format!("{corners}sides = [\"mirror\", \"mirror\"]");
    scenario(&text(
        2,
        &domain,
        &gas,
        &format!("particles = 4000\n{resolution}"),
    ))
}

fn disc(density: f64) -> String {
    format!(
        "[[region]]\ncenter = [0.5, 0.5]\nradius = 0.25\ndensity = {density:?}\n\
         velocity = [3.0, 0.0]\npressure = 5.0\n"
    )
}

const MASS: &str = "arrangement = \"square\"";
const VOLUME: &str = "arrangement = \"square\"\nshare = \"volume\"";

fn in_disc(particle: &Placed) -> bool {
    let r = [particle.position[0] - 0.5, particle.position[1] - 0.5, 0.0];
    length(r) < 0.25
}

#[test]
fn clipped_balls_have_their_volumes() {
    let ball = |center: &[f64], radius| Ball {
        center: center.to_vec(),
        radius,
    };
    let cube = |dimension, lower, upper| Extent {
        lower: vec![lower; dimension],
        upper: vec![upper; dimension],
    };
    assert_eq!(clipped(&ball(&[0.0], 0.5), &cube(1, -0.25, 2.0)), 0.75);
    for (center, lower, expected) in [
        (vec![0.0; 2], -1.0, PI / 4.0),
        (vec![0.0; 2], 0.0, PI / 16.0),
        (vec![0.0; 3], -1.0, PI / 6.0),
        (vec![0.0; 3], 0.0, PI / 48.0),
    ] {
        let volume = clipped(&ball(&center, 0.5), &cube(center.len(), lower, 1.0));
        assert_near(volume, expected, 1e-4);
    }
    assert_eq!(clipped(&ball(&[2.0, 0.0], 0.5), &cube(2, -1.0, 1.0)), 0.0);
}

#[test]
fn a_ball_of_another_density_gets_a_lattice_of_its_own_and_nearly_equal_masses() {
    let particles = particles(&square_with(&disc(4.0), MASS)).unwrap();
    let inside: Vec<_> = particles.iter().copied().filter(in_disc).collect();
    assert!(
        inside
            .iter()
            .all(|p| p.density == 4.0 && p.velocity[0] == 3.0)
    );
    assert_near(mass(&inside), 4.0 * PI / 16.0, 1e-4);
    assert_near(particles.len() as f64, 4000.0, 0.05);
    let outside = particles.iter().find(|p| !in_disc(p)).unwrap();
    assert_near(inside[0].mass, outside.mass, 0.1);
    // The box's rest keeps its mass a particle, so its sum is off by the lattice points that
    // the circle cuts off wrongly.
    assert_near(mass(&particles), 1.0 + 3.0 * PI / 16.0, 0.01);
}

#[test]
fn a_ball_of_the_same_density_takes_over_the_particles_under_it() {
    let without = particles(&square_with("", MASS)).unwrap();
    let with = particles(&square_with(&disc(1.0), MASS)).unwrap();
    assert_eq!(with.len(), without.len());
    let mut changed = 0;
    for (a, b) in with.iter().zip(&without) {
        assert_eq!((a.position, a.mass), (b.position, b.mass));
        let expected = if in_disc(a) { (5.0, 3.0) } else { (1.0, 0.0) };
        assert_eq!((a.pressure, a.velocity[0]), expected);
        changed += u32::from(in_disc(a));
    }
    assert_near(f64::from(changed), 4000.0 * PI / 16.0, 0.02);
}

#[test]
fn with_equal_volumes_a_ball_changes_masses_and_no_place() {
    let without = particles(&square_with("", VOLUME)).unwrap();
    let with = particles(&square_with(&disc(4.0), VOLUME)).unwrap();
    for (a, b) in with.iter().zip(&without) {
        assert_eq!(a.position, b.position);
        let factor = if in_disc(a) { 4.0 } else { 1.0 };
        assert_near(a.mass, factor * b.mass, 1e-15);
    }
}

#[test]
fn later_balls_lie_on_earlier_ones() {
    let small = "[[region]]\ncenter = [0.5, 0.5]\nradius = 0.1\ndensity = 9.0\n\
                 velocity = [0.0, 0.0]\npressure = 5.0\n";
    let scenario = square_with(&format!("{}{small}", disc(4.0)), MASS);
    for particle in particles(&scenario).unwrap() {
        let r = length([particle.position[0] - 0.5, particle.position[1] - 0.5, 0.0]);
        let expected = if r < 0.1 {
            9.0
        } else if r < 0.25 {
            4.0
        } else {
            1.0
        };
        assert_eq!(particle.density, expected, "at {r}");
    }
}

#[test]
fn in_one_dimension_balls_cut_boxes_and_number_and_mass_stay_exact() {
    let gas = format!(
        "[[region]]\nlower = [0.0]\nupper = [1.0]\ndensity = 1.0\nvelocity = [0.0]\npressure = 1.0\n\
         [[region]]\ncenter = [0.5]\nradius = 0.25\ndensity = 3.0\nvelocity = [0.0]\npressure = 1.0\n\
         [[region]]\ncenter = [0.25]\nradius = 0.125\ndensity = 2.0\nvelocity = [0.0]\npressure = 1.0\n{IDEAL}"
    );
    let domain = "lower = [0.0]\nupper = [1.0]\nsides = [\"mirror\"]";
    for share in ["mass", "volume"] {
        let resolution =
            format!("particles = 333\narrangement = \"equal-mass\"\nshare = \"{share}\"");
        let particles = particles(&scenario(&text(1, domain, &gas, &resolution))).unwrap();
        assert_eq!(particles.len(), 333);
        // 0.125 + 0.25 of the box, 0.375 of the first ball, 0.25 of the second.
        assert_near(mass(&particles), 0.375 + 3.0 * 0.375 + 2.0 * 0.25, 1e-14);
        for particle in &particles {
            let x = particle.position[0];
            let expected = match x {
                _ if (x - 0.25).abs() < 0.125 => 2.0,
                _ if (x - 0.5).abs() < 0.25 => 3.0,
                _ => 1.0,
            };
            assert_eq!(particle.density, expected, "at {x}");
        }
    }
}

#[test]
fn a_region_below_half_a_particle_is_refused_by_its_number() {
    let corner = "[[region]]\ncenter = [0.5, 0.5]\nradius = 0.001\ndensity = 2.0\n\
                  velocity = [0.0, 0.0]\npressure = 1.0\n";
    let error = particles(&square_with(corner, MASS)).unwrap_err();
    assert!(
        matches!(error, SetupError::EmptyRegion { region: 1, .. }),
        "{error}"
    );
}

#[test]
fn a_deposit_adds_exactly_its_energy_in_the_shape_of_its_weight() {
    let deposit = "[[deposit]]\ncenter = [0.0, 0.0]\nradius = 0.2\nenergy = 7.0\n";
    let without = particles(&square_with("", MASS)).unwrap();
    let with = particles(&square_with(deposit, MASS)).unwrap();
    let added: Vec<f64> = (with.iter().zip(&without))
        .map(|(a, b)| a.mass * (a.energy - b.energy))
        .collect();
    assert_near(added.iter().sum(), 7.0, 1e-12);
    let weight = |p: &Placed| {
        let q = length(p.position) / 0.2;
        if q < 1.0 { (1.0 - q * q).powi(2) } else { 0.0 }
    };
    let scale = 7.0 / with.iter().map(weight).sum::<f64>();
    for (added, particle) in added.iter().zip(&with) {
        let expected = scale * weight(particle);
        assert!((added - expected).abs() < 1e-12, "{added} {expected}");
        assert_near(
            particle.pressure,
            0.4 * particle.density * particle.energy,
            1e-14,
        );
    }
}

#[test]
fn a_deposit_between_the_particles_is_refused() {
    let deposit = "[[deposit]]\ncenter = [0.508, 0.5]\nradius = 1e-4\nenergy = 7.0\n";
    let error = particles(&square_with(deposit, MASS)).unwrap_err();
    let SetupError::EmptyDeposit { nearest, .. } = error else {
        panic!("{error}");
    };
    assert!(nearest > 1e-4 && nearest < 0.02, "{nearest}");
}

#[test]
fn each_region_is_of_its_own_material() {
    let gas = "[[region]]\nlower = [0.0]\nupper = [0.5]\ndensity = 1000.0\nvelocity = [0.0]\nmaterial = \"water\"\n\
               [[region]]\nlower = [0.5]\nupper = [1.0]\ndensity = 1.0\nvelocity = [0.0]\npressure = 3.0\n\
               [[material]]\nname = \"air\"\nequation-of-state = \"stiffened-gas\"\ngamma = 2.0\npressure-at-infinity = 5.0\n\
               [[material]]\nname = \"water\"\nequation-of-state = \"isothermal\"\nsound-speed = 10.0\n";
    let domain = "lower = [0.0]\nupper = [1.0]\nsides = [\"mirror\"]";
    let resolution = "particles = 100\narrangement = \"equal-mass\"\nshare = \"volume\"";
    let particles = particles(&scenario(&text(1, domain, gas, resolution))).unwrap();
    let seen = |i: usize| {
        (
            particles[i].material,
            particles[i].pressure,
            particles[i].energy,
        )
    };
    assert_eq!(seen(0), (1, 1e5, 0.0));
    // e = (3 + 2 * 5) / (1 * 1).
    assert_eq!(seen(99), (0, 3.0, 13.0));
}
