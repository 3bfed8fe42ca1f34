//! Profiles: their states, and particles as dense as they are.

use std::f64::consts::PI;

use super::*;

fn domain(lower: &[f64], upper: &[f64]) -> String {
    let sides = vec!["periodic"; lower.len()];
    format!("lower = {lower:?}\nupper = {upper:?}\nsides = {sides:?}")
}

fn with_profile(dimension: usize, domain: &str, profile: &str, resolution: &str) -> Vec<Placed> {
    let gas = format!("[profile]\n{profile}\n{IDEAL}");
    particles(&scenario(&text(dimension, domain, &gas, resolution))).unwrap()
}

#[test]
fn noh_falls_onto_the_origin_with_one_speed() {
    let profile = "kind = \"noh\"\ndensity = 1.0\nspeed = 2.0\npressure = 1e-6";
    for dimension in [1, 2, 3] {
        let domain = domain(&vec![-1.0; dimension], &vec![1.0; dimension]);
        let resolution = "particles = 1000\narrangement = \"equal-mass\"";
        for particle in with_profile(dimension, &domain, profile, resolution) {
            let (x, u) = (particle.position, particle.velocity);
            let dot: f64 = (0..3).map(|i| x[i] * u[i]).sum();
            assert_near(length(u), 2.0, 1e-15);
            assert_near(dot, -2.0 * length(x), 1e-14);
        }
    }
}

#[test]
fn a_sound_wave_is_sampled_as_dense_as_it_is_down_to_small_amplitudes() {
    for (amplitude, arrangement) in [(0.3, "equal-mass"), (1e-6, "sampled"), (1e-6, "equal-mass")] {
        let profile = format!(
            "kind = \"sound-wave\"\namplitude = {amplitude:?}\ndensity = 2.0\npressure = 0.5"
        );
        let resolution = format!("particles = 500\narrangement = \"{arrangement}\"");
        let particles = with_profile(1, &domain(&[-1.0], &[3.0]), &profile, &resolution);
        assert_eq!(particles.len(), 500);
        assert_near(mass(&particles), 8.0, 1e-12);
        for three in particles.windows(3) {
            let spaced = 2.0 * three[1].mass / (three[2].position[0] - three[0].position[0]);
            let wave = amplitude * (2.0 * PI * three[1].position[0] / 4.0).sin();
            // The mean over two spacings, off the value by (2 pi/500)^2/6 of the wave.
            let off = (spaced / 2.0 - 1.0 - wave).abs() / amplitude;
            assert!(off < 2e-4, "{off:e} at {:?}", three[1].position);
            let sound = (1.4f64 * 0.5 / 2.0).sqrt();
            // A simple wave: one entropy, one invariant.
            let speed = 5.0 * sound * ((1.0 + wave).powf(0.2) - 1.0);
            assert!((three[1].velocity[0] - speed).abs() < 1e-14);
            let pressure = 0.5 * (1.0 + wave).powf(1.4);
            assert_near(three[1].pressure, pressure, 1e-14);
            assert_near(three[1].energy, pressure / (0.4 * three[1].density), 1e-14);
        }
    }
}

#[test]
fn more_particles_than_cells_of_the_quadrature_see_no_stairs() {
    let profile = "kind = \"sound-wave\"\namplitude = 0.3\ndensity = 1.0\npressure = 1.0";
    let resolution = "particles = 40000\narrangement = \"sampled\"";
    let particles = with_profile(1, &domain(&[0.0], &[1.0]), profile, resolution);
    for three in particles.windows(3) {
        let spaced = 2.0 * three[1].mass / (three[2].position[0] - three[0].position[0]);
        // Stairs of 16384 cells would be off by 2 pi/16384/2 of the amplitude: 6e-5.
        assert_near(spaced, three[1].density, 1e-6);
    }
}

#[test]
fn equal_volumes_carry_the_wave_in_their_masses() {
    let profile = "kind = \"sound-wave\"\namplitude = 0.1\ndensity = 1.0\npressure = 1.0";
    let resolution = "particles = 64\narrangement = \"equal-mass\"\nshare = \"volume\"";
    let particles = with_profile(1, &domain(&[0.0], &[1.0]), profile, resolution);
    for (k, particle) in particles.iter().enumerate() {
        assert_eq!(particle.position[0], (k as f64 + 0.5) / 64.0);
        assert_near(particle.mass, particle.density / 64.0, 1e-15);
    }
}

/// Mass within `radius` of the origin.
fn mass_within(particles: &[Placed], radius: f64) -> f64 {
    let inside = |p: &&Placed| length(p.position) < radius;
    particles.iter().filter(inside).map(|p| p.mass).sum()
}

#[test]
fn a_vortex_is_sampled_as_dense_as_it_is() {
    let profile = "kind = \"yee-vortex\"\nstrength = 5.0";
    let resolution = "particles = 10000\narrangement = \"sampled\"";
    let domain = domain(&[-3.0, -3.0], &[3.0, 3.0]);
    let particles = with_profile(2, &domain, profile, resolution);
    assert_eq!(particles.len(), 10_000);
    assert!(particles.iter().all(|p| p.mass == particles[0].mass));
    // The integral of rho 2 pi r dr by the midpoint rule.
    let density = |r: f64| {
        let factor = 0.4 * 25.0 / (8.0 * 1.4 * PI * PI);
        (1.0 - factor * (1.0 - r * r).exp()).powf(2.5)
    };
    for radius in [0.5, 1.0, 2.0] {
        let n = 1000;
        let ring = |i: i32| {
            let r = radius * (f64::from(i) + 0.5) / f64::from(n);
            density(r) * 2.0 * PI * r * radius / f64::from(n)
        };
        let expected: f64 = (0..n).map(ring).sum();
        // The circle cuts the cells of its edge at random: a few in the number inside.
        assert_near(mass_within(&particles, radius), expected, 0.02);
    }
    // A uniform lattice would be off by far: the test can fail.
    assert!(density(0.0) < 0.55, "{}", density(0.0));
}

#[test]
fn a_wave_in_three_dimensions_is_even_across_it() {
    let profile = "kind = \"sound-wave\"\namplitude = 0.5\ndensity = 1.0\npressure = 1.0";
    let resolution = "particles = 4096\narrangement = \"sampled\"";
    let particles = with_profile(3, &domain(&[0.0; 3], &[1.0; 3]), profile, resolution);
    assert_eq!(particles.len(), 4096);
    let part = |i: usize, below: f64| {
        let inside = particles.iter().filter(|p| p.position[i] < below);
        inside.count() as f64 / 4096.0
    };
    assert_eq!((part(1, 0.25), part(2, 0.75)), (0.25, 0.75));
    // Integral of 1 + 0.5 sin(2 pi x) up to 1/2, in whole sheets of a sixteenth.
    assert!((part(0, 0.5) - (0.5 + 0.5 / PI)).abs() < 1.0 / 16.0);
}

/// Radial pressure gradient over the centrifugal force, from particles along x.
fn assert_balanced(profile: &str, drift: f64, radii: &[f64]) {
    for &r in radii {
        // Three particles 1e-4 apart, at r: a thin domain along x.
        let h = 1e-4;
        let domain = domain(&[r - 1.5 * h, -0.5 * h], &[r + 1.5 * h, 0.5 * h]);
        // Not periodic: the vortex would be repeated.
        let domain = domain.replace("periodic", "mirror");
        let resolution = "particles = 3\narrangement = \"square\"\nshare = \"volume\"";
        let three = with_profile(2, &domain, profile, resolution);
        let [a, b, c] = three.as_slice() else {
            panic!("{} particles", three.len());
        };
        let gradient = (c.pressure - a.pressure) / (c.position[0] - a.position[0]);
        assert_eq!(b.velocity[0], drift);
        let force = b.density * b.velocity[1] * b.velocity[1] / b.position[0];
        assert!(
            (gradient - force).abs() < 1e-5 * (1.0 + force),
            "at {r}: {gradient} {force}"
        );
    }
}

#[test]
fn the_pressure_of_the_vortices_balances_their_spin() {
    let radii = [0.05, 0.1, 0.25, 0.35, 0.5];
    assert_balanced("kind = \"gresho\"\nvelocity = [3.0, 0.0]", 3.0, &radii);
    assert_balanced("kind = \"gresho\"\nmach = 0.1", 0.0, &radii);
    assert_balanced("kind = \"yee-vortex\"\nstrength = 5.0", 0.0, &radii);
}

#[test]
fn gresho_turns_as_published_and_its_mach_number_sets_the_pressure() {
    let domain = domain(&[-0.5, -0.5], &[0.5, 0.5]);
    let resolution = "particles = 10000\narrangement = \"square\"";
    let mach = "kind = \"gresho\"\nmach = 0.5";
    let particles = with_profile(2, &domain, mach, resolution);
    let fastest = particles
        .iter()
        .map(|p| length(p.velocity))
        .fold(0.0, f64::max);
    // The peak, 1, lies at r = 0.2; a particle is at most 0.007 from it.
    assert!(fastest <= 1.0 && fastest > 0.99, "{fastest}");
    let innermost = particles
        .iter()
        .min_by(|a, b| length(a.position).total_cmp(&length(b.position)));
    // 12.5 r^2 = 6e-4 above the centre at the innermost particle.
    assert_near(innermost.unwrap().pressure, 1.0 / (1.4 * 0.25) - 0.5, 1e-3);
    let outside = particles.iter().filter(|p| length(p.position) > 0.4);
    assert!(outside.into_iter().all(|p| length(p.velocity) == 0.0));
}

#[test]
fn a_yee_vortex_has_one_entropy() {
    let resolution = "particles = 100\narrangement = \"square\"\nshare = \"volume\"";
    let domain = domain(&[-3.0, -3.0], &[3.0, 3.0]);
    for p in with_profile(
        2,
        &domain,
        "kind = \"yee-vortex\"\nstrength = 5.0",
        resolution,
    ) {
        assert_near(p.pressure / p.density.powf(1.4), 1.0, 1e-14);
    }
}

#[test]
fn kelvin_helmholtz_has_its_two_streams_without_jumps() {
    let resolution = "particles = 40000\narrangement = \"square\"\nshare = \"volume\"";
    let domain = domain(&[0.0, 0.0], &[1.0, 1.0]);
    let particles = with_profile(2, &domain, "kind = \"kelvin-helmholtz\"", resolution);
    // The first column: y from 0.0025 on in steps of 0.005.
    let column = &particles[..200];
    let state = |i: usize| (column[i].density, column[i].velocity[0]);
    let near = |i: usize, density: f64, velocity: f64| {
        let (rho, u) = state(i);
        assert!(
            (rho - density).abs() < 0.01 && (u - velocity).abs() < 0.01,
            "{rho} {u}"
        );
    };
    near(0, 1.0, 0.5);
    near(100, 2.0, -0.5);
    near(199, 1.0, 0.5);
    for pair in column.windows(2) {
        // 1/(2L) a length at most: 0.1 a particle.
        assert!((pair[0].density - pair[1].density).abs() < 0.101);
        assert!((pair[0].velocity[0] - pair[1].velocity[0]).abs() < 0.101);
    }
    for p in &particles {
        let expected = 0.01 * (4.0 * PI * p.position[0]).sin();
        assert!((p.velocity[1] - expected).abs() < 1e-15 && p.pressure == 2.5);
    }
}
