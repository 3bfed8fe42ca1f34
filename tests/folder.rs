//! One run owns its folder: its files and no others are left there.

mod command;

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use command::{failure, motes, stdout};

/// The files below a folder but for the record.
fn files(folder: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in std::fs::read_dir(&next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap();
                found.insert(name.to_str().unwrap().replace('\\', "/"));
            }
        }
    }
    found.remove(".motes");
    found
}

/// A short run with snapshots.
fn arguments<'a>(out: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let run = [
        "run",
        "sod",
        "-n",
        "90",
        "--out",
        out,
        "--set",
        "time.end=0.05",
    ];
    [&run[..], more].concat()
}

const SNAPSHOTS: [&str; 2] = ["--set", "output.snapshots={every=0.01}"];
const AS_CSV: [&str; 2] = ["--set", "output.snapshots={every=0.02, format=\"csv\"}"];

#[test]
fn a_folder_that_is_used_again_holds_the_last_run_alone_and_what_is_not_of_motes() {
    let folder = tempfile::tempdir().unwrap();
    let shared = folder.path().join("shared");
    let run = |out: &str, more: &[&str]| {
        let output = motes(folder.path(), &arguments(out, more));
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stderr).unwrap()
    };
    assert_eq!(run("shared", &SNAPSHOTS), "");
    let first = files(&shared);
    assert!(first.contains("sod.pvd"), "{first:?}");
    // Files of the user, also ones that look like ours.
    let own = ["notes.txt", "snapshots/sod_9.vtu", "map.svg"];
    for name in own {
        std::fs::write(shared.join(name), "mine").unwrap();
    }
    let others: [&[&str]; 4] = [
        &AS_CSV,
        &["--set", "viscosity.kind=none", "--set", "time.end=0.01"],
        &SNAPSHOTS,
        &["--scalar", "f32"],
    ];
    for (place, more) in others.iter().enumerate() {
        let before = files(&shared).len() - own.len();
        let said = run("shared", more);
        assert!(
            said.contains(&format!("{before} files of an earlier run were removed")),
            "{said}"
        );
        let alone = format!("alone{place}");
        run(&alone, more);
        let mut expected = files(&folder.path().join(&alone));
        expected.extend(own.map(str::to_owned));
        assert_eq!(files(&shared), expected);
    }
    for name in own {
        assert_eq!(std::fs::read_to_string(shared.join(name)).unwrap(), "mine");
    }
}

/// Refused before its first step: by the reading, the plan, the solver at its start or in its first
/// step.
#[test]
fn a_run_that_is_refused_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |out: &str, more: &[&str], code: i32| {
        failure(
            folder.path(),
            &arguments(out, &[&SNAPSHOTS[..], more].concat()),
            code,
        )
    };
    let wrong: [(&[&str], i32); 4] = [
        (&["--set", "time.end=-1"], 2),
        (&["--set", "cut-off.eta=1e3"], 2),
        (&["--set", "cut-off.epsilon=0.035"], 1),
        (&["--set", "time.end=1e12"], 1),
    ];
    for (more, code) in wrong {
        refused("made/for/it", more, code);
        assert!(!folder.path().join("made").exists(), "{more:?}");
    }
    // In a folder of an earlier run that one stays as it was.
    stdout(folder.path(), &arguments("old", &["--quiet"]));
    let before = files(&folder.path().join("old"));
    for (more, code) in &wrong[..3] {
        refused("old", more, *code);
        assert_eq!(files(&folder.path().join("old")), before, "{more:?}");
    }
}

/// A run that takes long enough to be met.
fn long_run(folder: &Path) -> std::process::Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_motes"));
    let run = [
        "run",
        "sod",
        "-n",
        "4000",
        "--quiet",
        "--out",
        "busy",
        "--set",
        "time.end=20",
    ];
    let mut child = command
        .current_dir(folder)
        .args(run)
        .args(["--set", "output.snapshots={every=1e-5}"])
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let first = folder.join("busy/sod.pvd");
    let begun = Instant::now();
    while !first.exists() {
        assert!(
            begun.elapsed() < Duration::from_secs(120),
            "no first snapshot"
        );
        assert!(child.try_wait().unwrap().is_none(), "it has ended");
        std::thread::sleep(Duration::from_millis(20));
    }
    child
}

#[test]
fn a_second_run_in_a_folder_is_refused_until_the_first_has_ended_even_killed() {
    let folder = tempfile::tempdir().unwrap();
    let mut child = long_run(folder.path());
    let report = failure(folder.path(), &arguments("busy", &[]), 2);
    assert!(
        report.contains("another run of motes writes into `busy`"),
        "{report}"
    );
    assert!(report.contains("--out"), "{report}");
    child.kill().unwrap();
    child.wait().unwrap();
    // Killed amid its work: the next run takes the folder over, with all that lies there.
    let output = motes(folder.path(), &arguments("busy", &["--quiet"]));
    assert!(output.status.success(), "{output:?}");
    assert!(output.stderr.is_empty(), "{output:?}");
    let expected = ["figure.svg", "particles.csv", "scenario.toml", "series.csv"];
    assert_eq!(
        files(&folder.path().join("busy")),
        expected.map(str::to_owned).into()
    );
}

/// What a run reads is neither removed nor replaced by something else, also where an earlier run
/// wrote it.
#[test]
fn the_input_of_a_run_stays_where_it_is() {
    let folder = tempfile::tempdir().unwrap();
    stdout(folder.path(), &arguments("out", &AS_CSV));
    let scenario = std::fs::read_to_string(folder.path().join("out/scenario.toml")).unwrap();
    // Again, from the copy that lies there.
    let again = ["run", "out/scenario.toml", "--out", "out", "--quiet"];
    stdout(folder.path(), &again);
    assert_eq!(
        std::fs::read_to_string(folder.path().join("out/scenario.toml")).unwrap(),
        scenario
    );
    // On, from its particles.
    let on = |file: &str| {
        let text = format!(
            "name = \"on\"\ndimension = 1\n[domain]\nlower = [-1.0]\nupper = [1.0]\n\
             sides = [\"mirror\"]\n[material]\nequation-of-state = \"ideal-gas\"\ngamma = 1.4\n\
             [resolution]\narrangement = \"file\"\nfile = \"{file}\"\n[time]\nend = 0.01\n"
        );
        std::fs::write(folder.path().join("on.toml"), text).unwrap();
    };
    on("out/particles.csv");
    let report = failure(folder.path(), &["run", "on.toml", "--out", "out"], 2);
    assert!(
        report.contains("the run reads `out/particles.csv`"),
        "{report}"
    );
    assert!(report.contains("--out"), "{report}");
    stdout(
        folder.path(),
        &["run", "on.toml", "--out", "elsewhere", "--quiet"],
    );
    assert!(folder.path().join("out/particles.csv").exists());
    assert!(folder.path().join("out/snapshots.csv").exists());
    // Studies in the folder of the run leave the scenario that they read.
    let formats = ["--scalars", "f64,f32", "--out", "out", "--json"];
    stdout(
        folder.path(),
        &[&["compare", "out/scenario.toml"], &formats[..]].concat(),
    );
    let levels = ["--ladder", "112,225", "--out", "out", "--json"];
    stdout(
        folder.path(),
        &[&["converge", "out/scenario.toml"], &levels[..]].concat(),
    );
    assert_eq!(
        std::fs::read_to_string(folder.path().join("out/scenario.toml")).unwrap(),
        scenario
    );
}

/// A cloud that is called as a result is: the command says so and leaves it.
#[test]
fn a_comparison_does_not_write_over_the_cloud_that_it_reads() {
    let folder = tempfile::tempdir().unwrap();
    let run = [
        "run",
        "acoustics1d",
        "-n",
        "64",
        "--out",
        "first",
        "--quiet",
    ];
    stdout(folder.path(), &run);
    let cloud = folder.path().join("compare.csv");
    std::fs::copy(folder.path().join("first/particles.csv"), &cloud).unwrap();
    let before = std::fs::read(&cloud).unwrap();
    let reads = "resolution={ arrangement = \"file\", file = \"compare.csv\" }";
    let call = ["compare", "acoustics1d", "--out", ".", "--set", reads];
    let report = failure(folder.path(), &call, 2);
    assert!(
        report.contains("compare.csv`, which its results would"),
        "{report}"
    );
    assert!(report.contains("--out"), "{report}");
    assert_eq!(std::fs::read(&cloud).unwrap(), before);
}
