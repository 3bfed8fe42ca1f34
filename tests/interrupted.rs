//! `motes resume` after whatever ends a run: the files of a run that was never interrupted.
#![cfg(unix)]

mod command;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use command::{failure, motes, stdout};

/// A run of a second or more, so that signals and kills meet it on its way, with snapshots and a map.
const RUN: [&str; 12] = [
    "run",
    "sedov2d",
    "-n",
    "1600",
    "--out",
    "out",
    "--set",
    "output.snapshots.steps=150",
    "--set",
    "time.end=0.3",
    "--threads",
    "1",
];

fn begun(folder: &Path, arguments: &[&str]) -> Child {
    let mut run = Command::new(env!("CARGO_BIN_EXE_motes"));
    let run = run.current_dir(folder).args(arguments);
    run.stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn send(signal: &str, run: &Child) {
    let id = run.id().to_string();
    let sent = Command::new("kill").args([signal, &id]).status().unwrap();
    assert!(sent.success());
}

/// Waits until a run has written a checkpoint that is not among those known.
fn await_checkpoint(run: &mut Child, folder: &Path, known: usize) {
    let checkpoints = folder.join("out/checkpoints");
    while checkpoints.read_dir().map_or(0, Iterator::count) <= known {
        assert!(run.try_wait().unwrap().is_none(), "it ended");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// All files of a run but its checkpoints and its record, whose order may be another.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(inner) = folders.pop() {
        for entry in inner.read_dir().unwrap() {
            let path = entry.unwrap().path();
            let name = path.strip_prefix(folder).unwrap().to_owned();
            if path.is_dir() {
                folders.push(path);
            } else if !name.starts_with("checkpoints") && name != Path::new(".motes") {
                files.insert(name, std::fs::read(&path).unwrap());
            }
        }
    }
    files
}

/// Whether two runs left the same files with the same bytes.
fn compare(got: &BTreeMap<PathBuf, Vec<u8>>, expected: &BTreeMap<PathBuf, Vec<u8>>) {
    let names = |files: &BTreeMap<PathBuf, Vec<u8>>| -> Vec<_> { files.keys().cloned().collect() };
    assert_eq!(names(got), names(expected));
    for (name, bytes) in got {
        assert!(*bytes == expected[name], "{}", name.display());
    }
}

/// The files of the run that was never interrupted.
fn uninterrupted() -> BTreeMap<PathBuf, Vec<u8>> {
    let folder = tempfile::tempdir().unwrap();
    stdout(folder.path(), &RUN);
    let files = files(&folder.path().join("out"));
    assert!(files.keys().any(|name| name.ends_with("map.svg")));
    files
}

#[test]
fn a_run_that_is_asked_to_end_keeps_its_state_and_goes_on_to_the_same_files() {
    let expected = uninterrupted();
    for signal in ["-INT", "-TERM", "-HUP"] {
        let folder = tempfile::tempdir().unwrap();
        let mut every = RUN.to_vec();
        every.extend(["--checkpoint-every", "20"]);
        let mut run = begun(folder.path(), &every);
        await_checkpoint(&mut run, folder.path(), 0);
        send(signal, &run);
        let output = run.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130), "{signal}");
        let errors = String::from_utf8(output.stderr).unwrap();
        assert!(errors.contains("`motes resume out` goes on"), "{errors}");
        let told = stdout(folder.path(), &["inspect", "out"]);
        assert!(told.contains("sedov2d (built in)"), "{told}");
        let json = stdout(
            folder.path(),
            &["resume", "out", "--json", "--threads", "2"],
        );
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert!(json["digest"].is_string());
        compare(&files(&folder.path().join("out")), &expected);
    }
}

/// Kills a run, and what goes on with it, until it has come to its end.
fn survives(expected: &BTreeMap<PathBuf, Vec<u8>>, kills: u64, seed: u64) {
    let mut seed = seed;
    let mut killed = 0;
    while killed < kills {
        let folder = tempfile::tempdir().unwrap();
        let mut every = RUN.to_vec();
        every.extend(["--checkpoint-every", "20"]);
        loop {
            let kept = || folder.path().join("out/checkpoints").read_dir();
            let whole = kept().into_iter().flatten().flatten();
            let has_any = whole.into_iter().any(|entry| {
                let name = entry.file_name();
                name.to_string_lossy().ends_with(".motes")
            });
            let resumed = [
                "resume",
                "out",
                "--threads",
                "1",
                "--checkpoint-every",
                "20",
            ];
            let mut run = begun(folder.path(), if has_any { &resumed } else { &every });
            // Knuth's generator: any moment of the run.
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            std::thread::sleep(Duration::from_micros(seed >> 44));
            if run.try_wait().unwrap().is_some() {
                let output = run.wait_with_output().unwrap();
                let errors = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "{errors}");
                break;
            }
            run.kill().unwrap();
            run.wait().unwrap();
            killed += 1;
        }
        let left = files(&folder.path().join("out"));
        let stray = left
            .keys()
            .find(|name| name.to_string_lossy().contains(".motes-"));
        assert_eq!(stray, None);
        compare(&left, expected);
    }
}

#[test]
fn a_run_that_is_killed_at_any_moment_goes_on_to_the_same_files() {
    survives(&uninterrupted(), 12, 1);
}

/// `cargo test --release --test interrupted -- --ignored`
#[test]
#[ignore = "takes minutes"]
fn two_hundred_of_two_hundred_kills_are_survived() {
    survives(&uninterrupted(), 200, 2);
}

#[test]
fn a_damaged_checkpoint_is_passed_over_and_named() {
    let folder = tempfile::tempdir().unwrap();
    let run = [
        "run",
        "sod",
        "-n",
        "225",
        "--out",
        "out",
        "--checkpoint-every",
        "100",
        "--json",
    ];
    let digest = |json: String| {
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        json["digest"].clone()
    };
    let expected = digest(stdout(folder.path(), &run));
    let [older, newer] = ["step_000200.motes", "step_000300.motes"]
        .map(|name| folder.path().join("out/checkpoints").join(name));
    let spoil = |file: &Path| {
        let mut bytes = std::fs::read(file).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        std::fs::write(file, bytes).unwrap();
    };
    spoil(&newer);
    let output = motes(folder.path(), &["resume", "out", "--json"]);
    assert!(output.status.success());
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(
        errors.contains("damaged") && errors.contains("step_000200"),
        "{errors}"
    );
    assert_eq!(digest(String::from_utf8(output.stdout).unwrap()), expected);
    spoil(&older);
    let errors = failure(folder.path(), &["resume", "out"], 2);
    assert!(
        errors.contains("damaged: its XXH64") && errors.contains("anew"),
        "{errors}"
    );
    let errors = failure(folder.path(), &["inspect", "out/particles.csv"], 2);
    assert!(errors.contains("no checkpoint of motes"), "{errors}");
    let errors = failure(folder.path(), &["resume", "."], 2);
    assert!(errors.contains("holds no checkpoints"), "{errors}");
}

#[test]
fn a_file_that_the_scenario_reads_must_be_the_one_that_the_run_began_with() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    for (name, file) in [("wall-day", "mine.toml"), ("wall-day.csv", "wall-day.csv")] {
        std::fs::write(at(file), stdout(folder.path(), &["show", name])).unwrap();
    }
    let run = [
        "run",
        "mine.toml",
        "--out",
        "out",
        "--checkpoint-every",
        "5",
        "--quiet",
    ];
    stdout(folder.path(), &run);
    let expected = files(&at("out"));
    // The scenario itself may be gone: the checkpoint holds it.
    std::fs::remove_file(at("mine.toml")).unwrap();
    stdout(folder.path(), &["resume", "out", "--quiet"]);
    compare(&files(&at("out")), &expected);
    let text = std::fs::read_to_string(at("wall-day.csv")).unwrap();
    std::fs::write(at("wall-day.csv"), text.clone() + "80,1\n").unwrap();
    let errors = failure(folder.path(), &["resume", "out"], 2);
    assert!(errors.contains("`wall-day.csv` has changed"), "{errors}");
    std::fs::remove_file(at("wall-day.csv")).unwrap();
    let errors = failure(folder.path(), &["resume", "out"], 2);
    assert!(errors.contains("wall-day.csv"), "{errors}");
}
