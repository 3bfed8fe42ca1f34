//! Particles are where, and what, a scenario says.

mod cloud;
mod contradictions;
mod glass;
mod lattices;
mod profiles;
mod regions;

use super::*;
use crate::scenario::Source;

/// A scenario of a domain, what fills it, and its resolution.
fn text(dimension: usize, domain: &str, gas: &str, resolution: &str) -> String {
    format!(
        "name = \"test\"\ndimension = {dimension}\n[domain]\n{domain}\n{gas}\n[resolution]\n\
         {resolution}\n[cut-off]\nname = \"wendland-c2\"\neta = 1.5\n\
         [viscosity]\nkind = \"none\"\n[time]\nend = 1.0\n"
    )
}

/// Reads a scenario from a folder of its own, with a file `cloud.csv` beside it.
#[track_caller]
fn scenario_beside(text: &str, cloud: &str) -> (Scenario, tempfile::TempDir) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("cloud.csv"), cloud).unwrap();
    let path = folder.path().join("test.toml");
    std::fs::write(&path, text).unwrap();
    match Scenario::read(Source::File(path), &[]) {
        Ok(scenario) => (scenario, folder),
        Err(error) => panic!("{error}: {:?}\n{text}", error.line_and_column()),
    }
}

#[track_caller]
fn scenario(text: &str) -> Scenario {
    scenario_beside(text, "").0
}

const IDEAL: &str = "[material]\nequation-of-state = \"ideal-gas\"\ngamma = 1.4\n";

/// The unit box with these sides, full of gas of density 2.
fn unit_box(dimension: usize, side: &str, resolution: &str) -> Scenario {
    let vector = |x: f64| format!("{:?}", vec![x; dimension]);
    let corners = format!("lower = {}\nupper = {}\n", vector(0.0), vector(1.0));
    let sides = format!("{corners}sides = {:?}", vec![side; dimension]);
    let velocity = vector(0.0);
    let gas = format!(
        "[[region]]\n{corners}density = 2.0\nvelocity = {velocity}\npressure = 1.0\n{IDEAL}"
    );
    scenario(&text(dimension, &sides, &gas, resolution))
}

fn mass(particles: &[Placed]) -> f64 {
    particles.iter().map(|particle| particle.mass).sum()
}

#[track_caller]
fn assert_near(value: f64, expected: f64, relative: f64) {
    let off = value / expected - 1.0;
    assert!(
        off.abs() <= relative,
        "{value} is off {expected} by {off:e}, allowed {relative:e}"
    );
}

/// `a - b` in the unit box with periodic sides, the shortest way.
fn shortest(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| {
        let r = a[i] - b[i];
        r - r.round()
    })
}

fn length(r: [f64; 3]) -> f64 {
    r.iter().map(|x| x * x).sum::<f64>().sqrt()
}
