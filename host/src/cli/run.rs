//! `motes run`.

use std::path::Path;

use miette::{IntoDiagnostic, Report, WrapErr};

use super::Failure;
use super::arguments::{RunArguments, any_scenario, scalar};
use super::watch::{Interrupt, Patience, progress_bar};
use crate::engine::Threads;
use crate::experiment::{Experiment, ExperimentError};
use crate::families::{self, Plan};
use crate::io;
use crate::report::results;
use crate::report::summary::Summary;
use crate::run::{Control, RunError};
use crate::snapshots::SnapshotWriter;

/// Reads, runs, writes, prints.
pub(super) fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let scenario = any_scenario(
        &arguments.scenario,
        arguments.particles.as_deref(),
        &arguments.overrides,
    )?;
    let scalar = scalar(&arguments.scalar)?;
    let plan = Plan::new(&scenario).map_err(Failure::input)?;
    let is_hidden = arguments.quiet || arguments.json;
    let bar = progress_bar(is_hidden, 1000, "{msg} {wide_bar} {percent}% {eta} left");
    bar.set_message(format!("{}, reference", scenario.name()));
    let exact = families::solution_watched(&scenario, &mut |done| {
        bar.set_position((1000.0 * done) as u64);
    });
    let exact = exact
        .map_err(Report::new)
        .wrap_err("this scenario has no exact solution: remove output.exact")
        .map_err(Failure::Input)?;
    let mut engine = Threads::new(arguments.threads).map_err(Failure::input)?;
    let out = arguments.out.clone();
    let out = out.unwrap_or_else(|| Path::new("out").join(scenario.name()));
    // Now rather than after the run: a folder that cannot be written to costs no time.
    io::writable(&out).map_err(Failure::input)?;
    let interrupt = Interrupt::listen();
    engine.stop_on(interrupt.flag());
    bar.reset();
    bar.set_message(scenario.name().to_owned());
    let mut patience = Patience::new(arguments.longest);
    let mut snapshots = SnapshotWriter::new(&scenario, &out).map_err(Failure::input)?;
    let mut control = Control {
        samples: scenario.samples(),
        progress: &mut |done| {
            bar.set_position((1000.0 * done) as u64);
            interrupt.goes_on()
        },
        look: &mut |simulation| {
            snapshots.look(simulation)?;
            patience.look(simulation)
        },
    };
    let how = (scalar, arguments.check_overflow);
    let experiment = Experiment::of(scenario, (plan, exact), how, &mut engine, &mut control);
    bar.finish_and_clear();
    let experiment = experiment.map_err(failure)?;
    let first = results::write(&out, &experiment).map_err(Failure::Run)?;
    let summary = Summary::new(&experiment, scalar.name(), engine.threads());
    if arguments.json {
        let json = serde_json::to_string(&summary)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        super::print(&format!("{json}\n"))
    } else if !arguments.quiet {
        super::print(&format!(
            "{summary}\nresults    {}\nopen       {}\n",
            out.display(),
            out.join(first).display()
        ))
    } else {
        Ok(())
    }
}

/// Which exit code a run that stopped has.
pub(super) fn failure(error: RunError) -> Failure {
    match error {
        RunError::Interrupted { .. } => Failure::Interrupted(error.into()),
        _ if error.is_of_input() => Failure::Input(error.into()),
        _ => Failure::Run(error.into()),
    }
}

/// The same of an experiment.
pub(super) fn experiment_failure(error: ExperimentError) -> Failure {
    match error {
        ExperimentError::Run(error) => failure(error),
        ExperimentError::Plan(_) | ExperimentError::Exact(_) => Failure::Input(error.into()),
    }
}
