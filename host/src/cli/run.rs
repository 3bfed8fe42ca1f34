//! `motes run`.

use std::io::Write;
use std::path::{Path, PathBuf};

use miette::{IntoDiagnostic, Report, WrapErr};

use super::Failure;
use super::arguments::{RunArguments, any_scenario, scalar};
use super::watch::{Interrupt, Patience, progress_bar};
use crate::engine::Threads;
use crate::experiment::{Experiment, ExperimentError};
use crate::families::{self, Plan};
use crate::io::RunFolder;
use crate::report::results;
use crate::report::summary::Summary;
use crate::run::{Control, RunError};
use crate::scenario::{AnyScenario, Source};
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
    engine.allow_unproven(arguments.allow_unproven);
    let out = arguments.out.clone();
    let out = out.unwrap_or_else(|| Path::new("out").join(scenario.name()));
    // Now rather than after the run: a folder that cannot be had costs no time.
    let mut folder = claimed(&out, &arguments.scenario, &scenario)?;
    let interrupt = Interrupt::listen();
    engine.stop_on(interrupt.flag());
    bar.reset();
    bar.set_message(scenario.name().to_owned());
    let mut patience = Patience::new(arguments.longest);
    let mut snapshots = SnapshotWriter::new(&scenario, &folder);
    let mut steps = 0;
    let mut control = Control {
        samples: scenario.samples(),
        progress: &mut |done| {
            bar.set_position((1000.0 * done) as u64);
            interrupt.goes_on()
        },
        look: &mut |simulation| {
            steps = simulation.steps();
            snapshots.look(simulation, &mut folder)?;
            patience.look(simulation)
        },
    };
    let how = (scalar, arguments.check_overflow);
    let experiment = Experiment::of(scenario, (plan, exact), how, &mut engine, &mut control);
    bar.finish_and_clear();
    let experiment = match experiment {
        Ok(experiment) => experiment,
        Err(error) => {
            // Of a run that did not begin nothing is left.
            if steps == 0 {
                folder.discard();
            } else {
                tell_removed(&folder, arguments.quiet);
            }
            return Err(failure(error));
        }
    };
    let written = results::write(&mut folder, &experiment);
    tell_removed(&folder, arguments.quiet);
    let first = written.map_err(Failure::Run)?;
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

/// Says how many files of earlier runs are gone.
fn tell_removed(folder: &RunFolder, is_quiet: bool) {
    let (removed, path) = (folder.removed(), folder.path().display());
    if removed > 0 && !is_quiet {
        // Where nobody reads it they are gone all the same.
        let _ = writeln!(
            std::io::stderr(),
            "{removed} files of an earlier run were removed from {path}"
        );
    }
}

/// What a run of any scenario writes.
const RESULTS: [&str; 4] = ["particles.csv", "series.csv", "probe.csv", "scenario.toml"];

/// The folder of a run, its own from now on. What the run reads stays in it, and is not written over
/// by what is no copy of it.
fn claimed(out: &Path, name: &str, scenario: &AnyScenario) -> Result<RunFolder, Failure> {
    let beside = match Source::from(name) {
        Source::File(path) => Some(path),
        _ => None,
    };
    let parent = beside
        .as_deref()
        .and_then(Path::parent)
        .unwrap_or(Path::new(""));
    let series = scenario.driven().into_iter();
    let mut inputs: Vec<PathBuf> = series
        .map(|(_, series)| parent.join(&series.file))
        .collect();
    inputs.extend(scenario.cloud_file().map(Path::to_owned));
    let mut folder = RunFolder::claim(out).map_err(Failure::input)?;
    for input in &inputs {
        folder.keep(input);
        if RESULTS.iter().any(|name| folder.has(name, input)) {
            return Err(Failure::Input(miette::miette!(
                help = "choose another folder with --out, or give the file another name",
                "the run reads `{}`, which its results would replace",
                input.display()
            )));
        }
    }
    if let Some(scenario) = &beside {
        folder.keep(scenario);
    }
    Ok(folder)
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
