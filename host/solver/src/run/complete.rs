//! The run loop: from the start, or from where it was left, to the end, whatever is solved.

use motes_core::cloud::Words;
use motes_core::error::Error;

use super::error::RunError;
use super::logbook::Logbook;
use super::outcome::Outcome;
use super::simulation::Simulation;
use crate::engine::Threads;

/// Receives a run and its logbook after a step, to keep what it goes on from.
pub type Keep<'a> = dyn FnMut(&mut dyn Simulation, &mut Logbook) -> Result<(), String> + 'a;

/// What a run tells its caller, and hears from it, between steps.
pub struct Control<'a> {
    /// Rows of the time series, equally spaced in time.
    pub samples: usize,
    /// Called with the part of the run that is done, in [0, 1]; `false` stops the run.
    pub progress: &'a mut dyn FnMut(f64) -> bool,
    /// Called at the start and after each step. Looking changes no bit.
    pub look: &'a mut dyn FnMut(&dyn Simulation) -> Result<(), String>,
    /// Called after each step, before [`Control::progress`].
    pub keep: Option<&'a mut Keep<'a>>,
    /// What [`Control::keep`] has kept: where the run goes on from; its start without.
    pub from: Option<&'a mut dyn Words>,
}

/// Steps a simulation from its start, or from where it was left, to its end.
///
/// # Errors
/// What [`RunError`] lists.
pub fn complete(
    simulation: &mut dyn Simulation,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    let mut logbook = Logbook::new(simulation, control.samples);
    match control.from.take() {
        None => show(simulation, control)?,
        Some(words) => {
            let passed = pass_run(simulation, &mut logbook, words);
            passed.map_err(|error| RunError::Resume { error })?;
        }
    }
    while let Some(step) = simulation.step(engine)? {
        logbook.step(simulation, step, engine)?;
        show(simulation, control)?;
        if let Some(keep) = &mut control.keep {
            let kept = keep(simulation, &mut logbook);
            kept.map_err(looked(simulation))?;
        }
        if !(control.progress)(simulation.done()) {
            return Err(RunError::Interrupted {
                time: simulation.time(),
                step: simulation.steps(),
            });
        }
    }
    logbook.close(simulation, engine)
}

/// Passes a run and its logbook, and last the digest of its state: what is read is what was written.
///
/// # Errors
/// Those of [`Words`].
pub fn pass_run(
    simulation: &mut dyn Simulation,
    logbook: &mut Logbook,
    words: &mut dyn Words,
) -> Result<(), Error> {
    simulation.pass(words)?;
    logbook.pass(words)?;
    words.same(simulation.digest().0)
}

fn show(simulation: &dyn Simulation, control: &mut Control<'_>) -> Result<(), RunError> {
    (control.look)(simulation).map_err(looked(simulation))
}

/// What somebody who looked at a run says of it, as an error.
fn looked(simulation: &dyn Simulation) -> impl FnOnce(String) -> RunError {
    let time = simulation.time();
    move |reason| RunError::Look { time, reason }
}
