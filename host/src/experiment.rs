//! A scenario run and measured: what `motes run` and `motes suite` have in common.

use std::collections::BTreeMap;

use crate::comparison::{ExactSolution, Norms, norms};
use crate::engine::Threads;
use crate::scenario::Scenario;
use crate::simulation::{self, Control, Outcome, Plan, RunError, ScalarName};

/// A scenario, what became of it, and how that compares.
pub struct Experiment {
    /// What was run.
    pub scenario: Scenario,
    /// What came out.
    pub outcome: Outcome,
    /// The exact solution, where the scenario names one.
    pub exact: Option<ExactSolution>,
    /// Errors by field, where there is one and particles to compare.
    pub errors: Option<BTreeMap<&'static str, Norms>>,
    /// Why the comparison may not mean what it says.
    pub doubts: Vec<String>,
}

impl Experiment {
    /// Runs a planned scenario to its end and measures it.
    ///
    /// # Errors
    /// What [`RunError`] lists.
    pub fn run(
        scenario: Scenario,
        plan: &Plan,
        exact: Option<ExactSolution>,
        (scalar, checked): (ScalarName, bool),
        engine: &mut Threads,
        control: &mut Control<'_>,
    ) -> Result<Self, RunError> {
        let outcome = simulation::run(plan, scalar, checked, engine, control)?;
        let errors = exact
            .as_ref()
            .and_then(|exact| norms(exact, &outcome.particles, outcome.time, &scenario));
        let mut doubts: Vec<String> = exact
            .iter()
            .filter_map(|exact| exact.doubt(&scenario))
            .map(|why| format!("{why}: the exact solution may not hold there"))
            .collect();
        if exact.is_some() && errors.is_none() {
            doubts.push("no particle is in output.window: there are no errors to tell".to_owned());
        }
        Ok(Self {
            scenario,
            outcome,
            exact,
            errors,
            doubts,
        })
    }
}
