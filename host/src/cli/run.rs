//! `motes run`.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::{ProgressBar, ProgressStyle};
use miette::{IntoDiagnostic, Report, WrapErr};

use super::Failure;
use super::arguments::{RunArguments, any_scenario, scalar};
use crate::comparison::ExactSolution;
use crate::engine::Threads;
use crate::experiment::Experiment;
use crate::io;
use crate::linear::{self, LinearError};
use crate::report::linear_summary::LinearSummary;
use crate::report::summary::Summary;
use crate::report::{linear as linear_results, results};
use crate::scenario::linear::LinearScenario;
use crate::scenario::{AnyScenario, Scenario};
use crate::simulation::{Control, Plan, RunError};
use crate::snapshots::SnapshotWriter;

fn input(error: impl Into<Report>) -> Failure {
    Failure::Input(error.into())
}

/// Reads, runs, writes, prints.
pub(super) fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let scenario = any_scenario(
        &arguments.scenario,
        arguments.particles.as_deref(),
        &arguments.overrides,
    )?;
    match scenario {
        AnyScenario::Gas(scenario) => gas(*scenario, arguments),
        AnyScenario::Linear(scenario) => linear_system(*scenario, arguments),
    }
}

fn gas(scenario: Scenario, arguments: &RunArguments) -> Result<(), Failure> {
    let scalar = scalar(&arguments.scalar)?;
    let exact = ExactSolution::of(&scenario)
        .map_err(Report::new)
        .wrap_err("this scenario has no exact solution: remove output.exact")
        .map_err(Failure::Input)?;
    let plan = Plan::new(&scenario).map_err(input)?;
    let mut engine = Threads::new(arguments.threads).map_err(input)?;
    let out = folder(arguments, &scenario.name)?;
    let watch = Watch::new(arguments, &scenario.name);
    let run = (scenario.name.as_str(), scenario.time.end);
    let mut snapshots = SnapshotWriter::new(scenario.output.snapshots, run, &out).map_err(input)?;
    let mut control = Control {
        samples: scenario.output.samples,
        progress: &mut |done| watch.goes_on(done),
        look: &mut |look| snapshots.look(look),
    };
    let how = (scalar, arguments.check_overflow);
    let experiment = Experiment::run(scenario, &plan, exact, how, &mut engine, &mut control);
    watch.bar.finish_and_clear();
    let experiment = experiment.map_err(failure)?;
    results::write(&out, &experiment).map_err(Failure::Run)?;
    let summary = Summary::new(&experiment, scalar.name(), engine.threads());
    tell(arguments, &summary, &summary, &out)
}

fn linear_system(scenario: LinearScenario, arguments: &RunArguments) -> Result<(), Failure> {
    let scalar = scalar(&arguments.scalar)?;
    let plan = linear::Plan::new(&scenario).map_err(linear_failure)?;
    let mut engine = Threads::new(arguments.threads).map_err(input)?;
    let out = folder(arguments, &scenario.name)?;
    let watch = Watch::new(arguments, &scenario.name);
    let run = (scenario.name.as_str(), scenario.time.end);
    let mut snapshots = SnapshotWriter::new(scenario.output.snapshots, run, &out).map_err(input)?;
    let names = plan.names.clone();
    let mut control = linear::Control {
        samples: scenario.output.samples,
        progress: &mut |done| watch.goes_on(done),
        look: &mut |look| snapshots.look_linear(look, &names),
    };
    let how = (scalar, arguments.check_overflow);
    let experiment = linear::Experiment::of(scenario, plan, how, &mut engine, &mut control);
    watch.bar.finish_and_clear();
    let experiment = experiment.map_err(linear_failure)?;
    linear_results::write(&out, &experiment).map_err(Failure::Run)?;
    let summary = LinearSummary::new(&experiment, scalar.name(), engine.threads());
    tell(arguments, &summary, &summary, &out)
}

/// The folder of the results, made now rather than after the run: one that cannot be written to
/// costs no time.
fn folder(arguments: &RunArguments, name: &str) -> Result<PathBuf, Failure> {
    let out = arguments.out.clone();
    let out = out.unwrap_or_else(|| Path::new("out").join(name));
    io::writable(&out).map_err(input)?;
    Ok(out)
}

/// The progress of a run, and Ctrl-C.
struct Watch {
    bar: ProgressBar,
    interrupted: Arc<AtomicBool>,
}

impl Watch {
    fn new(arguments: &RunArguments, name: &str) -> Self {
        let interrupted = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&interrupted);
        // Without the handler Ctrl-C still ends the program, only less politely.
        let _ = ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed));
        Self {
            bar: progress_bar(arguments.quiet || arguments.json, name),
            interrupted,
        }
    }

    /// Shows the part that is done; `false` after Ctrl-C.
    fn goes_on(&self, done: f64) -> bool {
        self.bar.set_position((1000.0 * done) as u64);
        !self.interrupted.load(Ordering::Relaxed)
    }
}

/// Prints a summary as it was asked for.
fn tell(
    arguments: &RunArguments,
    text: &impl std::fmt::Display,
    json: &impl serde::Serialize,
    out: &Path,
) -> Result<(), Failure> {
    if arguments.json {
        let json = serde_json::to_string(json)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        super::print(&format!("{json}\n"))
    } else if !arguments.quiet {
        super::print(&format!("{text}\nresults    {}\n", out.display()))
    } else {
        Ok(())
    }
}

/// Which exit code a run that stopped has.
pub(super) fn failure(error: RunError) -> Failure {
    match error {
        RunError::Interrupted { .. } => Failure::Interrupted(error.into()),
        RunError::Format { .. } | RunError::Memory { .. } => Failure::Input(error.into()),
        RunError::Solver { .. } | RunError::Endless { .. } | RunError::Look { .. } => {
            Failure::Run(error.into())
        }
    }
}

/// The same of a linear system.
pub(super) fn linear_failure(error: LinearError) -> Failure {
    match error {
        LinearError::Run(error) => failure(error),
        LinearError::Growth { .. } | LinearError::Lost { .. } => Failure::Run(error.into()),
        LinearError::Quadrature(_)
        | LinearError::Solution(_)
        | LinearError::Symmetriser(_)
        | LinearError::Width { .. }
        | LinearError::Step { .. } => Failure::Input(error.into()),
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
