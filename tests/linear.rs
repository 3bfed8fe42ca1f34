//! The linear systems as they are shipped: accuracy in f64 and f32, the same bits on any number of
//! threads, sums, growth, and what is refused.

mod systems;

use motes::engine::Threads;
use motes::experiment::Experiment;
use motes::families::{Plan, strengths};
use motes::run::{Control, RunError};
use motes::scenario::linear::LinearScenario;
use motes::scenario::{AnyScenario, Norm, Source};
use systems::{
    assert_same_bits, assert_tolerances, built_in, errors, experiment, run, scenario, stopped,
};

fn plan(scenario: &LinearScenario) -> strengths::Plan {
    match Plan::new(&AnyScenario::Linear(Box::new(scenario.clone()))).unwrap() {
        Plan::Strengths(plan) => *plan,
        Plan::Gas(_) => panic!("a gas"),
    }
}

#[test]
fn every_system_keeps_its_tolerance_in_f64_and_f32() {
    let all = built_in(false);
    assert_eq!(all.len(), 15);
    for scenario in &all {
        assert_tolerances(scenario);
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for scenario in &built_in(false) {
        assert_same_bits(scenario, &["resolution.particles=900", "time.end=0.05"]);
    }
}

/// The velocity field that particles follow is free: the solution is the same, and the error of
/// the same size.
#[test]
fn the_motion_of_the_particles_is_free() {
    let still = errors("acoustics1d", "f64", &["motion.kind=still"]);
    let moving = errors("acoustics1d", "f64", &[]);
    let ratio = moving["state"].l2 / still["state"].l2;
    assert!((0.5..2.0).contains(&ratio), "{ratio}");
}

/// On particles that go with the flow the values have the error of the integrator alone: fourth
/// order in the step, none of the cut-off.
#[test]
fn carried_values_do_not_feel_the_cut_off() {
    let state = |changes: &[&str]| errors("transport-rotation", "f64", changes)["state"].l2;
    let usual = state(&["time.step=0.01"]);
    let other = state(&["time.step=0.01", "cut-off.name=smooth-4", "cut-off.eta=1.1"]);
    assert_eq!(usual, other);
    let order = (state(&["time.step=0.02"]) / usual).log2();
    assert!((order - 4.0).abs() < 0.3, "order {order}");
}

/// With decay and a source in a rotating, shearing, compressing or uniform flow: the exact solution
/// along each path, to the accuracy of the integrator.
#[test]
fn decay_and_sources_are_followed_in_every_flow() {
    for (name, flow) in [
        ("transport-rotation", ""),
        ("transport-shear", ""),
        ("transport-compression", ""),
        ("transport-mesh", "motion.kind=flow"),
    ] {
        let mut changes = vec![
            "resolution.particles=400",
            "system.decay=0.7",
            "system.source=0.4",
            "time.step=0.02",
        ];
        changes.extend((!flow.is_empty()).then_some(flow));
        let error = errors(name, "f64", &changes)["state"].linf;
        assert!(error < 1e-4, "{name}: {error}");
    }
}

/// Without losses, sources and walls the sums of the strengths are those of the start.
#[test]
fn sums_are_conserved_to_rounding() {
    for (name, scalar, bound) in [
        ("acoustics1d", "f64", 1e-14),
        ("acoustics1d", "f32", 1e-6),
        ("maxwell-te", "f64", 1e-14),
        ("elastic-waves", "f64", 1e-14),
        ("linearised-gas", "f32", 1e-6),
        ("transport-mesh", "f64", 1e-14),
    ] {
        let outcome = run(name, scalar, 2, &[]);
        assert!(outcome.is_conserving, "{name}");
        let drift = outcome.drift.iter();
        let worst = drift.fold(0.0f64, |worst, (_, drift)| worst.max(drift.abs()));
        assert!(worst < bound, "{name} in {scalar}: {worst}");
    }
}

/// With losses the sums follow `e^(-A⁰ t)`, to the order of the integrator; at mirror sides those that
/// nothing pushes on are kept; of a component that is 0 the drift is 0 and not rounding over rounding.
#[test]
fn sums_are_compared_with_what_losses_and_walls_leave() {
    let drift = |name: &str, changes: &[&str]| {
        let outcome = run(name, "f64", 1, changes);
        assert!(!outcome.is_conserving, "{name}");
        outcome.drift
    };
    // Half a unit of time of decay 1.4: half of it is gone, and the drift says none of that.
    for (decay, end) in [("1.4", "0.5"), ("14.0", "0.05")] {
        let changes = [
            "resolution.particles=400",
            &format!("system.decay={decay}"),
            &format!("time.end={end}"),
        ];
        let [(name, drift)] = &drift("transport-rotation", &changes)[..] else {
            panic!("one sum");
        };
        assert!(name == "u" && drift.abs() < 1e-5, "{drift}");
    }
    let water = drift(
        "shallow-water",
        &["system.coriolis=2.0", "resolution.particles=400"],
    );
    assert_eq!(water.len(), 3);
    assert!(
        water.iter().all(|(_, drift)| drift.abs() < 1e-4),
        "{water:?}"
    );
    // Walls at x: what presses on them changes the momentum along x.
    let folder = tempfile::tempdir().unwrap();
    let text = |(system, components): (&str, &[&str]), sides: &str, wave: [i32; 2]| {
        let mut rows = format!("position_x,position_y,weight,{}\n", components.join(","));
        for k in 0..400 {
            let [x, y] = [k % 20, k / 20].map(|i| (f64::from(i) + 0.5) / 20.0);
            let phase = std::f64::consts::TAU * (f64::from(wave[0]) * x + f64::from(wave[1]) * y);
            let values = (0..components.len()).map(|j| match j {
                0 => 1.0 + phase.sin(),
                2 if components.len() == 3 => 0.0,
                _ => (phase + 0.1 * j as f64).sin(),
            });
            let values: Vec<String> = values.map(|value| value.to_string()).collect();
            rows += &format!("{x},{y},0.0025,{}\n", values.join(","));
        }
        let cloud = folder.path().join("cloud.csv");
        std::fs::write(&cloud, rows).unwrap();
        format!(
            "name = \"box\"\ndimension = 2\n[domain]\nlower = [0.0, 0.0]\nupper = [1.0, 1.0]\n\
             sides = [{sides}, \"periodic\"]\n[system]\n{system}\n[resolution]\n\
             arrangement = \"file\"\nfile = {cloud:?}\n[time]\nend = 0.3\n"
        )
    };
    let sound = (
        "kind = \"acoustics\"\ndensity = 1.0\nsound-speed = 1.0",
        &["pressure", "velocity_x", "velocity_y"][..],
    );
    let drift = |text: String| {
        let scenario = AnyScenario::read(Source::Text(text), &[]).unwrap();
        let AnyScenario::Linear(scenario) = scenario else {
            panic!("no system");
        };
        experiment(*scenario, "f64", 1).unwrap().outcome.drift
    };
    // Of a component that is 0 it is not rounding over rounding.
    let still = drift(text(sound, "\"periodic\"", [1, 0]));
    assert_eq!(still.len(), 3);
    assert!(
        still.iter().all(|(_, drift)| drift.abs() < 1e-13),
        "{still:?}"
    );
    let light = (
        "kind = \"maxwell-te\"\npermittivity = 1.0\npermeability = 1.0",
        &["electric_x", "electric_y", "magnetic_z"][..],
    );
    let solid = (
        "kind = \"elastic-waves\"\ndensity = 1.0\nlambda = 1.0\nmu = 1.0",
        &[
            "velocity_x",
            "velocity_y",
            "stress_xx",
            "stress_yy",
            "stress_xy",
        ][..],
    );
    for (of, known) in [
        (sound, &["pressure", "velocity_y"][..]),
        (light, &["electric_x", "magnetic_z"]),
        (solid, &["velocity_y", "stress_xx", "stress_yy"]),
    ] {
        let kept = drift(text(of, "\"mirror\"", [1, 1]));
        let names: Vec<&str> = kept.iter().map(|(name, _)| &**name).collect();
        assert_eq!(names, known);
        assert!(
            kept.iter().all(|(_, drift)| drift.abs() < 1e-13),
            "{kept:?}"
        );
    }
}

#[cfg(feature = "fixed-point")]
#[test]
fn one_dimension_runs_in_fixed_point_with_exact_sums() {
    for (name, bound) in [("acoustics1d", 2e-3), ("telegraph", 2e-3)] {
        let few = ["resolution.particles=512"];
        let scenario = scenario(name, &few);
        let in_q12_19 = experiment(scenario, "q12.19", 2).unwrap();
        let error = in_q12_19.errors.unwrap()["state"].l2;
        assert!(error < bound, "{name}: {error}");
        if name == "acoustics1d" {
            let drift = in_q12_19.outcome.drift;
            assert!(in_q12_19.outcome.is_conserving && drift.len() == 2);
            assert!(drift.iter().all(|(_, drift)| *drift == 0.0), "{drift:?}");
        }
    }
}

/// The energy norm of a lossless system keeps its size, that of a lossy one falls as fast as it
/// may at least, and none passes its bound.
#[test]
fn the_energy_norm_stays_below_its_bound() {
    for scenario in built_in(false) {
        let name = scenario.name.clone();
        let outcome = run(&name, "f64", 2, &["resolution.particles=1024"]);
        let norms = outcome.series.of("energy_norm");
        assert!(norms.len() > 1, "{name}");
        for (norm, bound) in norms.into_iter().zip(outcome.series.of("energy_bound")) {
            assert!(norm <= 1.01 * bound, "{name}: {norm} > {bound}");
        }
    }
}

/// On a cloud so thin that a particle sees one or two others the scheme is no approximation, and
/// the norm runs away: the run stops and says so.
#[test]
fn a_norm_that_grows_faster_than_any_solution_stops_the_run() {
    let changes = [
        "resolution.particles=64",
        "resolution.arrangement=low-discrepancy",
        "cut-off.epsilon=0.012",
        "time.end=20",
    ];
    match stopped(experiment(scenario("acoustics1d", &changes), "f64", 1)) {
        RunError::Growth { norm, bound, .. } => assert!(norm > bound),
        error => panic!("{error}"),
    }
}

#[test]
fn what_cannot_be_run_is_refused_with_its_reason() {
    let refused =
        |changes: &[&str]| stopped(experiment(scenario("acoustics1d", changes), "f64", 1));
    let RunError::Step { step, limit, .. } = refused(&["time.step=0.1"]) else {
        panic!("a step of 0.1 is above the limit");
    };
    assert!(step > limit && limit > 0.0);
    // Just below the limit it runs.
    let below = format!("time.step={}", 0.99 * limit);
    run("acoustics1d", "f64", 1, &[&below]);
    let alone = refused(&["cut-off.epsilon=1e-4"]);
    let told = alone.to_string();
    let parts = ["0.102 spacings", "sees no neighbour"];
    assert!(parts.iter().all(|part| told.contains(part)), "{told}");
}

/// Wide fixed point has the errors of f64 in the plane too; 32 bits have twice them at the most.
#[cfg(feature = "fixed-point")]
#[test]
fn fixed_point_solves_systems_in_the_plane() {
    let error = |name: &str, scalar: &str| {
        let experiment = experiment(scenario(name, &[]), scalar, 1).unwrap();
        experiment.errors.unwrap()["state"].l2
    };
    let reference = error("maxwell-te", "f64");
    let wide = error("maxwell-te", "q31.32");
    assert!((wide / reference - 1.0).abs() < 1e-3, "{wide} {reference}");
    let narrow = error("maxwell-te", "q15.16");
    assert!(narrow < 2.0 * reference, "{narrow} {reference}");
}

#[test]
fn a_run_can_be_interrupted() {
    let mut engine = Threads::new(1).unwrap();
    let mut control = Control {
        samples: 10,
        progress: &mut |done| done < 0.5,
        look: &mut |_| Ok(()),
        keep: None,
        from: None,
    };
    let how = ("f64".parse().unwrap(), false);
    let telegraph = AnyScenario::Linear(Box::new(scenario("telegraph", &[])));
    let result = Experiment::run(telegraph, how, &mut engine, &mut control);
    let interrupted = matches!(stopped(result), RunError::Interrupted { .. });
    assert!(interrupted);
}

/// A system of one's own, by its matrices: acoustics in a moving frame, found symmetrisable and
/// solved to the accuracy of the shipped one.
#[test]
fn a_system_given_by_matrices_is_solved() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("own.toml");
    let text = "name = \"own\"\ndimension = 1\n\
        [domain]\nlower = [0.0]\nupper = [1.0]\nsides = [\"periodic\"]\n\
        [system]\nkind = \"matrices\"\ncomponents = 2\n\
        flux = [[[0.3, 4.0], [1.0, 0.3]]]\ndecay = [[0.2, 0.0], [0.0, 0.1]]\n\
        [initial]\nkind = \"modes\"\nwave = [1]\nstate = [1.0, 0.5]\n\
        [resolution]\nparticles = 200\n\
        [cut-off]\nname = \"smooth-4\"\neta = 1.0\ntheta = 0.75\n\
        [time]\nend = 0.2\n[output]\nexact = \"initial\"\n";
    std::fs::write(&file, text).unwrap();
    let in_scalar = |scalar: &str, changes: &[&str]| {
        let name = file.display().to_string();
        experiment(scenario(&name, changes), scalar, 1)
    };
    let own = |changes: &[&str]| in_scalar("f64", changes);
    let error = own(&[]).unwrap().errors.unwrap()["state"].l2;
    assert!(error < 3e-4, "{error}");
    if cfg!(feature = "fixed-point") {
        let errors = in_scalar("q31.32", &[]).unwrap().errors.unwrap();
        let part = errors["state"].l2 / error;
        assert!((part - 1.0).abs() < 1e-3, "{part} times the error of f64");
    }
    // P A is symmetric for P = diag(1, 4) up to a factor: the norm weighs the second component.
    let name = file.display().to_string();
    let symmetriser = plan(&scenario(&name, &[])).symmetriser.unwrap();
    let [a, b, c, d] = symmetriser.matrix[..] else {
        panic!("{symmetriser:?}");
    };
    assert!((d / a - 4.0).abs() < 1e-9 && b.abs() < 1e-9 && c.abs() < 1e-9);
    assert!((symmetriser.speed - 2.3).abs() < 1e-9);
    for (flux, reason) in [
        ("[[[0.0, 1.0], [-1.0, 0.0]]]", "not hyperbolic"),
        ("[[[1.0, 1.0], [0.0, 1.0]]]", "too few eigenvectors"),
    ] {
        let changed = format!("system.flux={flux}");
        let error = own(&[&changed]).err().unwrap();
        assert!(error.to_string().contains(reason), "{error}");
    }
}

/// All quadratures integrate: weights add up to the domain, and acoustics converges on each.
#[test]
fn every_quadrature_carries_a_solution() {
    // Measured 1.1e-5, 1.2e-5 and 0.18. A sequence of low discrepancy needs a wide cut-off: with
    // eta = 1 its gradients are so far off that the run is stopped.
    for (arrangement, eta, bound) in [
        ("lattice", "cut-off.eta=1", 3e-5),
        ("distorted", "cut-off.eta=1", 3e-5),
        ("low-discrepancy", "cut-off.eta=3", 0.25),
    ] {
        let arrangement = format!("resolution.arrangement={arrangement}");
        let changes = [
            "resolution.particles=400",
            "cut-off.name=smooth-4",
            "motion.kind=still",
            eta,
            &arrangement,
        ];
        let scenario = scenario("acoustics1d", &changes);
        let plan = plan(&scenario);
        let sum: f64 = plan.weights.iter().sum();
        assert!((sum / 400.0 - 1.0).abs() < 1e-6, "{arrangement}: {sum}");
        let error = errors("acoustics1d", "f64", &changes)["state"].of(Norm::L2);
        assert!(error < bound, "{arrangement}: {error}");
    }
}

/// Points, weights and states from a file are those of the run that wrote them: the same bits.
#[test]
fn a_cloud_from_a_file_is_the_cloud_that_was_written() {
    let folder = tempfile::tempdir().unwrap();
    let few = ["resolution.particles=64"];
    let lattice = scenario("acoustics1d", &few);
    let plan = plan(&lattice);
    let length = plan.units.length;
    let mut text = "position,weight,pressure,velocity_x\n".to_owned();
    for (k, x) in plan.positions.iter().enumerate() {
        let place = plan.middle[0] + x[0] * length;
        let weight = plan.weights[k] * length;
        let [p, v] = plan.values[2 * k..2 * k + 2] else {
            panic!("two components");
        };
        text += &format!("{place},{weight},{p},{v}\n");
    }
    std::fs::write(folder.path().join("cloud.csv"), &text).unwrap();
    let file = folder.path().join("own.toml");
    let own = lattice
        .text
        .replace("particles = 64", "file = \"cloud.csv\"")
        .replace("arrangement = \"lattice\"", "arrangement = \"file\"");
    let (head, tail) = own.split_once("[initial]").unwrap();
    let (_, tail) = tail.split_once("[resolution]").unwrap();
    let own = format!("{head}[resolution]{tail}").replace("exact = \"initial\"", "");
    let own = own.split("[tolerance").next().unwrap();
    std::fs::write(&file, own).unwrap();
    let read = scenario(&file.display().to_string(), &[]);
    let from_file = experiment(read, "f64", 1).unwrap().outcome;
    assert_eq!(from_file.digest, run("acoustics1d", "f64", 1, &few).digest);

    std::fs::write(
        folder.path().join("cloud.csv"),
        text.replacen("0.015625", "-0.015625", 1),
    )
    .unwrap();
    let broken = experiment(scenario(&file.display().to_string(), &[]), "f64", 1);
    let message = format!("{:?}", miette::Report::new(broken.err().unwrap()));
    assert!(
        message.contains("weight") || message.contains("cloud.csv"),
        "{message}"
    );
}

/// Snapshots and tables show the neighbours that particles have, also where nothing passes between
/// them: drawn together by half, they have four times as many.
#[test]
fn neighbours_are_counted_where_nothing_passes_between_particles() {
    let changes = ["resolution.particles=900", "time.end=1.3862943611198906"];
    let outcome = run("transport-compression", "f64", 2, &changes);
    let means = outcome.series.of("neighbours_mean");
    let [first, last] = [0, means.len() - 1].map(|i| means[i]);
    assert!((3.0..4.5).contains(&(last / first)), "{first} {last}");
}

/// Values beyond the square root of the largest number are no reason to lose the norm.
#[test]
fn large_values_have_a_norm() {
    let large = [
        "initial.kind=gaussian",
        "initial.width=0.1",
        "initial.amplitude=1e30",
    ];
    let outcome = run("acoustics1d", "f32", 1, &large);
    let last = |name: &str| *outcome.series.of(name).last().unwrap();
    let (norm, bound) = (last("energy_norm"), last("energy_bound"));
    assert!(
        norm > 1e29 && (norm / bound - 1.0).abs() < 0.01,
        "{norm} {bound}"
    );
}

#[test]
fn a_doubtful_set_up_comes_with_a_warning() {
    let doubts = |changes: &[&str]| {
        let scenario = scenario("acoustics1d", changes);
        experiment(scenario, "f64", 1).unwrap().doubts.join(" ")
    };
    let narrow = ["initial.kind=gaussian", "initial.width=1e-4"];
    assert!(
        doubts(&narrow).contains("do not resolve"),
        "{}",
        doubts(&narrow)
    );
    assert_eq!(doubts(&[]), "");
}

/// A field that carries particles by less than half a last place a step leaves them where they are, and by few
/// of them astray; both are told.
#[cfg(feature = "fixed-point")]
#[test]
fn particles_that_are_carried_by_few_last_places_are_told() {
    let told = |scalar: &str, changes: &[&str]| {
        let experiment = experiment(scenario("acoustics1d", changes), scalar, 1).unwrap();
        systems::told(&experiment, "last place")
    };
    let slow = ["motion={kind=\"uniform\", velocity=[1e-6]}"];
    let still = told("q15.16", &slow);
    assert_eq!(still.len(), 1, "{still:?}");
    assert!(still[0].contains("up to 100 % astray"), "{still:?}");
    let none = Vec::<String>::new();
    for scalar in ["q31.32", "f32"] {
        assert_eq!(told(scalar, &slow), none, "{scalar}");
    }
    assert_eq!(told("q15.16", &[]), none);
    assert_eq!(told("q15.16", &["motion.kind=still"]), none);
}
