//! The command line as a user and a script meet it.

mod command;

use std::path::Path;
use std::process::Command;

use command::{failure, stdout};
use serde_json::Value;

#[test]
fn json_is_one_object_with_the_documented_keys_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let text = stdout(folder.path(), &["run", "sod", "-n", "225", "--json"]);
    assert_eq!(text.lines().count(), 1);
    let json: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["scenario"], "sod");
    assert_eq!(json["scalar"], "f64");
    assert_eq!(json["dimension"], 1);
    assert_eq!(json["particles"], 225);
    assert!(json["steps"].as_u64().unwrap() > 100);
    assert!((json["time"].as_f64().unwrap() - 0.2).abs() < 1e-12);
    assert!(json["seconds"].as_f64().unwrap() > 0.0);
    for field in ["density", "velocity", "pressure", "energy"] {
        let norms = &json["errors"][field];
        let [l1, l2, linf] = ["l1", "l2", "linf"].map(|norm| norms[norm].as_f64().unwrap());
        assert!(0.0 < l1 && l1 < l2 && l2 < linf, "{field}: {norms}");
    }
    for sum in ["mass", "momentum", "energy"] {
        assert!(json["drift"][sum].is_f64(), "{sum}");
    }
    for part in ["min", "mean", "max"] {
        assert!(json["neighbours"][part].as_f64().unwrap() >= 2.0);
    }
    let digest = json["digest"].as_str().unwrap();
    assert!(
        digest.len() == 16 && digest.chars().all(|c| c.is_ascii_hexdigit()),
        "{digest}"
    );
}

#[test]
fn a_run_leaves_whole_tables_a_picture_and_what_was_run() {
    let folder = tempfile::tempdir().unwrap();
    stdout(
        folder.path(),
        &[
            "run",
            "sod",
            "-n",
            "225",
            "--quiet",
            "--set",
            "output.samples=20",
        ],
    );
    let out = folder.path().join("out/sod");
    let mut particles = csv::Reader::from_path(out.join("particles.csv")).unwrap();
    let heading = particles.headers().unwrap().clone();
    assert!(
        ["position", "density", "exact_density", "exact_energy"]
            .iter()
            .all(|name| heading.iter().any(|column| column == *name))
    );
    let rows: Vec<_> = particles.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 225);
    assert!(
        rows.iter()
            .flatten()
            .all(|field| field.parse::<f64>().unwrap().is_finite())
    );
    let mut series = csv::Reader::from_path(out.join("series.csv")).unwrap();
    let times: Vec<f64> = series
        .records()
        .map(|row| row.unwrap()[0].parse().unwrap())
        .collect();
    assert_eq!(times.len(), 21);
    assert!(times.is_sorted() && times[0] == 0.0 && (times[20] - 0.2).abs() < 1e-12);
    let picture = std::fs::read_to_string(out.join("figure.svg")).unwrap();
    assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"));
    // What was run can be run again.
    let again = stdout(folder.path(), &["run", "out/sod/scenario.toml", "--json"]);
    let json: Value = serde_json::from_str(&again).unwrap();
    assert_eq!(json["particles"], 225);
    // Nothing is left lying beside the results and their list, `.motes`.
    assert_eq!(std::fs::read_dir(&out).unwrap().count(), 5);
}

#[test]
fn scenarios_can_be_listed_shown_and_run_from_a_copy() {
    let folder = tempfile::tempdir().unwrap();
    assert!(stdout(folder.path(), &["list"]).contains("sod"));
    let text = stdout(folder.path(), &["show", "sod"]);
    std::fs::write(folder.path().join("mine.toml"), &text).unwrap();
    let digest = |arguments: &[&str]| {
        let json: Value = serde_json::from_str(&stdout(folder.path(), arguments)).unwrap();
        json["digest"].clone()
    };
    let built_in = digest(&["run", "sod", "--json", "-n", "225"]);
    assert_eq!(
        built_in,
        digest(&["run", "mine.toml", "--json", "-n", "225", "--threads", "2"])
    );
    assert_eq!(
        built_in,
        digest(&["run", "sod", "--json", "--set", "resolution.particles=225"])
    );
    assert_ne!(
        built_in,
        digest(&["run", "sod", "--json", "-n", "225", "--scalar", "f32"])
    );
}

/// A scenario that names a file is run from a copy with a copy of the file beside it.
#[test]
fn a_file_that_a_scenario_names_can_be_shown() {
    let folder = tempfile::tempdir().unwrap();
    let series = stdout(folder.path(), &["show", "wall-day.csv"]);
    assert!(series.starts_with("time,temperature\n0,"), "{series}");
    assert_eq!(series.lines().count(), 74);
    let text = stdout(folder.path(), &["show", "wall-day"]);
    std::fs::write(folder.path().join("mine.toml"), text).unwrap();
    let report = failure(folder.path(), &["run", "mine.toml"], 2);
    assert!(
        report.contains("motes show wall-day.csv > wall-day.csv"),
        "{report}"
    );
}

#[test]
fn checking_for_overflow_changes_no_bit_and_names_the_first_one() {
    let folder = tempfile::tempdir().unwrap();
    let run = |more: &[&str]| {
        let arguments = [
            &["run", "sod", "-n", "225", "--json", "--scalar", "q12.19"],
            more,
        ];
        let json: Value =
            serde_json::from_str(&stdout(folder.path(), &arguments.concat())).unwrap();
        json["digest"].clone()
    };
    assert_eq!(run(&[]), run(&["--check-overflow"]));
    // A gas so hot that sound speeds fit and pressures of its compression do not.
    let hot = [
        "run",
        "sod",
        "-n",
        "225",
        "--scalar",
        "q12.19",
        "--check-overflow",
        "--set",
        "region.0.pressure=0.1",
        "--set",
        "region.0.velocity=[60.0]",
    ];
    let errors = failure(folder.path(), &hot, 1);
    // Messages are wrapped to the terminal, behind a bar.
    let words = errors.split_whitespace().filter(|word| *word != "│");
    let errors = words.collect::<Vec<_>>().join(" ");
    assert!(
        errors.contains("has left the range") && errors.contains("particle"),
        "{errors}"
    );
}

/// Call, and what its message must say: the value and the cure.
const BAD_INPUT: &[(&[&str], &[&str])] = &[
    (
        &["run", "sod", "--scalar", "q3.4"],
        &["q3.4", "q12.19", "f32"],
    ),
    (&["run", "sod", "-n", "0"], &["0", "whole number above 0"]),
    (&["run", "sod", "-n", "1e12"], &["1000000000000"]),
    (
        &["run", "sod", "-n", "4e9"],
        &["4000000000", "fewer particles"],
    ),
    (
        &["run", "sod", "-n", "400000000"],
        &["GiB", "fewer particles"],
    ),
    (
        &["run", "sod", "-n", "4"],
        &["region 1", "no particle", "more particles"],
    ),
    (&["run", "sod", "-n", "nine"], &["nine", "whole number"]),
    (
        &["run", "sod", "--set", "material.gamma=nan"],
        &["gamma", "nan", ":50:", "finite"],
    ),
    (
        &["run", "sod", "--set", "material.gamma=1"],
        &["gamma", "> 1", ":50:"],
    ),
    (
        &["run", "sod", "--set", "viscosity.knid=none"],
        &["knid", "kind"],
    ),
    (
        &["run", "sod", "--set", "region.0.density=-1"],
        &["density", "-1", "> 0"],
    ),
    (
        &["run", "sod", "--threads", "100000"],
        &["100000", "--threads 0"],
    ),
    (&["run", "missing.toml"], &["missing.toml", "no file"]),
    (&["run", "folder/"], &["directory"]),
    (&["run", "sot"], &["sot", "sod"]),
    (&["run", "typo.toml"], &["typo.toml:5:", "uper", "upper"]),
    (
        &["run", "sod", "--out", "file/below"],
        &["cannot write", "--out"],
    ),
    (
        &["run", "sod", "-n", "3000000", "--scalar", "q12.19"],
        &["q12.19", "integer bits"],
    ),
    (
        &["run", "sod", "--set", "cut-off.name=root-free"],
        &["root-free", "1.5", "eta"],
    ),
    (
        &["run", "sod", "--set", "cut-off.eta=1e9"],
        &["1000000000", "cut-off.eta between"],
    ),
    (
        &[
            "run",
            "sod",
            "--set",
            "time.end=1e-12",
            "--scalar",
            "q12.19",
        ],
        &["duration", "fractional"],
    ),
    (
        &[
            "run",
            "sod",
            "--set",
            "gradient.kind=linear-exact",
            "--scalar",
            "q12.19",
        ],
        &["gradient.kind", "q12.19", "--scalar f64"],
    ),
    (
        &[
            "run",
            "sod",
            "--set",
            "region.0.density=1e250",
            "--set",
            "region.1.density=1e250",
        ],
        &["unit", "nearer to 1"],
    ),
    (
        &[
            "run",
            "noh2d",
            "-n",
            "90",
            "--set",
            "domain.upper=[1.0,1e14]",
        ],
        &["particles", "90", "thinner than their spacing"],
    ),
    (
        &["run", "woodward-colella", "--set", "region.0.pressure=1e8"],
        &["reference", "steps", "output.exact"],
    ),
    (&["run", "/dev/zero"], &["/dev/zero", "device"]),
    (&["bench", "4d"], &["4d", "3d"]),
    (&["bench", "1d", "--scalar", "q12.19"], &["q12.19", "f32"]),
    (&["show", "sot"], &["sot", "sod"]),
    (&["run", "sod", "--no-such-flag"], &["--no-such-flag"]),
];

#[test]
fn bad_input_is_answered_with_the_value_and_the_cure() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("folder")).unwrap();
    std::fs::write(folder.path().join("file"), "").unwrap();
    let typo = "name = \"x\"\ndimension = 1\n[domain]\nlower = [-1.0]\nuper = [1.0]\n";
    std::fs::write(folder.path().join("typo.toml"), typo).unwrap();
    answers(folder.path(), BAD_INPUT);
}

/// Every call fails with code 2 and says its parts.
fn answers(folder: &Path, calls: &[(&[&str], &[&str])]) {
    for (arguments, parts) in calls {
        let errors = failure(folder, arguments, 2);
        // Messages are wrapped to the terminal: compare without line ends.
        let flat: String = errors.split_whitespace().collect::<Vec<_>>().join(" ");
        for part in *parts {
            assert!(
                flat.contains(part),
                "{arguments:?} does not say {part:?}: {errors}"
            );
        }
    }
}

/// The warnings of a run, as JSON tells them.
fn warnings(folder: &Path, changes: &[&str]) -> Vec<String> {
    let mut arguments = vec!["run", "sod", "-n", "225", "--json"];
    arguments.extend(changes.iter().flat_map(|change| ["--set", change]));
    let json: Value = serde_json::from_str(&stdout(folder, &arguments)).unwrap();
    let warnings = json["warnings"].as_array().unwrap();
    warnings
        .iter()
        .map(|text| text.as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn doubtful_results_come_with_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let cases: [(&[&str], &str); 5] = [
        (&["time.end=2.0"], "reached the ends"),
        (
            &["domain.sides=[\"periodic\"]", "output.window.lower=[-1.0]"],
            "lower end",
        ),
        (
            &["domain.sides=[\"free\"]", "output.window.upper=[1.0]"],
            "end of the domain",
        ),
        (
            &[
                "output.window.lower=[0.91]",
                "output.window.upper=[0.91001]",
            ],
            "no particle",
        ),
        (
            &["cut-off.epsilon=0.026", "region.1.velocity=[2.0]"],
            "neighbour",
        ),
    ];
    for (changes, part) in cases {
        let warnings = warnings(folder.path(), changes);
        assert!(
            warnings.iter().any(|text| text.contains(part)),
            "{changes:?}: {warnings:?}"
        );
    }
    assert!(warnings(folder.path(), &[]).is_empty());
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_failure_and_a_full_disk_is_one() {
    let folder = tempfile::tempdir().unwrap();
    let shell = |line: &str| {
        let line = line.replace("motes", env!("CARGO_BIN_EXE_motes"));
        Command::new("bash")
            .args(["-c", &line])
            .current_dir(folder.path())
            .output()
            .unwrap()
    };
    let gone = shell("motes show sod | true; exit ${PIPESTATUS[0]}");
    assert_eq!((gone.status.code(), &gone.stderr[..]), (Some(0), &b""[..]));
    if Path::new("/dev/full").exists() {
        let full = shell("motes show sod > /dev/full");
        let errors = String::from_utf8_lossy(&full.stderr).into_owned();
        assert_eq!(full.status.code(), Some(1), "{errors}");
        assert!(
            errors.contains("cannot write to standard output"),
            "{errors}"
        );
    }
}

#[test]
fn an_export_carries_the_whole_scheme() {
    let folder = tempfile::tempdir().unwrap();
    let export = |more: &[&str]| {
        stdout(
            folder.path(),
            &[&["export", "sod", "-n", "225"], more].concat(),
        )
    };
    let text = export(&[
        "--set",
        "cut-off.name=wendland-c4",
        "--set",
        "viscosity.kind=von_neumann",
    ]);
    assert!(
        text.contains("CutOff::WendlandC4") && text.contains("Viscosity::VonNeumann"),
        "{text}"
    );
    assert!(
        text.starts_with("//! Made by `motes export sod -n 225 --set"),
        "{text}"
    );
    assert!(export(&["--set", "viscosity.kind=none"]).contains("Viscosity::Inviscid"));
}

#[test]
fn an_export_of_a_line_carries_its_equations_motion_and_method() {
    let folder = tempfile::tempdir().unwrap();
    let export = |name: &str, more: &[&str]| {
        stdout(
            folder.path(),
            &[&["export", name, "-n", "64"], more].concat(),
        )
    };
    let sound = export("acoustics1d", &["--set", "time.method=ssp-rk3"]);
    for part in [
        "pub const PARTICLES: usize = 64;",
        "pub const CELLS: usize = 385;",
        "pub const METHOD: RungeKutta = SSP_RK3;",
        "Acoustics::new(1.0, 1.0, units)",
        "amplitude: S::from_f64(0.2),",
        "sides: [Side::Periodic, Side::Periodic],",
        "step: None,",
    ] {
        assert!(sound.contains(part), "{part}\n{sound}");
    }
    assert_eq!(sound.matches("Particle { ").count(), 64, "{sound}");
    let line = export(
        "telegraph",
        &[
            "--set",
            "motion.kind=still",
            "--set",
            "cut-off.name=wendland-c4",
            "--set",
            "time.step=0.001",
        ],
    );
    for part in [
        "let (conductance, resistance) = (0.25, 1.0);",
        "pub fn motion<S: Scalar>() -> Still {",
        "CutOff::WendlandC4",
        "step: Some(0.064),",
    ] {
        assert!(line.contains(part), "{part}\n{line}");
    }
}

/// What no `LINE` holds is a module that starts the run itself.
#[test]
fn an_export_that_is_no_line_is_a_whole_run() {
    let folder = tempfile::tempdir().unwrap();
    for (name, part) in [
        (
            "acoustics2d",
            "LinearDynamics<S, CutOff, Acoustics<S>, Still, 2, 3>",
        ),
        ("maxwell-te", "MaxwellTe::new("),
        ("transport-rotation", "Transport<S, Rotation<S, 2>>"),
        (
            "manufactured",
            "impl<S: Scalar> MatrixField<S, 2, 4> for Coefficients {",
        ),
    ] {
        let text = stdout(folder.path(), &["export", name]);
        assert!(text.contains(part), "{part}\n{text}");
        assert!(text.contains("pub fn start<S: Scalar>"), "{text}");
    }
}

#[test]
fn an_export_that_would_be_another_run_is_refused_with_the_cure() {
    let folder = tempfile::tempdir().unwrap();
    for (name, reason, cure) in [
        ("wind-tunnel", "goes out through its sides", "OpenGas"),
        ("taylor-green", "background is above 0", "background = 0"),
    ] {
        let errors = failure(folder.path(), &["export", name], 2);
        let errors: Vec<&str> = errors.split_whitespace().collect();
        // Long lines are broken with a bar in front.
        let errors = errors.join(" ").replace("│ ", "");
        let told = format!("does not write `{name}`: ");
        for part in [&told, reason, cure] {
            assert!(errors.contains(part), "{part}\n{errors}");
        }
    }
}

/// Ctrl-C in mid-run: finished files of an earlier run stay whole; only what the run can be gone on with
/// comes beside them.
#[cfg(unix)]
#[test]
fn an_interrupt_leaves_earlier_results_whole() {
    let folder = tempfile::tempdir().unwrap();
    stdout(folder.path(), &["run", "sod", "-n", "225", "--quiet"]);
    let file = folder.path().join("out/sod/particles.csv");
    let before = std::fs::read(&file).unwrap();
    let mut run = Command::new(env!("CARGO_BIN_EXE_motes"))
        .current_dir(folder.path())
        .args(["run", "sod", "-n", "20000", "--set", "time.end=10"])
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    // The result folder is tried before the run: when it is there the handler soon is too.
    std::thread::sleep(std::time::Duration::from_millis(500));
    let interrupt = Command::new("kill")
        .args(["-INT", &run.id().to_string()])
        .status()
        .unwrap();
    assert!(interrupt.success());
    assert_eq!(run.wait().unwrap().code(), Some(130));
    assert_eq!(std::fs::read(&file).unwrap(), before);
    let left = std::fs::read_dir(file.parent().unwrap()).unwrap();
    let left = left.filter(|entry| entry.as_ref().unwrap().file_name() != "checkpoints");
    assert_eq!(left.count(), 5);
}

/// `motes new`: a file that runs, under its own name, and never over another.
#[test]
fn a_scenario_of_ones_own_is_written_with_its_files_and_never_over_another() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    stdout(folder.path(), &["new", "tube.toml"]);
    stdout(folder.path(), &["new", "house.toml", "--from", "wall-day"]);
    for name in ["tube", "house"] {
        let file = format!("{name}.toml");
        stdout(folder.path(), &["run", &file, "-n", "96", "--quiet"]);
        assert!(
            at("out").join(name).join("particles.csv").is_file(),
            "{name}"
        );
    }
    let built_in = stdout(folder.path(), &["show", "sod"]);
    let own = std::fs::read_to_string(at("tube.toml")).unwrap();
    let differ = built_in.lines().zip(own.lines()).filter(|(a, b)| a != b);
    let differ: Vec<_> = differ.collect();
    assert!(
        differ.len() == 1 && differ[0].1.contains("tube"),
        "{differ:?}"
    );
    for (arguments, words) in [
        (&["new", "tube.toml"][..], "is there already"),
        (
            &["new", "other.toml", "--from", "wall-day"],
            "wall-day.csv` is there already",
        ),
        (&["new", "tube"], "tube.toml"),
        (&["new", "no/tube.toml"], "make the folder first"),
        (&["new", "other.toml", "--from", "sodd"], "sod"),
    ] {
        let errors = failure(folder.path(), arguments, 2);
        assert!(errors.contains(words), "{errors}");
    }
    assert!(!at("other.toml").exists());
    assert_eq!(std::fs::read_to_string(at("tube.toml")).unwrap(), own);
}

/// Every command is completed by every shell, and stands on the manual page.
#[test]
fn shells_and_the_manual_know_the_commands() {
    let folder = tempfile::tempdir().unwrap();
    let commands = ["run", "resume", "compare", "converge", "export"];
    for shell in ["bash", "zsh", "fish"] {
        let text = stdout(folder.path(), &["completions", shell]);
        assert!(text.contains("checkpoint-every"), "{shell}");
        assert!(commands.iter().all(|name| text.contains(name)), "{shell}");
    }
    let page = stdout(folder.path(), &["man"]);
    assert!(page.contains(".TH motes 1"), "{page}");
    for name in commands {
        assert!(page.contains(&format!("motes\\-{name}")), "{page}");
        let page = stdout(folder.path(), &["man", name]);
        assert!(page.contains(&format!(".TH motes-{name} 1")), "{page}");
    }
    let errors = failure(folder.path(), &["man", "fly"], 2);
    assert!(errors.contains("`fly` is no command"), "{errors}");
}

#[test]
fn help_has_examples_and_the_version_is_told() {
    let folder = tempfile::tempdir().unwrap();
    assert!(stdout(folder.path(), &["run", "--help"]).contains("Examples:"));
    assert!(stdout(folder.path(), &["--version"]).starts_with("motes 0."));
}

/// As [`BAD_INPUT`].
const BAD_STUDIES: &[(&[&str], &[&str])] = &[
    (
        &["converge", "sod", "--ladder", "100"],
        &["at least 2", "--levels 3"],
    ),
    (&["converge", "sod", "--levels", "1"], &["at least 2"]),
    (
        &["converge", "sod", "--levels", "99"],
        &["99", "fewer --levels"],
    ),
    (
        &["converge", "sod", "--levels", "28"],
        &["2147483648", "fewer particles"],
    ),
    (
        &["converge", "sod", "--ladder", "100,nine"],
        &["--ladder nine", "whole number"],
    ),
    (
        &["converge", "sod", "--ladder", "100,50,1e2"],
        &["100 twice", "once"],
    ),
    (
        &["converge", "sod", "--ladder", "50,100", "-n", "50"],
        &["--ladder", "cannot be used with"],
    ),
    (
        &["converge", "sod", "--ladder", "4,100"],
        &["level of 4 particles", "region 1", "more particles"],
    ),
    (
        &["converge", "sod", "--field", "mass"],
        &["mass", "pressure"],
    ),
    (&["converge", "sod", "--norm", "l3"], &["l3", "linf"]),
    (&["converge", "sod", "--scalar", "q3.4"], &["q3.4", "f32"]),
    (
        &["converge", "square", "--levels", "2"],
        &["no exact solution", "output", "acoustics1d"],
    ),
    (
        &["converge", "sod", "--out", "file/below"],
        &["cannot write", "--out"],
    ),
];

#[test]
fn converge_answers_bad_input_with_the_value_and_the_cure() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("file"), "").unwrap();
    answers(folder.path(), BAD_STUDIES);
}

#[test]
fn converge_prints_one_object_with_the_documented_keys_and_leaves_table_and_picture() {
    let folder = tempfile::tempdir().unwrap();
    let converge = |more: &[&str]| -> Value {
        let arguments = [&["converge", "sound-wave", "--json"], more].concat();
        let text = stdout(folder.path(), &arguments);
        assert_eq!(text.lines().count(), 1);
        serde_json::from_str(&text).unwrap()
    };
    let json = converge(&["--ladder", "50,25,100"]);
    assert_eq!(json["scenario"], "sound-wave");
    // The field that the scenario holds to a bound, in the norm for gas.
    assert_eq!(
        (&json["field"], &json["norm"]),
        (&"density".into(), &"l1".into())
    );
    let levels = json["levels"].as_array().unwrap();
    assert_eq!(levels.len(), 3);
    for (level, n) in levels.iter().zip([25.0, 50.0, 100.0]) {
        let number = |key: &str| level[key].as_f64().unwrap();
        assert_eq!(number("n"), n);
        assert!((number("h") * n - 1.0).abs() < 1e-12);
        assert!((number("eps") / number("h") - 1.0).abs() < 1e-3);
        assert!(0.0 < number("l1") && number("l1") < number("l2"));
        assert!(number("l2") < number("linf"));
    }
    // Second order in the spacing: the dispersion of leap-frog and the sums.
    let order = json["observed_order"].as_f64().unwrap();
    assert!((1.85..2.05).contains(&order), "{order}");
    assert!(json["predicted_order"].is_null() && json["guaranteed_order"].is_null());
    assert_eq!(json["orders"].as_array().unwrap().len(), 2);
    assert_eq!(json["warnings"].as_array().unwrap().len(), 0);

    let out = folder.path().join("out/converge-sound-wave");
    let mut table = csv::Reader::from_path(out.join("converge.csv")).unwrap();
    let heading = table
        .headers()
        .unwrap()
        .iter()
        .collect::<Vec<_>>()
        .join(" ");
    assert_eq!(heading, "n h eps l1 l2 linf order");
    let rows: Vec<_> = table.records().map(Result::unwrap).collect();
    assert_eq!((rows.len(), &rows[0][6]), (3, ""));
    // serde_json reads numbers to a unit of the last place.
    let [table, told] = [
        rows[2][3].parse().unwrap(),
        levels[2]["l1"].as_f64().unwrap(),
    ];
    assert!(
        (table - told).abs() <= f64::EPSILON * told,
        "{table} {told}"
    );
    let picture = std::fs::read_to_string(out.join("converge.svg")).unwrap();
    assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"));
    // Table, picture, and `.motes`, which lists them.
    assert_eq!(std::fs::read_dir(&out).unwrap().count(), 3);

    // A level is the run of that name.
    let run = stdout(folder.path(), &["run", "sound-wave", "-n", "50", "--json"]);
    let run: Value = serde_json::from_str(&run).unwrap();
    assert_eq!(run["errors"]["density"]["linf"], levels[1]["linf"]);

    // Two levels from a number on; of an amplitude of 1e-6 f32 sees rounding, which does not fall.
    let json = converge(&[
        "--levels", "2", "-n", "25", "--norm", "l2", "--scalar", "f32",
    ]);
    assert_eq!(json["levels"][1]["n"], 50);
    let warnings = json["warnings"].as_array().unwrap();
    let says = |part: &str| {
        warnings
            .iter()
            .any(|text| text.as_str().unwrap().contains(part))
    };
    assert!(
        says("from 2 levels") && says("stopped falling"),
        "{warnings:?}"
    );
}

#[test]
fn converge_prints_a_table_and_says_that_no_theorem_applies() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["converge", "sod", "--ladder", "112,225", "--out", "study"];
    let text = stdout(folder.path(), &arguments);
    for part in [
        "L1 order",
        "112",
        "225",
        "observed",
        "no theorem",
        "warning",
        "study",
    ] {
        assert!(text.contains(part), "no {part:?} in {text}");
    }
    assert!(folder.path().join("study/converge.csv").exists());
    // Doubts of all levels are told once, those of one with its number.
    let arguments = [
        "converge",
        "sod",
        "--ladder",
        "112,225",
        "--set",
        "time.end=1.0",
    ];
    let text = stdout(folder.path(), &arguments);
    assert_eq!(text.matches("reached the ends").count(), 1, "{text}");
}

/// Ctrl-C in a study: as in a run.
#[cfg(unix)]
#[test]
fn an_interrupt_ends_converge_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let mut study = Command::new(env!("CARGO_BIN_EXE_motes"))
        .current_dir(folder.path())
        .args(["converge", "sod", "--ladder", "20000,40000"])
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(500));
    let interrupt = Command::new("kill")
        .args(["-INT", &study.id().to_string()])
        .status()
        .unwrap();
    assert!(interrupt.success());
    assert_eq!(study.wait().unwrap().code(), Some(130));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// As in `motes run FILE 2>&1 | head -1`.
#[test]
fn errors_that_nobody_reads_keep_their_exit_code() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let mut program = std::process::Command::new(env!("CARGO_BIN_EXE_motes"));
    let status = program.args(["run", "nosuch"]).stderr(writer).status();
    assert_eq!(status.unwrap().code(), Some(2));
}

/// Whatever argument it is in, and whatever a file holds.
#[test]
fn a_long_argument_is_not_repeated_whole() {
    let folder = tempfile::tempdir().unwrap();
    let long = "y".repeat(50_000);
    let set = format!("material.gamma={long}");
    for arguments in [
        &["run", &long][..],
        &["run", "sod", "--scalar", &long],
        &["run", "sod", "-n", &long],
        &["run", "sod", "--set", &set],
        &["run", "sod", "--threads", &long],
        &["suite", &long],
        &["bench", &long],
        &["show", &long],
        &["converge", "sod", "--field", &long],
        &["converge", "sod", "--norm", &long],
    ] {
        let errors = failure(folder.path(), arguments, 2);
        assert!(
            errors.len() < 6000,
            "{}: {} bytes",
            arguments[0],
            errors.len()
        );
    }
}

/// No row of a table holds what no table reads; what nothing bounds is left empty.
#[test]
fn tables_hold_finite_numbers_or_nothing() {
    let folder = tempfile::tempdir().unwrap();
    for name in [
        "wall-day",
        "robin-wall",
        "layered-wall",
        "decay-chain",
        "sod",
    ] {
        stdout(
            folder.path(),
            &["run", name, "-n", "48", "--out", name, "--quiet"],
        );
        for table in ["series.csv", "particles.csv"] {
            let text = std::fs::read_to_string(folder.path().join(name).join(table)).unwrap();
            let fields = text.lines().skip(1).flat_map(|line| line.split(','));
            let odd = fields.filter(|field| {
                !field.is_empty() && field.parse().map_or(true, |x: f64| !x.is_finite())
            });
            assert_eq!(
                odd.collect::<Vec<_>>(),
                Vec::<&str>::new(),
                "{name}/{table}"
            );
        }
    }
}

#[test]
fn a_run_of_no_time_writes_its_start() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["sod", "acoustics1d", "wall-day"] {
        let snapshots = "output.snapshots={ every = 1.0, format = \"csv\" }";
        let arguments = [
            "run",
            name,
            "-n",
            "96",
            "--set",
            "time.end=0",
            "--set",
            snapshots,
        ];
        let text = stdout(folder.path(), &arguments);
        assert!(
            text.contains("to t = 0.0") && !text.contains("NaN"),
            "{text}"
        );
        let out = folder.path().join("out").join(name);
        let rows = |file: &str| {
            std::fs::read_to_string(out.join(file))
                .unwrap()
                .lines()
                .count()
        };
        assert_eq!(
            (
                rows("particles.csv"),
                rows("series.csv"),
                rows("snapshots.csv")
            ),
            (97, 2, 2)
        );
    }
}

/// Rows of the time series and snapshots, all families, in float.
#[test]
fn exact_times_are_met_and_without_them_no_bit_changes() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["sod", "telegraph", "heat1d"] {
        let json = |more: &[&str]| -> Value {
            let mut arguments = vec![
                "run",
                name,
                "-n",
                "225",
                "--json",
                "--set",
                "output.samples=7",
            ];
            arguments.extend(more);
            serde_json::from_str(&stdout(folder.path(), &arguments)).unwrap()
        };
        let plain = json(&[]);
        let end = plain["time"].as_f64().unwrap();
        let every = format!(
            "output.snapshots={{ every = {}, format = \"csv\" }}",
            end / 3.0
        );
        let looked = json(&["--set", &every]);
        assert_eq!(plain["digest"], looked["digest"], "{name}");
        let exact = json(&["--set", &every, "--set", "output.exact-times=true"]);
        assert_ne!(plain["digest"], exact["digest"], "{name}");
        assert_eq!(exact["time"].as_f64(), Some(end));
        let column = |file: &str, place: usize| -> Vec<f64> {
            let path = folder.path().join("out").join(name).join(file);
            let text = std::fs::read_to_string(path).unwrap();
            let rows = text.lines().skip(1);
            rows.map(|row| row.split(',').nth(place).unwrap().parse().unwrap())
                .collect()
        };
        let expected = |parts: u32| (0..=parts).map(move |i| end * f64::from(i) / f64::from(parts));
        for (times, parts) in [
            (column("series.csv", 0), 7),
            (column("snapshots.csv", 1), 3),
        ] {
            assert_eq!(times.len(), 1 + parts as usize, "{name}: {times:?}");
            for (time, expected) in times.iter().zip(expected(parts)) {
                assert!(
                    (time - expected).abs() <= 4e-16 * end,
                    "{name}: {time} for {expected}"
                );
            }
        }
        // None of the steps is a rounding.
        let [least, most] = [0, 1].map(|i| exact["time_step"][i].as_f64().unwrap());
        assert!(least > 1e-6 * most, "{name}: {least} to {most}");
    }
}
