//! A scenario run and measured.

use std::collections::BTreeMap;

use super::{Control, LinearError, Outcome, Plan, doubts, errors, run, solution, undamped};
use crate::comparison::Norms;
use crate::engine::Threads;
use crate::exact::linear::solution::Solution;
use crate::scalars::ScalarName;
use crate::scenario::linear::LinearScenario;

/// A scenario, what became of it, and how that compares.
pub struct Experiment {
    /// What was run.
    pub scenario: LinearScenario,
    /// How it was run.
    pub plan: Plan,
    /// What came out.
    pub outcome: Outcome,
    /// The exact solution, where the scenario asks for one.
    pub exact: Option<Box<dyn Solution>>,
    /// Errors by component, of the state and of the reconstruction.
    pub errors: Option<BTreeMap<String, Norms>>,
    /// Why the results may not mean what they say.
    pub doubts: Vec<String>,
}

impl Experiment {
    /// Runs a scenario to its end and measures it.
    ///
    /// # Errors
    /// What [`LinearError`] lists.
    pub fn run(
        scenario: LinearScenario,
        (scalar, checked): (ScalarName, bool),
        engine: &mut Threads,
        control: &mut Control<'_>,
    ) -> Result<Self, LinearError> {
        let plan = Plan::new(&scenario)?;
        Self::of(scenario, plan, (scalar, checked), engine, control)
    }

    /// The same for a plan that has been made.
    ///
    /// # Errors
    /// What [`LinearError`] lists.
    pub fn of(
        scenario: LinearScenario,
        plan: Plan,
        (scalar, checked): (ScalarName, bool),
        engine: &mut Threads,
        control: &mut Control<'_>,
    ) -> Result<Self, LinearError> {
        let exact = match scenario.output.exact {
            true => solution(&scenario)?,
            false => None,
        };
        let outcome = run(&plan, scalar, checked, engine, control)?;
        let window = &scenario.output.window;
        let errors = exact
            .as_ref()
            .and_then(|exact| errors(exact.as_ref(), &outcome, &plan.names, window));
        let mut doubts = doubts(&scenario, &plan);
        doubts.extend(undamped(outcome.undamped));
        if exact.is_some() && errors.is_none() {
            doubts.push("no particle is in output.window: there are no errors to tell".to_owned());
        }
        Ok(Self {
            scenario,
            plan,
            outcome,
            exact,
            errors,
            doubts,
        })
    }
}
