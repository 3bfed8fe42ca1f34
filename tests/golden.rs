//! Golden digests: the bits of today are those of yesterday, on every target.
//!
//! The rows with the firmware's numbers of particles are checked on the Cortex-M4F by
//! `./check.sh devices` too, some of them on a Cortex-M0 as well. A row may only change with a line
//! in CHANGELOG.md. This makes the table and what the firmware holds anew, after a change of a
//! built-in scenario:
//!
//!     cargo test --release --test golden -- --ignored

mod runs;

use std::fs::{read_to_string, write};

use motes::export;

const TABLE: &str = "tests/golden.csv";

/// What the table has: a scenario with some particles in some scalars.
///
/// Numbers of particles that the firmware has (225, 64, 96) are for rows that it runs.
const ROWS: [(&str, usize, &[&str]); 13] = [
    ("sod", 225, &["f64", "f32", "q12.19", "q31.32"]),
    ("sod", 900, &["f64", "f32", "q12.19", "q31.32"]),
    ("acoustics1d", 64, &LINE),
    ("telegraph", 64, &LINE),
    ("wall-day", 96, &["f64", "f32", "q15.16", "q31.32"]),
    ("sedov2d", 1000, &SPACE),
    ("noh3d", 1000, &SPACE),
    ("couette", 384, &FLOATS),
    ("taylor-green", 256, &FLOATS),
    ("acoustics2d", 400, &SPACE),
    ("acoustics3d", 3375, &SPACE),
    ("heat2d", 400, &SPACE),
    ("heat3d", 1000, &SPACE),
];

const FLOATS: [&str; 2] = ["f64", "f32"];

const SPACE: [&str; 3] = ["f64", "f32", "q31.32"];

const LINE: [&str; 5] = ["f64", "f32", "q12.19", "q15.16", "q31.32"];

/// What the firmware holds: a scenario with some particles in a file.
const EXPORTS: [(&str, usize, &str); 4] = [
    ("sod", 225, "embedded/src/tube.rs"),
    ("acoustics1d", 64, "embedded/src/acoustics.rs"),
    ("telegraph", 64, "embedded/src/telegraph.rs"),
    ("wall-day", 96, "embedded/src/wall.rs"),
];

/// The digest of a run on a server.
fn digest(name: &str, particles: usize, scalar: &str) -> String {
    let change = format!("resolution.particles={particles}");
    runs::outcome(name, scalar, 2, &[&change])
        .digest
        .to_string()
}

/// The table, made anew.
fn table() -> String {
    let mut text = "scenario,particles,scalar,digest\n".to_owned();
    for (name, particles, scalars) in ROWS {
        for scalar in scalars {
            let digest = digest(name, particles, scalar);
            text += &format!("{name},{particles},{scalar},{digest}\n");
        }
    }
    text
}

/// What `motes export` writes of a scenario.
fn exported(name: &str, particles: usize) -> String {
    let command = format!("motes export {name} -n {particles}");
    let change = format!("resolution.particles={particles}");
    export::source(&runs::any_scenario(name, &[&change]), &command).unwrap()
}

#[test]
fn digests_are_those_of_the_table() {
    let (held, made) = (read_to_string(TABLE).unwrap(), table());
    for (held, made) in held.lines().zip(made.lines()) {
        assert_eq!(made, held, "made, and in {TABLE}");
    }
    assert_eq!(made.lines().count(), held.lines().count());
}

#[test]
fn the_firmware_holds_what_is_exported() {
    for (name, particles, file) in EXPORTS {
        assert!(
            exported(name, particles) == read_to_string(file).unwrap(),
            "run: cargo run --release -- export {name} -n {particles} > {file}"
        );
    }
}

#[test]
#[ignore = "writes the table and the sources of the firmware"]
fn make_all_anew() {
    write(TABLE, table()).unwrap();
    for (name, particles, file) in EXPORTS {
        write(file, exported(name, particles)).unwrap();
    }
}
