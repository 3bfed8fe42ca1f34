//! `motes compare` as a user and a script meet it.

mod command;

use std::path::Path;
use std::process::Command;

use command::{failure, stdout};
use serde_json::Value;

/// What the command prints with `--json`.
fn compare(folder: &Path, arguments: &[&str]) -> Value {
    let all = [&["compare", "--json"], arguments].concat();
    let text = stdout(folder, &all);
    assert_eq!(text.lines().count(), 1);
    serde_json::from_str(&text).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

#[test]
fn a_row_is_the_run_of_that_format_and_its_difference_from_the_finest() {
    let folder = tempfile::tempdir().unwrap();
    let sod = ["sod", "-n", "225", "--scalars", "f32,f64"];
    let json = compare(folder.path(), &sod);
    assert_eq!(json["scenario"], "sod");
    assert_eq!(json["reference"], "f64");
    assert_eq!(json["field"], "density");
    assert_eq!(json["particles"], 225);
    assert!((number(&json["time"]) - 0.2).abs() < 1e-12);
    // In the order they were asked for.
    let (single, double) = (&json["rows"][0], &json["rows"][1]);
    for (row, scalar, bits, bytes) in [(single, "f32", 23, 4), (double, "f64", 52, 8)] {
        assert_eq!(row["scalar"], scalar);
        assert_eq!(row["fraction_bits"], bits);
        assert_eq!(row["range"], "float");
        // Positions, velocities, their remainders and twelve more numbers, and the material: what the
        // next step of a gas starts from.
        assert_eq!(row["bytes_per_particle"], 16 * bytes + 1);
        let run = ["run", "sod", "-n", "225", "--json", "--scalar", scalar];
        let run: Value = serde_json::from_str(&stdout(folder.path(), &run)).unwrap();
        for key in ["digest", "steps", "errors", "drift", "time"] {
            assert_eq!(row[key], run[key], "{scalar}: {key}");
        }
        assert!(number(&row["steps_per_second"]) > 0.0);
    }
    assert!(double["difference"].is_null());
    let mut fields: Vec<_> = single["difference"].as_object().unwrap().iter().collect();
    assert_eq!(fields.len(), 5);
    fields.retain(|(name, _)| *name != "position");
    for (field, norms) in fields {
        let [l1, l2, linf] = ["l1", "l2", "linf"].map(|norm| number(&norms[norm]));
        assert!(0.0 < l1 && l1 < l2 && l2 < linf, "{field}: {norms}");
        // Half a unit of the last place is the least that rounding does, and some hundred steps of it
        // add up to less than all the units of the last place that they could.
        let (bits, steps) = (number(&norms["bits"]), number(&single["steps"]));
        assert!(bits < 25.0 && bits > 23.0 - steps.log2(), "{field}: {bits}");
        assert!((bits + number(&norms["relative_l2"]).log2()).abs() < 1e-9);
    }
    // The floor is the error of the reference over the size of the field.
    let floor = number(&double["errors"]["density"]["l2"]) / number(&json["size"]);
    assert!((number(&json["rounding"]["floor"]) / floor - 1.0).abs() < 1e-12);
    assert_eq!(json["rounding"]["enough"][0], "f32");
    assert!(json["rounding"]["slope"].is_null());

    let out = folder.path().join("out/compare-sod");
    let mut table = csv::Reader::from_path(out.join("compare.csv")).unwrap();
    let heading = table.headers().unwrap().clone();
    let column = |name: &str| heading.iter().position(|known| known == name).unwrap();
    let rows: Vec<_> = table.records().map(Result::unwrap).collect();
    let density = rows
        .iter()
        .find(|row| &row[0] == "f32" && &row[column("field")] == "density")
        .unwrap();
    let told: f64 = density[column("difference_l1")].parse().unwrap();
    let printed = number(&single["difference"]["density"]["l1"]);
    assert!((told - printed).abs() <= f64::EPSILON * printed);
    let picture = std::fs::read_to_string(out.join("compare.svg")).unwrap();
    assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"));
    // One difference, two errors, and the two of the legend.
    assert_eq!(picture.matches("<circle").count(), 5);
    let text = std::fs::read_to_string(out.join("compare.md")).unwrap();
    for part in [
        "\n    motes compare sod --scalars f32,f64 -n 225\n",
        "| f32 | float |",
        "(compare.svg)",
    ] {
        assert!(text.contains(part), "no {part:?} in {text}");
    }
    // Three files, and `.motes`, which lists them.
    assert_eq!(std::fs::read_dir(&out).unwrap().count(), 4);
}

#[test]
fn results_do_not_depend_on_how_many_runs_there_are_at_a_time() {
    let folder = tempfile::tempdir().unwrap();
    let [one, many] = ["1", "5"].map(|threads| {
        let arguments = [
            "acoustics1d",
            "-n",
            "64",
            "--scalars",
            "f64,f32",
            "--threads",
            threads,
        ];
        let mut json = compare(folder.path(), &arguments);
        for row in json["rows"].as_array_mut().unwrap() {
            for clock in ["seconds", "steps_per_second"] {
                row[clock].take();
            }
        }
        json
    });
    assert_eq!(one, many);
}

/// Every family, in one to three dimensions: single precision loses something, and far less than half of
/// its digits in the field of the first table.
#[test]
fn every_family_is_compared_in_every_dimension() {
    let folder = tempfile::tempdir().unwrap();
    for (name, particles, field) in [
        ("sod", "112", "density"),
        ("yee-vortex", "400", "density"),
        ("sedov3d", "1000", "density"),
        ("telegraph", "64", "state"),
        ("transport-rotation", "400", "reconstruction"),
        ("acoustics3d", "1728", "state"),
        ("heat1d", "64", "state"),
        ("shear-gaussian", "256", "state"),
        ("heat3d", "1728", "state"),
    ] {
        let more = [
            "-n",
            particles,
            "--set",
            "time.end=0.01",
            "--scalars",
            "f64,f32",
        ];
        let json = compare(folder.path(), &[&[name], &more[..]].concat());
        assert_eq!(json["field"], field, "{name}");
        let bits = number(&json["rows"][1]["difference"][field]["bits"]);
        assert!(bits > 12.0 && bits < 30.0, "{name}: {bits} of {json}");
        assert!(
            json["rows"][1]["difference"]["position"].is_object(),
            "{name}"
        );
    }
}

/// A file without an exact solution, with another field and a folder of choice.
#[test]
fn a_scenario_of_ones_own_needs_no_exact_solution() {
    let folder = tempfile::tempdir().unwrap();
    let text = stdout(folder.path(), &["show", "square"]);
    let text = text.replace("name = \"square\"", "name = \"patch\"");
    std::fs::write(folder.path().join("patch.toml"), text).unwrap();
    let arguments = [
        "patch.toml",
        "-n",
        "400",
        "--set",
        "time.end=0.02",
        "--field",
        "pressure",
        "--scalars",
        "f64,f32",
        "--out",
        "here",
    ];
    let json = compare(folder.path(), &arguments);
    assert_eq!(
        (&json["scenario"], &json["field"]),
        (&"patch".into(), &"pressure".into())
    );
    assert!(json["rows"][0]["errors"].is_null() && json["rounding"]["floor"].is_null());
    assert!(number(&json["rows"][1]["difference"]["pressure"]["bits"]) > 10.0);
    assert!(folder.path().join("here/compare.svg").exists());
    let text = stdout(folder.path(), &[&["compare"], &arguments[..]].concat());
    for part in [
        "format",
        "steps/s",
        "bits kept",
        "drift",
        "here",
        "compared with f64",
    ] {
        assert!(text.contains(part), "no {part:?} in {text}");
    }
    assert!(!text.contains("floor"), "{text}");
}

/// A pressure that single precision does not have: a row with the reason, and no end of the command.
#[test]
fn a_format_that_cannot_hold_the_scenario_is_a_row_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let cold = ["noh1d", "-n", "50", "--set", "profile.pressure=1e-60"];
    let json = compare(
        folder.path(),
        &[&cold[..], &["--scalars", "f32,f64"]].concat(),
    );
    let row = &json["rows"][0];
    let reason = row["refused"].as_str().unwrap();
    assert!(reason.contains("`f32` cannot hold"), "{reason}");
    assert!(row["cure"].as_str().unwrap().contains("f64"), "{row}");
    assert_eq!(json["rows"][1]["scalar"], "f64");
    assert!(json["rows"][1]["steps"].is_u64() && json["rows"][1]["refused"].is_null());
    let table =
        std::fs::read_to_string(folder.path().join("out/compare-noh1d/compare.csv")).unwrap();
    assert!(table.contains(reason), "{table}");
    let text = stdout(
        folder.path(),
        &[&["compare"], &cold[..], &["--scalars", "f64,f32"]].concat(),
    );
    assert!(
        text.contains("f32 did not run: ") && text.contains("cure: "),
        "{text}"
    );

    // None at all: as of a run, and nothing is left.
    let other = tempfile::tempdir().unwrap();
    let errors = failure(
        other.path(),
        &[&["compare"], &cold[..], &["--scalars", "f32"]].concat(),
        2,
    );
    assert!(errors.contains("none of 1 formats ran"), "{errors}");
    assert_eq!(std::fs::read_dir(other.path()).unwrap().count(), 0);
}

/// A run that stops on its way is a row, too; of none that ended the code is 1.
#[test]
fn runs_that_would_take_years_end_the_command_with_code_one() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = [
        "compare",
        "sod",
        "-n",
        "20000",
        "--scalars",
        "f64,f32",
        "--longest",
        "1e-9",
    ];
    let errors = failure(folder.path(), &arguments, 1);
    assert!(errors.contains("none of 2 formats ran"), "{errors}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn particles_that_come_and_go_have_no_partners() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = [
        "wind-tunnel",
        "-n",
        "300",
        "--set",
        "time.end=0.05",
        "--scalars",
        "f64,f32",
    ];
    let json = compare(folder.path(), &arguments);
    assert!(json["rows"][1]["difference"].is_null());
    let warnings = json["warnings"].to_string();
    assert!(
        warnings.contains("f32: no differences: particles come and go"),
        "{warnings}"
    );
}

#[test]
fn bad_input_is_answered_with_the_value_and_the_cure() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("file"), "").unwrap();
    let long = "f".repeat(50_000);
    let calls: &[(&[&str], &[&str])] = &[
        (&["nosuch"], &["nosuch"]),
        (
            &["sod", "--scalars", "f64,q3.4"],
            &["q3.4", "this build has f64"],
        ),
        (&["sod", "--scalars", "f32,f32"], &["f32 twice", "once"]),
        (&["sod", "--scalars", ""], &["unknown scalar"]),
        (&["sod", "--scalars", &long], &["unknown scalar"]),
        (
            &["sod", "--field", "mass"],
            &["`mass`", "density, velocity"],
        ),
        (
            &["acoustics1d", "--field", "energy_norm"],
            &["energy_norm", "reconstruction"],
        ),
        (&["sod", "--bits", "20..8"], &["20..8", "the smaller first"]),
        (&["sod", "--bits", "8"], &["--bits 8", "8..28"]),
        (&["sod", "--bits", "8..x"], &["8..x", "whole numbers"]),
        (
            &["sod", "--bits", "60..62"],
            &["60 to 62 bits", "this build has"],
        ),
        (
            &["sod", "--bits", "8..28", "--scalars", "f32"],
            &["cannot be used with"],
        ),
        (&["sod", "-n", "0"], &["--particles 0", "above 0"]),
        (&["sod", "--threads", "5000"], &["5000", "--threads 0"]),
        (&["sod", "--out", "file/below"], &["cannot write", "--out"]),
    ];
    for (arguments, parts) in calls {
        let errors = failure(folder.path(), &[&["compare"], *arguments].concat(), 2);
        let flat = errors.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(flat.len() < 6000, "{} bytes", flat.len());
        for part in *parts {
            assert!(flat.contains(part), "{part:?} is not in {flat:.300}");
        }
    }
}

/// As in a run: nothing is left.
#[cfg(unix)]
#[test]
fn an_interrupt_ends_all_runs_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let mut runs = Command::new(env!("CARGO_BIN_EXE_motes"))
        .current_dir(folder.path())
        .args([
            "compare",
            "sod",
            "-n",
            "20000",
            "--scalars",
            "f64,f32",
            "--set",
            "time.end=10",
        ])
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(500));
    let interrupt = Command::new("kill")
        .args(["-INT", &runs.id().to_string()])
        .status()
        .unwrap();
    assert!(interrupt.success());
    assert_eq!(runs.wait().unwrap().code(), Some(130));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// Sod's tube with 400 particles to the left and 50 to the right: how far rounding moves the error of
/// the method.
#[cfg(feature = "fixed-point")]
#[test]
fn fixed_point_keeps_the_error_of_the_tube() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["sod", "-n", "450", "--scalars", "f64,q31.32,q12.19,q15.16"];
    let json = compare(folder.path(), &arguments);
    let row = |place: usize| &json["rows"][place];
    let error = |place: usize| number(&row(place)["errors"]["density"]["l1"]);
    for (place, part) in [(1, 1e-3), (2, 0.02), (3, 0.2)] {
        let off = (error(place) / error(0) - 1.0).abs();
        assert!(off <= part, "{}: {off}", row(place)["scalar"]);
        assert_eq!(row(place)["range"], "proven");
    }
    // A bit of difference a bit, to a fifth: with shorter words steps are shorter, too.
    let slope = number(&json["rounding"]["slope"]);
    assert!((slope + 1.0).abs() < 0.2, "{slope}");
    assert_eq!(json["rounding"]["formats"].as_array().unwrap().len(), 3);
    // Strengths are kept in double width: 1 + 1 + 2 numbers and 2 of twice their width.
    let arguments = ["acoustics1d", "-n", "64", "--scalars", "f64,q15.16"];
    let json = compare(folder.path(), &arguments);
    assert_eq!(json["rows"][0]["bytes_per_particle"], 6 * 8);
    assert_eq!(json["rows"][1]["bytes_per_particle"], 4 * 4 + 2 * 8);
}

/// Heat: a sweep over the formats of the build.
#[cfg(feature = "fixed-point")]
#[test]
fn a_sweep_takes_the_fixed_point_formats_with_so_many_bits() {
    let folder = tempfile::tempdir().unwrap();
    let json = compare(folder.path(), &["heat1d", "-n", "64", "--bits", "16..32"]);
    let names: Vec<&str> = json["rows"]
        .as_array()
        .unwrap()
        .iter()
        .map(|row| row["scalar"].as_str().unwrap())
        .collect();
    assert_eq!(names[..2], ["f64", "q31.32"]);
    assert_eq!(names[names.len() - 1], "q15.16");
    // Whether there are more formats than the build has.
    let note = json["warnings"].to_string();
    let is_part = note.contains("a sweep takes formats that are compiled: this build has q31.32,");
    assert_eq!(is_part, cfg!(not(feature = "every-scalar")), "{note}");
    let slope = number(&json["rounding"]["slope"]);
    assert!((slope + 1.0).abs() < 0.2, "{slope}");
}
