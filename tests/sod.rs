//! Sod's shock tube against the exact Riemann solution, in every scalar.

mod runs;

use runs::run;

/// The bounds of the default run: what was asked for above, and 10 % below what is reached,
/// so that a change for the better is noticed too.
const DEFAULT_BOUNDS: [(&str, f64, f64); 3] = [
    ("density", 0.0025, 0.0028),
    ("velocity", 0.0072, 0.0080),
    ("pressure", 0.0029, 0.0033),
];

#[test]
fn the_default_run_reaches_its_accuracy() {
    let sod = run("sod", "f64", 1, &[]);
    assert_eq!(sod.outcome.particles, 900);
    for (field, lower, upper) in DEFAULT_BOUNDS {
        let l1 = sod.l1(field);
        assert!(
            (lower..=upper).contains(&l1),
            "{field}: L1 {l1}, expected {lower} to {upper}"
        );
    }
    // The walls are beyond the reach of the waves: the gas keeps its energy up to the
    // leap-frog's own error, and its momentum is what the walls gave it.
    let (outcome, drift) = (&sod.outcome, &sod.outcome.drift);
    assert_eq!(outcome.drift_of("mass"), 0.0);
    assert!(outcome.drift_of("energy").abs() < 5e-6, "{drift:?}");
    let walls = (1.0 - 0.1) * 0.2 / (1.125 * 1.4f64.sqrt());
    assert!(
        (outcome.drift_of("momentum") - walls).abs() < 1e-4 * walls,
        "{drift:?}, walls give {walls}"
    );
    assert_eq!(sod.warnings(), [""; 0]);
}

/// How much of the f64 error other scalars may add: f32 and the fixed-point formats by their
/// rounding, as measured in the trial of the design.
const SCALARS: [(&str, f64); 4] = [
    ("f32", 0.01),
    ("q12.19", 0.03),
    ("q31.32", 0.001),
    ("q15.16", 0.2),
];

#[test]
fn other_scalars_are_as_accurate() {
    let reference = run("sod", "f64", 1, &[]);
    for (scalar, part) in SCALARS {
        let sod = run("sod", scalar, 1, &[]);
        assert_ne!(sod.outcome.digest, reference.outcome.digest);
        for (field, ..) in DEFAULT_BOUNDS {
            let (l1, expected) = (sod.l1(field), reference.l1(field));
            let off = (l1 / expected - 1.0).abs();
            assert!(off <= part, "{scalar} {field}: L1 {l1}, in f64 {expected}");
        }
    }
}

#[test]
fn approximate_roots_cost_accuracy_but_not_the_solution() {
    let density = run("sod", "micromath", 1, &[]).l1("density");
    assert!((0.005..0.02).contains(&density), "{density}");
}

#[test]
fn every_viscosity_solves_the_tube() {
    let bounds = [
        ("von_neumann", 0.0034, 0.0040),
        ("gingold_monaghan", 0.0025, 0.0028),
    ];
    for (kind, lower, upper) in bounds {
        let density = run("sod", "f64", 1, &[&format!("viscosity.kind={kind}")]).l1("density");
        assert!((lower..=upper).contains(&density), "{kind}: {density}");
    }
}

#[test]
fn every_cut_off_solves_the_tube() {
    let cut_offs = [
        ("quintic-spline", 1.2, 0.0042),
        ("wendland-c2", 1.2, 0.0045),
        ("wendland-c4", 1.4, 0.0045),
        ("wendland-c6", 1.6, 0.0045),
        ("root-free", 2.4, 0.0040),
    ];
    for (name, eta, bound) in cut_offs {
        let changes = [format!("cut-off.name={name}"), format!("cut-off.eta={eta}")];
        let density = run("sod", "f64", 1, &changes.each_ref().map(String::as_str)).l1("density");
        assert!((0.003..bound).contains(&density), "{name}: {density}");
    }
}

/// Shocks and contacts are smeared over a fixed number of particles: first order.
#[test]
fn refinement_is_of_first_order() {
    let sizes = [225u32, 450, 900, 1800];
    let errors: Vec<f64> = sizes
        .iter()
        .map(|n| run("sod", "f64", 1, &[&format!("resolution.particles={n}")]).l1("density"))
        .collect();
    // Least squares through ln(error) against ln(n).
    let x: Vec<f64> = sizes.iter().map(|&n| f64::from(n).ln()).collect();
    let y: Vec<f64> = errors.iter().map(|error| error.ln()).collect();
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (mx, my) = (mean(&x), mean(&y));
    let covariance: f64 = x.iter().zip(&y).map(|(x, y)| (x - mx) * (y - my)).sum();
    let variance: f64 = x.iter().map(|x| (x - mx) * (x - mx)).sum();
    let order = -covariance / variance;
    assert!(
        (0.8..=1.1).contains(&order),
        "order {order} expected 0.8 to 1.1 from {errors:?}"
    );
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    // Large enough that every thread has work of its own.
    let changes = ["resolution.particles=7200", "time.end=0.005"];
    for scalar in ["f64", "f32", "q15.16"] {
        let one = run("sod", scalar, 1, &changes).outcome.digest;
        for threads in [2, 3, 7] {
            let digest = run("sod", scalar, threads, &changes).outcome.digest;
            assert_eq!(digest, one, "{scalar}, {threads} threads");
        }
    }
}

/// A constant ε that the thin gas outgrows: spacing 0.01, support 0.013. First a particle is
/// left with one neighbour, and the run says so; in a faster expansion with none, and it stops.
#[test]
fn a_gas_that_outgrows_a_constant_epsilon_is_noticed() {
    let slow = run(
        "sod",
        "f64",
        1,
        &["cut-off.epsilon=0.0065", "region.1.velocity=[2.0]"],
    );
    // "particle 17 had 1 neighbour(s) at t = 0.1: ..."
    let warnings = slow.warnings().join(" ");
    let (lonely, time) = warnings.split_once(" neighbour(s) at t = ").unwrap();
    let time: f64 = time.split(':').next().unwrap().parse().unwrap();
    let is_one = lonely.ends_with(" had 1");
    assert!(time > 0.0 && time < 0.2 && is_one, "{warnings}");

    let error = runs::try_run(
        "sod",
        "f64",
        1,
        &["cut-off.epsilon=0.0065", "region.1.velocity=[4.0]"],
    );
    let text = error.err().unwrap().to_string();
    assert!(text.contains("sees no neighbour"), "{text}");
}
