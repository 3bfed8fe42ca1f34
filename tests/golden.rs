//! Golden digests: the bits of today are those of yesterday, on every target.
//!
//! The rows with the firmware's number of particles are checked on the Cortex-M4F by
//! `./check.sh devices` too. A row may only change with a line in CHANGELOG.md.

mod runs;

use runs::run;

#[test]
fn digests_are_those_of_the_table() {
    let mut table = csv::Reader::from_path("tests/golden.csv").unwrap();
    let mut rows = 0;
    for row in table.records() {
        let row = row.unwrap();
        let (name, particles, scalar, golden) = (&row[0], &row[1], &row[2], &row[3]);
        let change = format!("resolution.particles={particles}");
        let digest = run(name, scalar, 1, &[&change]).outcome.digest.to_string();
        assert_eq!(
            digest, golden,
            "{name} with {particles} particles in {scalar}"
        );
        rows += 1;
    }
    assert_eq!(rows, 8);
}

/// The firmware's tube is the one that the host would export today.
#[test]
fn the_firmware_holds_the_exported_tube() {
    let scenario = runs::scenario("sod", &["resolution.particles=225"]);
    let plan = motes::simulation::Plan::new(&scenario).unwrap();
    let exact = motes::comparison::ExactSolution::of(&scenario).unwrap();
    let exported =
        motes::export::tube(&scenario, &plan, exact.as_ref(), "motes export sod -n 225").unwrap();
    let held = std::fs::read_to_string("embedded/src/tube.rs").unwrap();
    assert!(
        exported == held,
        "run: cargo run --release -- export sod -n 225 > embedded/src/tube.rs"
    );
}
