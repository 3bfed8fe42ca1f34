//! Runs of scenarios for tests, through the library.
#![allow(dead_code, reason = "every test uses its part of this module")]

use std::collections::BTreeMap;

use motes::engine::Threads;
use motes::experiment::{Experiment, ExperimentError};
use motes::run::{Control, Norms, Outcome, RunError, Simulation};
use motes::scenario::{AnyScenario, Scenario, Source};

/// What a test wants of a run.
pub struct Run {
    pub experiment: Experiment,
    pub outcome: Outcome,
    pub errors: BTreeMap<String, Norms>,
}

impl Run {
    /// The L1 error of a field.
    pub fn l1(&self, field: &str) -> f64 {
        self.errors[field].l1
    }

    /// What is told of it.
    pub fn warnings(&self) -> Vec<String> {
        self.experiment.simulation.warnings(&self.outcome)
    }
}

/// What is told of a run in such words.
pub fn told(experiment: &Experiment, words: &str) -> Vec<String> {
    let warnings = experiment.simulation.warnings(&experiment.outcome);
    let all = warnings.into_iter().chain(experiment.doubts.clone());
    all.filter(|text| text.contains(words)).collect()
}

/// A particle of a gas.
#[derive(Clone, Copy, Debug)]
pub struct Particle {
    pub position: [f64; 3],
    pub velocity_x: f64,
    pub mass: f64,
    pub density: f64,
    pub material: u8,
}

/// The particles of a gas.
pub fn particles(simulation: &dyn Simulation) -> Vec<Particle> {
    let fields = ["mass", "density", "material"].map(|name| simulation.column(name).unwrap());
    let velocity_x = match simulation.description().dimension {
        1 => simulation.column("velocity").unwrap(),
        _ => simulation.column("velocity_x").unwrap(),
    };
    let mut particles = Vec::new();
    simulation.each(|row| {
        let [mass, density, material] = fields.each_ref().map(|column| column[particles.len()]);
        particles.push(Particle {
            position: row.position,
            velocity_x: velocity_x[particles.len()],
            mass,
            density,
            material: material as u8,
        });
    });
    particles
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
    AnyScenario::read(Source::from(name), &changes).unwrap()
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
    let experiment = match try_experiment(any_scenario(name, changes), scalar, threads) {
        Ok(experiment) => experiment,
        Err(ExperimentError::Run(error)) => return Err(error),
        Err(error) => panic!("{name}: {error}"),
    };
    Ok(Run {
        outcome: experiment.outcome.clone(),
        errors: experiment.errors.clone().unwrap(),
        experiment,
    })
}

/// A scenario run and measured.
pub fn try_experiment(
    scenario: AnyScenario,
    scalar: &str,
    threads: usize,
) -> Result<Experiment, ExperimentError> {
    let mut engine = Threads::new(threads).unwrap();
    let mut control = Control {
        samples: 10,
        progress: &mut |_| true,
        look: &mut |_| Ok(()),
        keep: None,
        from: None,
    };
    let how = (scalar.parse().unwrap(), false);
    Experiment::run(scenario, how, &mut engine, &mut control)
}

/// The same, which must not stop.
pub fn experiment(scenario: AnyScenario, scalar: &str, threads: usize) -> Experiment {
    let name = scenario.name().to_owned();
    try_experiment(scenario, scalar, threads).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// What becomes of a scenario with these changes.
pub fn outcome(name: &str, scalar: &str, threads: usize, changes: &[&str]) -> Outcome {
    experiment(any_scenario(name, changes), scalar, threads).outcome
}
