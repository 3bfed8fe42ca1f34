//! Linear systems on the command line.

mod command;

use std::path::Path;

use command::{failure, stdout};
use serde_json::Value;

fn json(folder: &Path, arguments: &[&str]) -> Value {
    let text = stdout(folder, arguments);
    assert_eq!(text.lines().count(), 1);
    serde_json::from_str(&text).unwrap()
}

#[test]
fn json_is_one_object_with_the_documented_keys() {
    let folder = tempfile::tempdir().unwrap();
    let run = ["run", "acoustics1d", "-n", "100", "--json"];
    let json = json(folder.path(), &run);
    assert_eq!(json["scenario"], "acoustics1d");
    assert_eq!(json["system"], "acoustics");
    assert_eq!(json["method"], "rk4");
    assert_eq!(json["particles"], 100);
    assert_eq!(json["components"][1], "velocity_x");
    for field in ["pressure", "velocity_x", "state", "reconstruction"] {
        let norms = &json["errors"][field];
        let [l1, l2, linf] = ["l1", "l2", "linf"].map(|norm| norms[norm].as_f64().unwrap());
        assert!(0.0 < l1 && l1 < l2 && l2 < linf, "{field}: {norms}");
    }
    assert!(json["drift"]["pressure"].as_f64().unwrap().abs() < 1e-12);
    let [first, last] = ["first", "last"].map(|when| json["energy_norm"][when].as_f64().unwrap());
    assert!((last / first - 1.0).abs() < 0.01, "{first} {last}");
    assert_eq!(json["digest"].as_str().unwrap().len(), 16);
    assert_eq!(json["warnings"].as_array().unwrap().len(), 0);
    let lossy = stdout(folder.path(), &["run", "telegraph", "-n", "64", "--json"]);
    let lossy: Value = serde_json::from_str(&lossy).unwrap();
    // Off what the losses leave, to the accuracy of the integrator.
    assert!(
        lossy["drift"]["voltage"].as_f64().unwrap().abs() < 1e-6,
        "{lossy}"
    );
    let open = stdout(folder.path(), &["run", "robin-wall", "-n", "64", "--json"]);
    assert!(open.contains("\"drift\":null"), "{open}");
}

#[test]
fn a_run_leaves_tables_pictures_a_probe_and_snapshots() {
    let folder = tempfile::tempdir().unwrap();
    let changes = [
        "run",
        "maxwell-te",
        "-n",
        "400",
        "--quiet",
        "--set",
        "output.probe={ points = [9, 7] }",
        "--set",
        "output.snapshots={ every = 0.25, format = \"csv\" }",
    ];
    assert_eq!(stdout(folder.path(), &changes), "");
    let out = folder.path().join("out/maxwell-te");
    let table = |name: &str| std::fs::read_to_string(out.join(name)).unwrap();
    let particles = table("particles.csv");
    assert_eq!(particles.lines().count(), 401);
    let heading = particles.lines().next().unwrap();
    for column in [
        "weight",
        "electric_x",
        "reconstructed_magnetic_z",
        "exact_electric_y",
    ] {
        assert!(heading.contains(column), "{heading}");
    }
    assert_eq!(table("probe.csv").lines().count(), 64);
    let series = table("series.csv");
    assert!(series.starts_with("time,steps,time_step,energy_norm,energy_bound,total_electric_x"));
    for picture in ["figure.svg", "map.svg", "probe.svg"] {
        assert!(table(picture).contains("<svg"), "{picture}");
    }
    assert!(table("snapshots.csv").lines().count() >= 4);
}

#[test]
fn a_study_gives_the_order_beside_the_theory() {
    let folder = tempfile::tempdir().unwrap();
    let study = [
        "converge",
        "acoustics1d",
        "--ladder",
        "64,128,256",
        "--json",
    ];
    let json = json(folder.path(), &study);
    assert_eq!(json["field"], "state");
    assert_eq!(json["predicted_order"], 1.5);
    assert_eq!(json["guaranteed_order"], 0.25);
    let observed = json["observed_order"].as_f64().unwrap();
    assert!((observed - 1.5).abs() < 0.1, "{observed}");
    let level = &json["levels"][2];
    assert_eq!(level["n"], 256);
    let (h, eps) = (level["h"].as_f64().unwrap(), level["eps"].as_f64().unwrap());
    assert!((eps / (0.7 * h.powf(0.75)) - 1.0).abs() < 1e-12);
    for file in ["converge.csv", "converge.svg"] {
        let path = folder.path().join("out/converge-acoustics1d").join(file);
        assert!(path.exists(), "{file}");
    }
}

/// With a constant number of neighbours the quadrature governs: the study says so, and why.
#[test]
fn a_study_with_theta_one_warns_that_it_cannot_converge() {
    let folder = tempfile::tempdir().unwrap();
    let study = [
        "converge",
        "acoustics1d",
        "--ladder",
        "128,256,512,1024",
        "--set",
        "cut-off.eta=1.3",
        "--set",
        "cut-off.theta=1",
        "--json",
    ];
    let json = json(folder.path(), &study);
    let warnings = json["warnings"].to_string();
    assert!(warnings.contains("cannot converge to zero"), "{warnings}");
    assert!(warnings.contains("governs"), "{warnings}");
}

#[test]
fn bad_input_is_answered_with_the_value_and_the_cure() {
    let folder = tempfile::tempdir().unwrap();
    // Reports fold long lines, and draw a bar before them.
    let told = |arguments: &[&str]| {
        let errors = failure(folder.path(), arguments, 2);
        let words = errors.split_whitespace().filter(|word| *word != "│");
        words.collect::<Vec<_>>().join(" ")
    };
    let run = |changes: &[&str], parts: &[&str]| {
        let mut arguments = vec!["run", "acoustics1d"];
        for change in changes {
            arguments.extend(["--set", change]);
        }
        let errors = told(&arguments);
        for part in parts {
            assert!(errors.contains(part), "{part} is not in {errors}");
        }
    };
    run(
        &["time.step=0.1"],
        &["above the stable limit", "use a smaller step"],
    );
    run(&["cut-off.theta=1.5"], &["theta", "1.5"]);
    run(&["motion.kind=rotation"], &["rotation"]);
    let gas = ["run", "sod", "--set", "cut-off.name=smooth-4"];
    let errors = told(&gas);
    assert!(errors.contains("below 0 somewhere"), "{errors}");
    let field = ["converge", "acoustics1d", "--field", "density"];
    let errors = told(&field);
    assert!(errors.contains("there is no field `density`"), "{errors}");
}

/// What could never end stops at once, and walls that are nearer than the cut-off sees are refused.
#[test]
fn runs_without_end_and_boxes_without_room_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let told = |arguments: &[&str], code| {
        let errors = failure(folder.path(), arguments, code);
        let words = errors.split_whitespace().filter(|word| *word != "│");
        words.collect::<Vec<_>>().join(" ")
    };
    let endless = told(&["run", "heat1d", "--set", "system.diffusivity=1e30"], 1);
    assert!(endless.contains("of them to the end"), "{endless}");
    let endless = told(&["run", "sod", "--set", "time.end=1e13"], 1);
    assert!(endless.contains("out of proportion"), "{endless}");
    let near = told(&["run", "robin-wall", "--set", "cut-off.epsilon=0.4"], 2);
    assert!(near.contains("nearer than one reach"), "{near}");
    stdout(
        folder.path(),
        &[
            "run",
            "robin-wall",
            "-n",
            "50",
            "--set",
            "cut-off.epsilon=0.3",
        ],
    );
}

/// The levels that a study chooses itself all fit the period: the coarsest is not below it.
#[test]
fn a_study_chooses_levels_that_fit_the_cut_off() {
    let folder = tempfile::tempdir().unwrap();
    let study = [
        "converge",
        "maxwell-te",
        "--levels",
        "2",
        "--set",
        "resolution.particles=300",
        "--set",
        "time.end=0.02",
        "--json",
    ];
    let json = json(folder.path(), &study);
    let coarsest = json["levels"][0]["n"].as_u64().unwrap();
    assert!((300..2000).contains(&coarsest), "{coarsest}");
}

#[test]
fn an_export_of_a_slab_carries_its_problem_and_its_series() {
    let folder = tempfile::tempdir().unwrap();
    let weather = stdout(folder.path(), &["export", "wall-day"]);
    for part in [
        "pub const PARTICLES: usize = 96;",
        "pub const POINTS: usize = 73;",
        "pub const LAYERS: usize = 0;",
        "DrivenCondition::Exchange { rate: 1.51875, outside: Drive::Series(&[\n",
        "outside: Drive::Constant(20.0) }],",
        "sides: [Side::Mirror, Side::Mirror],",
        "stages: 9,",
    ] {
        assert!(weather.contains(part), "{part}\n{weather}");
    }
    assert_eq!(weather.matches("Particle { ").count(), 96, "{weather}");
    let layers = stdout(folder.path(), &["export", "layered-wall"]);
    for part in [
        "pub const POINTS: usize = 0;",
        "Conductor::Layers { bounds: &[",
        "mean: Mean::Harmonic,",
    ] {
        assert!(layers.contains(part), "{part}\n{layers}");
    }
}

/// What no `SLAB` holds is a module that starts the run itself.
#[test]
fn an_export_that_is_no_slab_is_a_whole_run() {
    let folder = tempfile::tempdir().unwrap();
    let mixed = ["heat1d", "--set", "system.form=mixed"];
    let stepped = ["wall-day", "--set", "time.method=rk4"];
    let driven = ["wall-day", "--set", "wall.1.outside=\"20 + sin(t)\""];
    for (scenario, part) in [
        (&["heat2d"][..], "pub fn start<S: Scalar>"),
        (&["decay-chain"], "NamedProblem<'static, f64, 1, 4>"),
        (&mixed, "form: Form::Mixed,"),
        (&stepped, "scheme: Scheme::RungeKutta(RK4),"),
        (
            &driven,
            "conditions[0].with(FRAME.number(20.0 + libm::sin(t)));",
        ),
    ] {
        let text = stdout(folder.path(), &[&["export"], scenario].concat());
        assert!(text.contains(part), "{part}\n{text}");
        assert!(text.contains("pub struct Memory<S: Scalar>"), "{text}");
    }
}
