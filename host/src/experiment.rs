//! A scenario run and measured: what `motes run`, `motes converge` and `motes suite` have in common.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::engine::Threads;
use crate::exact::solution::Solution;
use crate::families::{self, NoSolution, Plan, PlanError};
use crate::run::{
    Control, Norms, Outcome, RunError, ScalarName, Schedule, Simulation, Window, complete, errors,
    start_plan,
};
use crate::scenario::{AnyScenario, Interval};

/// A scenario, what became of it, and how that compares.
pub struct Experiment {
    /// What was run.
    pub scenario: AnyScenario,
    /// The scalar that it was run in.
    pub scalar: ScalarName,
    /// What was solved, at its end.
    pub simulation: Box<dyn Simulation>,
    /// What the run came to.
    pub outcome: Outcome,
    /// The exact solution, where the scenario asks for one.
    pub exact: Option<Arc<dyn Solution>>,
    /// The reconstruction (1.13) at the particles, one after the other; empty where there is none.
    pub reconstruction: Vec<f64>,
    /// The reconstruction at the points of the probe; empty without one.
    pub probe: Vec<f64>,
    /// Errors by field, where there is a solution and particles to compare.
    pub errors: Option<BTreeMap<String, Norms>>,
    /// Why the results may not mean what they say.
    pub doubts: Vec<String>,
}

/// Why there is no experiment.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum ExperimentError {
    /// It cannot be planned.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Plan(#[from] PlanError),
    /// It has no exact solution after all.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Exact(#[from] NoSolution),
    /// It did not run to its end.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Run(#[from] RunError),
}

/// When rows of the time series and snapshots are due.
fn schedule(scenario: &AnyScenario) -> Schedule {
    let mut intervals = vec![scenario.end() / scenario.samples() as f64];
    if let Some(Interval::Time(every)) = scenario.snapshots().map(|of| of.interval) {
        intervals.push(every);
    }
    intervals.retain(|&interval| interval > 0.0);
    Schedule::new(intervals)
}

impl Experiment {
    /// The drift of the sums of which it is known what they should be; `None` where there is none.
    pub fn drift(&self) -> Option<Vec<(String, f64)>> {
        let is_known = self.simulation.description().known.contains(&true);
        is_known.then(|| self.outcome.drift.clone())
    }

    /// What a careful reader should know.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = self.simulation.warnings(&self.outcome);
        warnings.extend(self.doubts.iter().cloned());
        warnings
    }

    /// Runs a scenario to its end and measures it; `checked` marks overflow in fixed point and
    /// stops at the first.
    ///
    /// # Errors
    /// What [`ExperimentError`] lists.
    pub fn run(
        scenario: AnyScenario,
        how: (ScalarName, bool),
        engine: &mut Threads,
        control: &mut Control<'_>,
    ) -> Result<Self, ExperimentError> {
        let plan = Plan::new(&scenario)?;
        let exact = families::solution(&scenario)?.map(Arc::from);
        Ok(Self::of(scenario, (plan, exact), how, engine, control)?)
    }

    /// The same of what has been planned.
    ///
    /// # Errors
    /// What [`RunError`] lists.
    pub fn of(
        scenario: AnyScenario,
        (plan, exact): (Plan, Option<Arc<dyn Solution>>),
        (scalar, checked): (ScalarName, bool),
        engine: &mut Threads,
        control: &mut Control<'_>,
    ) -> Result<Self, RunError> {
        let mut simulation = start_plan(plan, (scalar, checked), engine)?;
        if scenario.exact_times() {
            simulation.meet(schedule(&scenario));
        }
        let outcome = complete(&mut *simulation, engine, control)?;
        let reconstruction = simulation.reconstruct(None)?;
        let probe = match scenario.probe() {
            Some(probe) => simulation.reconstruct(Some(&probe.positions()))?,
            None => Vec::new(),
        };
        let window = Window {
            extent: scenario.window(),
            ring: scenario.ring(),
        };
        let errors = exact
            .as_ref()
            .and_then(|exact| errors(&*simulation, exact.as_ref(), window, &reconstruction));
        let mut doubts = simulation.doubts(&outcome);
        doubts.extend(outcome.unproven.iter().map(|error| {
            format!(
                "{error}; the run went on (--allow-unproven), and numbers may have wrapped without a \
                 trace: --check-overflow tells"
            )
        }));
        doubts.extend(exact.as_ref().and_then(|exact| exact.doubt()));
        if exact.is_some() && errors.is_none() {
            doubts.push("no particle is in output.window: there are no errors to tell".to_owned());
        }
        Ok(Self {
            scenario,
            scalar,
            simulation,
            outcome,
            exact,
            reconstruction,
            probe,
            errors,
            doubts,
        })
    }
}
