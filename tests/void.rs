//! Empty space around a gas changes nothing, wherever the gas lies in it.

mod runs;

use std::fmt::Write as _;

/// A slab of gas in a domain of free sides.
fn slab([lower, upper]: [f64; 2]) -> String {
    let mut text =
        "name = \"slab\"\ndescription = \"A slab in a void\"\ndimension = 1\n".to_owned();
    write!(
        text,
        "[domain]\nlower = [{lower:?}]\nupper = [{upper:?}]\nsides = [\"free\"]\n\
         [[region]]\nlower = [-0.5]\nupper = [0.25]\ndensity = 1.5\nvelocity = [0.0]\npressure = 1.0\n\
         [[region]]\nlower = [0.25]\nupper = [0.5]\ndensity = 0.75\nvelocity = [0.5]\npressure = 0.5\n\
         [material]\nequation-of-state = \"ideal-gas\"\ngamma = 1.4\n\
         [resolution]\nparticles = 90\narrangement = \"equal-mass\"\n[time]\nend = 0.2\n"
    )
    .unwrap();
    text
}

/// Digest and largest velocity of a run.
fn run(domain: [f64; 2], scalar: &str) -> (String, f64) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("slab.toml");
    std::fs::write(&file, slab(domain)).unwrap();
    let experiment = runs::experiment(runs::any_scenario(file.to_str().unwrap(), &[]), scalar, 1);
    let velocity = experiment.simulation.spread("velocity").unwrap();
    (experiment.outcome.digest.to_string(), velocity.max)
}

#[test]
fn empty_space_around_a_gas_changes_no_bit() {
    let fixed: &[&str] = match cfg!(feature = "fixed-point") {
        true => &["q12.19"],
        false => &[],
    };
    let (_, right) = run([-1.0, 1.0], "f64");
    assert!(right > 1.0, "{right}");
    for scalar in ["f64", "f32"].iter().chain(fixed) {
        let (first, velocity) = run([-1.0, 1.0], scalar);
        assert!(
            (velocity / right - 1.0).abs() < 0.01,
            "{scalar}: {velocity}, in f64 {right}"
        );
        for domain in [[-10.0, 10.0], [-1.0, 200.0], [-1000.0, 3.0]] {
            assert_eq!(run(domain, scalar).0, first, "{scalar} in {domain:?}");
        }
    }
}
