//! Lattices: their number, their mass, their neighbours, also across periodic sides.

use super::*;

#[test]
fn one_dimension_gets_exactly_the_particles_asked_for_in_equal_cells() {
    for asked in [9, 137, 900, 901] {
        let sod = Scenario::read(
            Source::from("sod"),
            &[format!("resolution.particles={asked}")],
        );
        let particles = particles(&sod.unwrap()).unwrap();
        assert_eq!(particles.len(), asked);
        // Rounding of 900 additions.
        assert_near(mass(&particles), 1.125, 1e-13);
    }
    let sod = Scenario::read(Source::from("sod"), &[]).unwrap();
    let particles = particles(&sod).unwrap();
    for (k, particle) in particles.iter().take(800).enumerate() {
        let middle = -1.0 + 1.0 / 800.0 * (k as f64 + 0.5);
        assert_eq!(particle.position, [middle, 0.0, 0.0]);
        assert_eq!((particle.density, particle.pressure), (1.0, 1.0));
        assert_near(particle.energy, 2.5, 1e-15);
        assert_near(particle.mass, 1.0 / 800.0, 1e-15);
    }
    // The right gas: 100 of an eighth of the density, each of the same mass.
    assert_near(particles[800].mass, 1.0 / 800.0, 1e-15);
    assert_near(particles[899].energy, 0.1 / 0.4 / 0.125, 1e-15);
}

/// Arrangement, dimension, neighbours of a particle, their distance for one particle in a
/// unit volume.
fn lattices() -> [(&'static str, usize, usize, f64); 6] {
    [
        ("arrangement = \"square\"", 2, 4, 1.0),
        ("arrangement = \"square\"\nrotation = [1, 2]", 2, 4, 1.0),
        ("arrangement = \"equal-mass\"\nrotation = [3, 2]", 2, 4, 1.0),
        (
            "arrangement = \"hexagonal\"",
            2,
            6,
            (2.0 / 3f64.sqrt()).sqrt(),
        ),
        ("arrangement = \"cubic\"", 3, 6, 1.0),
        (
            "arrangement = \"close-packed\"",
            3,
            12,
            2f64.powf(1.0 / 6.0),
        ),
    ]
}

#[test]
fn lattices_hold_the_mass_and_about_the_number_asked_for() {
    for (arrangement, dimension, _, _) in lattices() {
        for asked in [700, 1000] {
            for side in ["periodic", "mirror"] {
                if arrangement.contains("rotation") && side == "mirror" {
                    continue;
                }
                let resolution = format!("particles = {asked}\n{arrangement}");
                let particles = particles(&unit_box(dimension, side, &resolution)).unwrap();
                assert_near(mass(&particles), 2.0, 1e-13);
                // Rounding each direction to whole spacings, layers in pairs.
                assert_near(particles.len() as f64, f64::from(asked), 0.25);
                let inside = |x: &f64| (0.0..=1.0).contains(x);
                assert!(particles.iter().all(|p| p.position.iter().all(inside)));
            }
        }
    }
}

#[test]
fn every_particle_has_the_neighbours_of_its_lattice_across_periodic_sides_too() {
    for (arrangement, dimension, neighbours, distance) in lattices() {
        let resolution = format!("particles = 1000\n{arrangement}");
        let particles = particles(&unit_box(dimension, "periodic", &resolution)).unwrap();
        let n = particles.len() as f64;
        let distance = distance * n.powf(-1.0 / dimension as f64);
        for a in &particles {
            let near = particles.iter().filter(|b| {
                let r = length(shortest(&a.position, &b.position));
                // The stretch to whole spacings; the next shell is 1.41 away.
                assert!(r == 0.0 || r > 0.9 * distance, "{arrangement}: {r}");
                r > 0.0 && r < 1.12 * distance
            });
            assert_eq!(
                near.count(),
                neighbours,
                "{arrangement} at {:?}",
                a.position
            );
        }
    }
}

#[test]
fn a_turned_lattice_is_turned_by_the_angle_asked_for() {
    // 10 * 10 periods of 5 particles: no stretch.
    let resolution = "particles = 500\narrangement = \"square\"\nrotation = [1, 2]";
    let particles = particles(&unit_box(2, "periodic", resolution)).unwrap();
    assert_eq!(particles.len(), 500);
    let spacing = (1.0 / 500.0f64).sqrt();
    let step = [2.0, 1.0].map(|part: f64| spacing * part / 5f64.sqrt());
    let expected = [
        particles[0].position[0] + step[0],
        particles[0].position[1] + step[1],
        0.0,
    ];
    let found = particles
        .iter()
        .any(|p| length(shortest(&p.position, &expected)) < 1e-12);
    assert!(found, "nobody at {expected:?}");
}

#[test]
fn the_last_direction_runs_fastest() {
    let resolution = "particles = 27\narrangement = \"cubic\"";
    let particles = particles(&unit_box(3, "mirror", resolution)).unwrap();
    let ids: Vec<_> = (particles.iter())
        .map(|p| p.position.map(|x| (3.0 * x).floor() as usize))
        .collect();
    for (id, place) in ids.iter().enumerate() {
        assert_eq!(*place, [id / 9, id / 3 % 3, id % 3]);
    }
}

#[test]
fn jitter_moves_by_at_most_its_fraction_and_the_seed_decides_where() {
    let with = |extra: &str| {
        let resolution = format!("particles = 400\narrangement = \"square\"\n{extra}");
        particles(&unit_box(2, "mirror", &resolution)).unwrap()
    };
    let (still, moved) = (with(""), with("jitter = 0.25"));
    let mut largest: f64 = 0.0;
    for (a, b) in still.iter().zip(&moved) {
        for i in 0..2 {
            largest = largest.max((a.position[i] - b.position[i]).abs() * 20.0);
        }
        assert_eq!(a.mass, b.mass);
    }
    // 800 numbers: the largest is within a few 800ths of the end of the interval.
    assert!((0.24..=0.25 + 1e-12).contains(&largest), "{largest}");
    assert_eq!(moved, with("jitter = 0.25\nseed = 1"));
    assert_ne!(moved, with("jitter = 0.25\nseed = 2"));
}

#[test]
fn a_lattice_in_the_corner_is_the_same_lattice_moved_onto_the_lower_faces() {
    for (arrangement, dimension, _, _) in lattices() {
        let with = |extra: &str| {
            let resolution = format!("particles = 500\n{arrangement}\n{extra}");
            particles(&unit_box(dimension, "periodic", &resolution)).unwrap()
        };
        let (middle, corner) = (with(""), with("anchor = \"corner\""));
        assert_eq!(middle.len(), corner.len());
        for i in 0..dimension {
            let lowest = |cloud: &[Placed]| {
                (cloud.iter().map(|p| p.position[i])).fold(f64::INFINITY, f64::min)
            };
            assert_eq!(lowest(&corner), 0.0, "{arrangement}");
            let gap = lowest(&middle);
            assert!(gap > 0.0, "{arrangement}");
            for (a, b) in middle.iter().zip(&corner) {
                // Relative to the gap, a hundredth of the positions.
                assert_near(a.position[i] - b.position[i], gap, 1e-13);
                assert_eq!(a.mass, b.mass);
            }
        }
    }
}

#[test]
fn a_turned_lattice_that_does_not_fit_is_refused() {
    let resolution = "particles = 10\narrangement = \"square\"\nrotation = [7, 8]";
    let error = particles(&unit_box(2, "periodic", resolution)).unwrap_err();
    assert!(
        matches!(error, SetupError::Rotation { cell: 113, .. }),
        "{error}"
    );
}

/// The shape of a box alone may ask for more particles than there is memory: it is refused before.
#[test]
fn a_box_thinner_than_the_spacing_is_refused_and_not_filled_without_end() {
    let flat = |dimension: usize, resolution: &str, gas: &str| {
        let corners = match dimension {
            2 => "lower = [0.0, 0.0]\nupper = [1.0, 3e13]",
            _ => "lower = [0.0, 0.0, 0.0]\nupper = [1e9, 1.0, 1e9]",
        };
        let sides = format!("{corners}\nsides = {:?}", vec!["mirror"; dimension]);
        let velocity = vec![0.0; dimension];
        let gas = gas.replace("BOX", corners);
        let gas = gas.replace(
            "STATE",
            &format!("density = 2.0\nvelocity = {velocity:?}\npressure = 1.0"),
        );
        let text = text(
            dimension,
            &sides,
            &gas,
            &format!("particles = 90\n{resolution}"),
        );
        match particles(&scenario(&text)) {
            Err(error) => error.to_string(),
            Ok(particles) => panic!("{} particles: {resolution}", particles.len()),
        }
    };
    let boxed = format!("[[region]]\nBOX\nSTATE\n{IDEAL}");
    for (arrangement, dimension, ..) in lattices() {
        // Turned lattices are for periodic sides.
        if !arrangement.contains("rotation") {
            let error = flat(dimension, arrangement, &boxed);
            assert!(
                error.contains("thinner than their spacing"),
                "{arrangement}: {error}"
            );
        }
    }
    let glass = flat(2, "arrangement = \"glass\"", &boxed);
    assert!(glass.contains("thinner"), "{glass}");
    let profile =
        format!("[profile]\nkind = \"noh\"\ndensity = 1.0\nspeed = 1.0\npressure = 1e-6\n{IDEAL}");
    let sampled = flat(2, "arrangement = \"sampled\"", &profile);
    assert!(sampled.contains("thinner"), "{sampled}");
}

/// A thin box of which the lattice has no more than twice the particles is none of those.
#[test]
fn a_box_of_a_few_spacings_is_filled() {
    let sides = "lower = [0.0, 0.0]\nupper = [30.0, 1.0]\nsides = [\"mirror\", \"mirror\"]";
    let gas = format!(
        "[[region]]\nlower = [0.0, 0.0]\nupper = [30.0, 1.0]\ndensity = 2.0\nvelocity = [0.0, 0.0]\n\
         pressure = 1.0\n{IDEAL}"
    );
    let text = text(2, sides, &gas, "particles = 30\narrangement = \"square\"");
    assert_eq!(particles(&scenario(&text)).unwrap().len(), 30);
}

/// A ball far larger than the domain would have a lattice as large as itself.
#[test]
fn a_ball_that_leaves_the_domain_far_behind_is_refused() {
    let sides = "lower = [0.0, 0.0]\nupper = [1.0, 1.0]\nsides = [\"mirror\", \"mirror\"]";
    let state = "velocity = [0.0, 0.0]\npressure = 1.0";
    let gas = format!(
        "[[region]]\nlower = [0.0, 0.0]\nupper = [1.0, 1.0]\ndensity = 2.0\n{state}\n\
         [[region]]\ncenter = [0.5, 0.5]\nradius = 1e9\ndensity = 9.0\n{state}\n{IDEAL}"
    );
    let text = text(2, sides, &gas, "particles = 200\narrangement = \"square\"");
    assert!(matches!(
        particles(&scenario(&text)),
        Err(SetupError::Flat { .. })
    ));
}
