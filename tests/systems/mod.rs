//! Linear systems and convection-diffusion run for tests, through the library.
#![allow(dead_code, reason = "every test uses its part of this module")]

#[path = "../runs/mod.rs"]
mod runs;
#[allow(unused_imports, reason = "a test of fixed point uses it")]
pub use runs::told;

use std::collections::BTreeMap;

use motes::experiment::{Experiment, ExperimentError};
use motes::run::{Norms, Outcome, RunError};
use motes::scenario::linear::{LinearScenario, System};
use motes::scenario::{AnyScenario, BUILT_IN};

/// The scenario with these changes.
pub fn scenario(name: &str, changes: &[&str]) -> LinearScenario {
    match runs::any_scenario(name, changes) {
        AnyScenario::Linear(scenario) => *scenario,
        AnyScenario::Gas(_) => panic!("{name} is a gas"),
    }
}

/// A run of it.
pub fn experiment(
    scenario: LinearScenario,
    scalar: &str,
    threads: usize,
) -> Result<Experiment, ExperimentError> {
    runs::try_experiment(AnyScenario::Linear(Box::new(scenario)), scalar, threads)
}

/// Why a run stopped.
pub fn stopped(result: Result<Experiment, ExperimentError>) -> RunError {
    match result.err() {
        Some(ExperimentError::Run(error)) => error,
        Some(error) => panic!("it did not begin: {error}"),
        None => panic!("it did not stop"),
    }
}

pub fn run(name: &str, scalar: &str, threads: usize, changes: &[&str]) -> Outcome {
    let scenario = scenario(name, changes);
    experiment(scenario, scalar, threads)
        .unwrap_or_else(|error| panic!("{name}: {error}"))
        .outcome
}

pub fn errors(name: &str, scalar: &str, changes: &[&str]) -> BTreeMap<String, Norms> {
    let scenario = scenario(name, changes);
    let experiment = experiment(scenario, scalar, 2).unwrap();
    experiment.errors.unwrap()
}

/// Every scenario of one of these systems that comes with the program: of convection-diffusion, or
/// of the others.
pub fn built_in(diffuses: bool) -> Vec<LinearScenario> {
    let all = BUILT_IN.iter();
    let all = all.map(|built_in| runs::any_scenario(built_in.name, &[]));
    let linear = all.filter_map(|scenario| match scenario {
        AnyScenario::Linear(scenario) => Some(*scenario),
        AnyScenario::Gas(_) => None,
    });
    let is_wanted = |scenario: &LinearScenario| {
        matches!(scenario.system, System::ConvectionDiffusion(_)) == diffuses
    };
    linear.filter(is_wanted).collect()
}

/// That a scenario keeps its tolerances, and by no great margin.
pub fn assert_tolerances(scenario: &LinearScenario) {
    assert!(!scenario.tolerances.is_empty(), "{}", scenario.name);
    // f32: positions are rounded to 3e-5 spacings at a distance of 512.
    for (scalar, room) in [("f64", 1.0), ("f32", 1.05)] {
        let experiment = experiment(scenario.clone(), scalar, 2).unwrap();
        let errors = experiment.errors.unwrap();
        for tolerance in experiment.scenario.tolerances() {
            let field = &tolerance.field;
            let error = errors[field].of(tolerance.norm);
            let (name, bound) = (&scenario.name, room * tolerance.value);
            assert!(
                error <= bound,
                "{name} in {scalar}: {field} {error} > {bound}"
            );
            // A bound that is far away says nothing.
            assert!(
                error > 0.6 * bound,
                "{name}: {field} {error}, tighten {bound}"
            );
        }
    }
}

/// That a scenario gives the same bits on any number of threads.
pub fn assert_same_bits(scenario: &LinearScenario, few: &[&str]) {
    let name = &scenario.name;
    let digest = |threads| run(name, "f32", threads, few).digest;
    let one = digest(1);
    assert_eq!(one, digest(2), "{name}");
    assert_eq!(one, digest(7), "{name}");
}
