//! `motes export`: the source of a scenario, compiled, has the digests of its run.
//!
//! `tests/exported` holds a scenario a file and what is exported of it. This makes the sources anew, after
//! a change of what is written:
//!
//!     cargo test --test export -- --ignored

mod exported;
mod runs;

use std::fs::{read_to_string, write};

use motes::export;
use motes::scenario::AnyScenario;

/// Every scenario of the folder.
const NAMES: [&str; 7] = [
    "block", "cloud", "medium", "reactor", "shear", "sound", "stream",
];

fn scenario(name: &str) -> AnyScenario {
    runs::any_scenario(&format!("tests/exported/{name}.toml"), &[])
}

fn source(name: &str) -> String {
    let command = format!("motes export tests/exported/{name}.toml");
    export::source(&scenario(name), &command).unwrap()
}

#[test]
fn the_sources_are_what_is_exported() {
    for name in NAMES {
        let held = read_to_string(format!("tests/exported/{name}.rs")).unwrap();
        assert!(
            held == source(name),
            "run: cargo run --release -- export tests/exported/{name}.toml > tests/exported/{name}.rs"
        );
    }
}

#[test]
#[ignore = "writes the sources"]
fn make_sources_anew() {
    for name in NAMES {
        write(format!("tests/exported/{name}.rs"), source(name)).unwrap();
    }
}

/// First-order systems in one, two and three dimensions, convection-diffusion in two and three, gas in two
/// and three; most of what they say is formulas.
#[test]
fn an_exported_run_has_the_digest_of_the_scenario() {
    for (name, scalar, digest) in exported::digests() {
        let outcome = runs::experiment(scenario(name), scalar, 2).outcome;
        assert!(outcome.steps > 2, "{name}: {} steps", outcome.steps);
        assert_eq!(digest.unwrap(), outcome.digest, "{name} in {scalar}");
    }
}
