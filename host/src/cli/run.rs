//! `motes run`.

use std::io::IsTerminal;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::{ProgressBar, ProgressStyle};
use miette::{IntoDiagnostic, Report, WrapErr};

use super::Failure;
use super::arguments::{RunArguments, scalar, scenario};
use crate::comparison::ExactSolution;
use crate::engine::Threads;
use crate::experiment::Experiment;
use crate::io;
use crate::report::results;
use crate::report::summary::Summary;
use crate::simulation::{Control, Plan, RunError};
use crate::snapshots::SnapshotWriter;

fn input(error: impl Into<Report>) -> Failure {
    Failure::Input(error.into())
}

/// Reads, runs, writes, prints.
pub(super) fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let scalar = scalar(&arguments.scalar)?;
    let scenario = scenario(
        &arguments.scenario,
        arguments.particles.as_deref(),
        &arguments.overrides,
    )?;
    let exact = ExactSolution::of(&scenario)
        .map_err(Report::new)
        .wrap_err("this scenario has no exact solution: remove output.exact")
        .map_err(Failure::Input)?;
    let plan = Plan::new(&scenario).map_err(input)?;
    let mut engine = Threads::new(arguments.threads).map_err(input)?;
    let out = arguments
        .out
        .clone()
        .unwrap_or_else(|| Path::new("out").join(&scenario.name));
    // Now rather than after the run: a folder that cannot be written to costs no time.
    io::writable(&out).map_err(input)?;

    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    // Without the handler Ctrl-C still ends the program, only less politely.
    let _ = ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed));
    let bar = progress_bar(arguments.quiet || arguments.json, &scenario.name);
    let mut snapshots = SnapshotWriter::new(&scenario, &out).map_err(input)?;
    let mut control = Control {
        samples: scenario.output.samples,
        progress: &mut |done| {
            bar.set_position((1000.0 * done) as u64);
            !interrupted.load(Ordering::Relaxed)
        },
        look: &mut |look| snapshots.look(look),
    };
    let how = (scalar, arguments.check_overflow);
    let experiment = Experiment::run(scenario, &plan, exact, how, &mut engine, &mut control);
    bar.finish_and_clear();
    let experiment = experiment.map_err(failure)?;
    results::write(&out, &experiment).map_err(Failure::Run)?;
    let summary = Summary::new(&experiment, scalar.name(), engine.threads());
    if arguments.json {
        let json = serde_json::to_string(&summary)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        super::print(&format!("{json}\n"))?;
    } else if !arguments.quiet {
        super::print(&format!("{summary}\nresults    {}\n", out.display()))?;
    }
    Ok(())
}

/// Which exit code a run that stopped has.
pub(super) fn failure(error: RunError) -> Failure {
    match error {
        RunError::Interrupted { .. } => Failure::Interrupted(error.into()),
        RunError::Format { .. } | RunError::Memory { .. } => Failure::Input(error.into()),
        RunError::Solver { .. } | RunError::Look { .. } => Failure::Run(error.into()),
    }
}

fn progress_bar(hidden: bool, name: &str) -> ProgressBar {
    if hidden || !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{msg} {wide_bar} {percent}% {eta} left");
    let bar = ProgressBar::new(1000).with_message(name.to_owned());
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
