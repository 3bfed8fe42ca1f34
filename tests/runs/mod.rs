//! Runs of scenarios for tests, through the library.
#![allow(dead_code, reason = "every test uses its part of this module")]

use std::collections::BTreeMap;

use motes::comparison::{ExactSolution, Norms, norms};
use motes::engine::Threads;
use motes::scenario::{AnyScenario, Scenario, Source};
use motes::simulation::{self, Control, Outcome, Plan, RunError};

/// What a test wants of a run.
#[derive(Debug)]
pub struct Run {
    pub outcome: Outcome,
    pub errors: BTreeMap<&'static str, Norms>,
}

impl Run {
    /// The L1 error of a field.
    pub fn l1(&self, field: &str) -> f64 {
        self.errors[field].l1
    }
}

/// The gas scenario with these changes.
pub fn scenario(name: &str, changes: &[&str]) -> Scenario {
    match any_scenario(name, changes) {
        AnyScenario::Gas(scenario) => *scenario,
        AnyScenario::Linear(_) => panic!("{name} is a linear system"),
    }
}

/// The scenario of either family with these changes.
pub fn any_scenario(name: &str, changes: &[&str]) -> AnyScenario {
    let changes: Vec<String> = changes.iter().map(|change| (*change).to_owned()).collect();
    AnyScenario::read(Source::BuiltIn(name.to_owned()), &changes).unwrap()
}

/// Runs a built-in scenario with these changes, one scalar and a number of threads.
pub fn run(name: &str, scalar: &str, threads: usize, changes: &[&str]) -> Run {
    try_run(name, scalar, threads, changes).unwrap()
}

/// The same where the run may stop.
pub fn try_run(
    name: &str,
    scalar: &str,
    threads: usize,
    changes: &[&str],
) -> Result<Run, RunError> {
    let scenario = scenario(name, changes);
    let outcome = try_outcome(&scenario, scalar, threads)?;
    let exact = ExactSolution::of(&scenario).unwrap().unwrap();
    let errors = norms(&exact, &outcome.particles, outcome.time, &scenario).unwrap();
    Ok(Run { outcome, errors })
}

/// What becomes of a built-in scenario with these changes.
pub fn outcome(name: &str, scalar: &str, threads: usize, changes: &[&str]) -> Outcome {
    try_outcome(&scenario(name, changes), scalar, threads)
        .unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// What becomes of a scenario.
pub fn try_outcome(scenario: &Scenario, scalar: &str, threads: usize) -> Result<Outcome, RunError> {
    let plan = Plan::new(scenario).unwrap();
    let mut engine = Threads::new(threads).unwrap();
    let mut control = Control {
        samples: 10,
        progress: &mut |_| true,
        look: &mut |_| Ok(()),
    };
    let scalar = scalar.parse().unwrap();
    simulation::run(&plan, scalar, false, &mut engine, &mut control)
}
