//! `motes compare`.

mod formats;

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use indicatif::ProgressBar;
use miette::{Diagnostic, IntoDiagnostic, Report, WrapErr};

use super::Failure;
use super::arguments::{CompareArguments, any_scenario};
use super::run::{claimed, failure};
use super::watch::{Interrupt, Patience, progress_bar};
use crate::checkpoints::origin;
use crate::engine::Threads;
use crate::exact::solution::Solution;
use crate::experiment::Experiment;
use crate::families::{self, Plan};
use crate::io;
use crate::precision::{Comparison, Finished, LastState, Ran, Refusal, shares, side_by_side};
use crate::report::comparison::{markdown, picture};
use crate::run::{Control, RunError, ScalarName};
use crate::scenario::{AnyScenario, shortened};
use crate::study::Subject;

/// What is written.
const RESULTS: [&str; 3] = [TABLE, REPORT, PICTURE];
const TABLE: &str = "compare.csv";
const REPORT: &str = "compare.md";
const PICTURE: &str = "compare.svg";

/// Runs in all formats, writes, prints.
pub(super) fn compare(arguments: &CompareArguments) -> Result<(), Failure> {
    let scalars = formats::chosen(&arguments.scalars, arguments.bits.as_deref())?;
    let particles = arguments.particles.as_deref();
    let scenario = any_scenario(&arguments.scenario, particles, &arguments.overrides)?;
    let field = field(&scenario, arguments.field.as_deref())?;
    let plan = Plan::new(&scenario).map_err(Failure::input)?;
    let bar = progress_bar(
        arguments.json,
        1000 * scalars.len() as u64,
        "{msg} {wide_bar} {percent}% {eta} left",
    );
    bar.set_message(format!("{}, reference", scenario.name()));
    let whole = bar.length().unwrap_or(0) as f64;
    let exact = families::solution_watched(&scenario, &mut |done| {
        bar.set_position((whole * done) as u64);
    });
    let exact = exact
        .map_err(Report::new)
        .wrap_err("this scenario has no exact solution: remove output.exact")
        .map_err(Failure::Input)?;
    let out = arguments.out.clone();
    let name = format!("compare-{}", scenario.name());
    let out = out.unwrap_or_else(|| Path::new("out").join(name));
    // Now rather than after the runs: a folder that cannot be written to costs no time.
    let folder = claimed(&out, (&origin(&arguments.scenario), &scenario), &RESULTS)?;
    let interrupt = Interrupt::listen();
    let mut engines = engines(arguments.threads, scalars.len(), &plan, &interrupt)?;

    bar.reset();
    bar.set_message(format!("{} in {} formats", scenario.name(), scalars.len()));
    let runs = SideBySide {
        scenario: &scenario,
        plan,
        exact: exact.map(Arc::from),
        longest: arguments.longest,
        done: scalars.iter().map(|_| AtomicU64::new(0)).collect(),
        bar,
        interrupt,
    };
    let results = side_by_side(&mut engines, scalars.len(), |place, engine| {
        runs.run(place, scalars[place], engine)
    });
    runs.bar.finish_and_clear();
    let mut comparison = compared(&scenario, &field, scalars.into_iter().zip(results))?;
    let note = formats::note(arguments.bits.as_deref());
    comparison.warnings.extend(note);
    written(&comparison, folder, &formats::command(arguments))?;
    if arguments.json {
        let json = serde_json::to_string(&comparison)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        return super::print(&format!("{json}\n"));
    }
    super::print(&format!("{comparison}\nresults    {}\n", out.display()))
}

/// Writes a comparison that this command made.
fn written(
    comparison: &Comparison,
    mut folder: io::RunFolder,
    command: &str,
) -> Result<(), Failure> {
    let write = |result: Result<(), io::WriteError>| result.map_err(|e| Failure::Run(e.into()));
    // Before the first file: a picture that cannot be drawn leaves nothing half done.
    let drawn = picture(comparison).map_err(|error| Failure::Run(Report::new(error)))?;
    let place = folder.place(TABLE);
    write(place.and_then(|place| io::write_formats(&place, comparison)))?;
    write(folder.write(REPORT, &markdown(comparison, command, PICTURE)))?;
    write(folder.write(PICTURE, &drawn))
}

/// The field that the first table is of.
///
/// # Errors
/// One that there is not.
fn field(scenario: &AnyScenario, asked: Option<&str>) -> Result<String, Failure> {
    let subject = Subject::of(scenario);
    let Some(asked) = asked else {
        return Ok(subject.field);
    };
    let fields = subject.fields.into_iter();
    let mut fields = fields
        .filter(|field| field != crate::run::ENERGY)
        .collect::<Vec<_>>();
    match fields.iter().position(|field| field == asked) {
        Some(place) => Ok(fields.swap_remove(place)),
        None => Err(Failure::Input(miette::miette!(
            help = format!("`{}` has {}", scenario.name(), fields.join(", ")),
            "there is no field `{}` to compare",
            shortened(asked)
        ))),
    }
}

/// An engine for each of the runs at a time.
fn engines(
    threads: usize,
    runs: usize,
    plan: &Plan,
    interrupt: &Interrupt,
) -> Result<Vec<Threads>, Failure> {
    let particles = match plan {
        Plan::Gas(plan) => plan.particles.len(),
        Plan::Strengths(plan) => plan.weights.len(),
    };
    // As many as there are cores, or an error where the number makes no sense.
    let all = Threads::new(threads).map_err(Failure::input)?.threads();
    let shares = shares(all, runs, particles).into_iter();
    shares
        .map(|threads| {
            let mut engine = Threads::new(threads).map_err(Failure::input)?;
            engine.stop_on(interrupt.flag());
            Ok(engine)
        })
        .collect()
}

/// The comparison of what ran.
///
/// # Errors
/// An interrupt, or no run at all: then why the first format has none.
fn compared(
    scenario: &AnyScenario,
    field: &str,
    results: impl Iterator<Item = (ScalarName, Result<Finished, RunError>)>,
) -> Result<Comparison, Failure> {
    let (mut runs, mut first) = (Vec::new(), None);
    for (scalar, result) in results {
        let result = match result {
            Err(error @ RunError::Interrupted { .. }) => {
                return Err(Failure::Interrupted(error.into()));
            }
            Err(error) => {
                let refusal = Refusal {
                    refused: error.to_string(),
                    cure: error.help().map(|cure| cure.to_string()),
                };
                first.get_or_insert((scalar, error));
                Err(refusal)
            }
            Ok(finished) => Ok(finished),
        };
        runs.push((scalar, result));
    }
    let formats = runs.len();
    match (Comparison::new(scenario, field, runs), first) {
        (Some(comparison), _) => Ok(comparison),
        (None, Some((scalar, error))) => {
            let said = format!("none of {formats} formats ran; {} did not", scalar.name());
            Err(match failure(error) {
                Failure::Input(report) => Failure::Input(report.wrap_err(said)),
                Failure::Run(report) => Failure::Run(report.wrap_err(said)),
                Failure::Interrupted(report) => Failure::Interrupted(report),
            })
        }
        (None, None) => Err(Failure::Input(miette::miette!(
            help = "name one or more with --scalars",
            "there is no format to run in"
        ))),
    }
}

/// What the runs share, side by side.
struct SideBySide<'a> {
    scenario: &'a AnyScenario,
    plan: Plan,
    exact: Option<Arc<dyn Solution>>,
    longest: f64,
    /// Of each run, in thousandths.
    done: Vec<AtomicU64>,
    bar: ProgressBar,
    interrupt: Interrupt,
}

impl SideBySide<'_> {
    /// Runs in a format, and keeps what is compared.
    fn run(
        &self,
        place: usize,
        scalar: ScalarName,
        engine: &mut Threads,
    ) -> Result<Finished, RunError> {
        let mut patience = Patience::new(self.longest);
        let mut control = Control {
            samples: self.scenario.samples(),
            progress: &mut |done| {
                self.show(place, done);
                self.interrupt.goes_on()
            },
            look: &mut |simulation| patience.look(simulation),
            keep: None,
            from: None,
        };
        let planned = (self.plan.clone(), self.exact.clone());
        let scenario = self.scenario.clone();
        let run = Experiment::of(scenario, planned, (scalar, false), engine, &mut control);
        // Of a run that stopped the part is done, too.
        self.show(place, 1.0);
        let mut experiment = run?;
        let last = LastState::of(&experiment);
        let ran = Ran::of(&mut experiment);
        Ok(Finished { ran, last })
    }

    fn show(&self, place: usize, done: f64) {
        self.done[place].store((1000.0 * done) as u64, Ordering::Relaxed);
        let all = self.done.iter().map(|done| done.load(Ordering::Relaxed));
        self.bar.set_position(all.sum());
    }
}
