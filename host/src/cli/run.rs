//! `motes run`.

use std::cell::RefCell;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use miette::{IntoDiagnostic, Report, WrapErr};
use motes_core::cloud::Words;

use super::Failure;
use super::arguments::{ResumeArguments, RunArguments, any_scenario, scalar};
use super::watch::{Interrupt, Lines, Patience, progress_bar};
use crate::checkpoints::{self, CheckpointWriter, Often, Resumption, inputs, origin};
use crate::engine::Threads;
use crate::experiment::{Experiment, ExperimentError};
use crate::families::{self, Plan};
use crate::io::{Checkpoint, Header, Origin, RunFolder, SNAPSHOTS};
use crate::report::results;
use crate::report::summary::Summary;
use crate::run::{Control, RunError, ScalarName};
use crate::scenario::AnyScenario;
use crate::snapshots::SnapshotWriter;

/// What is to be run, and how.
struct Order<'a> {
    scenario: AnyScenario,
    scalar: ScalarName,
    check_overflow: bool,
    allow_unproven: bool,
    threads: usize,
    longest: f64,
    is_quiet: bool,
    json: bool,
    /// The folder for the results.
    out: PathBuf,
    checkpoint_every: Option<Often>,
    /// What checkpoints say of the run.
    header: Header,
    /// Where the run goes on from.
    from: Option<&'a Checkpoint>,
}

/// Reads, runs, writes, prints.
pub(super) fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let scenario = any_scenario(
        &arguments.scenario,
        arguments.particles.as_deref(),
        &arguments.overrides,
    )?;
    let scalar = scalar(&arguments.scalar)?;
    let out = arguments.out.clone();
    let out = out.unwrap_or_else(|| Path::new("out").join(scenario.name()));
    let header = Header {
        motes: env!("CARGO_PKG_VERSION").to_owned(),
        scenario: scenario.name().to_owned(),
        origin: origin(&arguments.scenario),
        text: scenario.text().to_owned(),
        inputs: inputs(&scenario),
        scalar: scalar.name().to_owned(),
        check_overflow: arguments.check_overflow,
        allow_unproven: arguments.allow_unproven,
        particles: 0,
        step: 0,
        time: 0.0,
        end: scenario.end(),
        digest: String::new(),
    };
    carry_out(Order {
        scenario,
        scalar,
        check_overflow: arguments.check_overflow,
        allow_unproven: arguments.allow_unproven,
        threads: arguments.threads,
        longest: arguments.longest,
        is_quiet: arguments.quiet,
        json: arguments.json,
        out,
        checkpoint_every: arguments.checkpoint_every,
        header,
        from: None,
    })
}

/// Goes on with a run.
pub(super) fn resume(arguments: &ResumeArguments) -> Result<(), Failure> {
    let found = Resumption::find(&arguments.from).map_err(Failure::input)?;
    passed_over(&found);
    let header = found.checkpoint.header.clone();
    let scenario = checkpoints::scenario(&header).map_err(Failure::input)?;
    let out = arguments.out.clone().or(found.folder);
    let out = out.unwrap_or_else(|| Path::new("out").join(scenario.name()));
    carry_out(Order {
        scalar: scalar(&header.scalar)?,
        check_overflow: header.check_overflow,
        allow_unproven: header.allow_unproven,
        threads: arguments.threads,
        longest: arguments.longest,
        is_quiet: arguments.quiet,
        json: arguments.json,
        out,
        checkpoint_every: arguments.checkpoint_every,
        from: Some(&found.checkpoint),
        scenario,
        header,
    })
}

/// Says which later checkpoints are damaged.
pub(super) fn passed_over(found: &Resumption) {
    for error in &found.passed_over {
        let file = found.file.display();
        let _ = writeln!(std::io::stderr(), "{error}: `{file}` is taken instead");
    }
}

fn carry_out(order: Order<'_>) -> Result<(), Failure> {
    let (scenario, scalar) = (order.scenario, order.scalar);
    // What a run that is gone on with replaces was its own.
    let is_silent = order.is_quiet || order.from.is_some();
    let plan = Plan::new(&scenario).map_err(Failure::input)?;
    let is_hidden = order.is_quiet || order.json;
    let bar = progress_bar(is_hidden, 1000, "{msg} {wide_bar} {percent}% {eta} left");
    bar.set_message(format!("{}, reference", scenario.name()));
    let exact = families::solution_watched(&scenario, &mut |done| {
        bar.set_position((1000.0 * done) as u64);
    });
    let exact = exact
        .map_err(Report::new)
        .wrap_err("this scenario has no exact solution: remove output.exact")
        .map_err(Failure::Input)?;
    let mut engine = Threads::new(order.threads).map_err(Failure::input)?;
    engine.allow_unproven(order.allow_unproven);
    // Now rather than after the run: a folder that cannot be had costs no time.
    let mut folder = claimed(&order.out, (&order.header.origin, &scenario), &RESULTS)?;
    let interrupt = Interrupt::listen();
    engine.stop_on(interrupt.flag());
    bar.reset();
    bar.set_message(scenario.name().to_owned());
    let mut patience = Patience::new(order.longest);
    let mut lines = Lines::new(scenario.name(), is_hidden);
    let mut snapshots = SnapshotWriter::new(&scenario, &folder);
    let mut words = order.from.map(Checkpoint::words);
    let mut steps = 0;
    if let (Some(words), Some(from)) = (&mut words, order.from) {
        steps = from.header.step;
        folder.adopt(checkpoints::FOLDER);
        folder.adopt(SNAPSHOTS);
        let read = snapshots.pass(words);
        read.map_err(|error| failure(RunError::Resume { error }))?;
    }
    let mut writer = CheckpointWriter::new(order.header, order.checkpoint_every);
    let mut kept = None;
    let files = RefCell::new((&mut folder, &mut snapshots));
    let mut control = Control {
        samples: scenario.samples(),
        progress: &mut |done| {
            bar.set_position((1000.0 * done) as u64);
            interrupt.goes_on()
        },
        look: &mut |simulation| {
            interrupt.steps();
            steps = simulation.steps();
            let (folder, snapshots) = &mut *files.borrow_mut();
            snapshots.look(simulation, folder)?;
            lines.look(simulation);
            patience.look(simulation)
        },
        keep: Some(&mut |simulation, logbook| {
            let (folder, snapshots) = &mut *files.borrow_mut();
            let asked = !interrupt.goes_on();
            let written = writer.look((simulation, logbook), snapshots, folder, asked);
            kept = written
                .map_err(|error| format!("{:?}", Report::new(error)))?
                .or(kept.take());
            Ok(())
        }),
        from: words.as_mut().map(|words| words as &mut dyn Words),
    };
    let how = (scalar, order.check_overflow);
    let experiment = Experiment::of(
        scenario,
        (plan, exact.map(Arc::from)),
        how,
        &mut engine,
        &mut control,
    );
    bar.finish_and_clear();
    let experiment = match experiment {
        Ok(experiment) => experiment,
        Err(error) => {
            // Of a run that did not begin nothing is left.
            if steps == 0 {
                folder.discard();
            } else {
                tell_removed(&folder, is_silent);
            }
            return Err(match (error, kept) {
                (RunError::Interrupted { time, step }, Some(_)) => {
                    let help = format!("`motes resume {}` goes on from there", order.out.display());
                    Failure::Interrupted(miette::miette!(
                        help = help,
                        "interrupted at t = {time}, after {step} steps: the state is kept"
                    ))
                }
                (error, _) => failure(error),
            });
        }
    };
    let written = results::write(&mut folder, &experiment);
    tell_removed(&folder, is_silent);
    let first = written.map_err(Failure::Run)?;
    let summary = Summary::new(&experiment, scalar.name(), engine.threads());
    if order.json {
        let json = serde_json::to_string(&summary)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        super::print(&format!("{json}\n"))
    } else if !order.is_quiet {
        super::print(&format!(
            "{summary}\nresults    {}\nopen       {}\n",
            order.out.display(),
            order.out.join(first).display()
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

/// The folder of a run that writes these files, its own from now on. What the run reads stays in it, and
/// is not written over by what is no copy of it.
pub(super) fn claimed(
    out: &Path,
    (origin, scenario): (&Origin, &AnyScenario),
    results: &[&str],
) -> Result<RunFolder, Failure> {
    let beside = match origin {
        Origin::File(path) => Some(path.clone()),
        Origin::BuiltIn(_) => None,
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
        if results.iter().any(|name| folder.has(name, input)) {
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
