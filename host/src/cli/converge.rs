//! `motes converge`.

use std::path::Path;

use miette::{IntoDiagnostic, Report};

use super::Failure;
use super::arguments::{ConvergeArguments, any_scenario, scalar, whole_number};
use super::progress::Progress;
use super::run::{claimed, experiment_failure};
use super::watch::{Interrupt, Patience};
use crate::checkpoints::origin;
use crate::engine::Threads;
use crate::experiment::Experiment;
use crate::families::Plan;
use crate::io;
use crate::report::convergence::Convergence;
use crate::report::summary::Summary;
use crate::run::{Control, ScalarName};
use crate::scenario::{AnyScenario, shortened};
use crate::study::{ErrorNorm, Level, Study, Subject, coarsest, ladder, level};

/// Runs all levels, writes, prints.
pub(super) fn converge(arguments: &ConvergeArguments) -> Result<(), Failure> {
    let scalar = scalar(&arguments.scalar)?;
    let base = any_scenario(&arguments.scenario, None, &arguments.overrides)?;
    let subject = subject(&base, arguments)?;
    let counts = counts(arguments, &base, &subject)?;
    let name = format!("converge-{}", base.name());
    let out = arguments.out.clone();
    let out = out.unwrap_or_else(|| Path::new("out").join(name));
    // Now rather than after the runs: a folder that cannot be written to costs no time.
    let results = ["converge.csv", "converge.svg"];
    let mut folder = claimed(&out, (&origin(&arguments.scenario), &base), &results)?;

    let mut runs = Runs {
        arguments,
        field: &subject.field,
        scalar,
        engine: Threads::new(arguments.threads).map_err(Failure::input)?,
        progress: Progress::new(arguments.json, &counts, base.dimension()),
        interrupt: Interrupt::listen(),
        warnings: Vec::new(),
    };
    runs.engine.stop_on(runs.interrupt.flag());
    let (norm, theory) = (subject.norm, subject.theory);
    let study = Study::run(&counts, norm, theory, |count| runs.level(count))?;
    runs.progress.bar.finish_and_clear();

    let names = (base.name(), subject.field.as_str(), scalar.name());
    let convergence = Convergence::new(&study, names, runs.warnings);
    let picture = convergence.picture(&study).map_err(Report::new);
    let write = |result: Result<(), io::WriteError>| result.map_err(|e| Failure::Run(e.into()));
    let place = folder.place("converge.csv");
    write(place.and_then(|place| io::write_levels(&place, &study)))?;
    let picture = picture.map_err(Failure::Run)?;
    write(folder.write("converge.svg", &picture))?;
    if arguments.json {
        let json = serde_json::to_string(&convergence)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        return super::print(&format!("{json}\n"));
    }
    super::print(&format!("{convergence}\nresults    {}\n", out.display()))
}

/// What is studied, as the flags ask for it.
///
/// # Errors
/// Nothing to compare with, one resolution only, or a field that there is not.
fn subject(scenario: &AnyScenario, arguments: &ConvergeArguments) -> Result<Subject, Failure> {
    let (mut subject, name) = (Subject::of(scenario), scenario.name());
    if !scenario.has_exact() {
        return Err(Failure::Input(miette::miette!(
            help = "add `exact` to [output] (docs/scenario.md says which solutions there \
                    are), or take a scenario that has it, such as sod or acoustics1d",
            "`{name}` has no exact solution to converge to"
        )));
    }
    if scenario.particles() == 0 {
        return Err(Failure::Input(miette::miette!(
            help = "choose another resolution.arrangement",
            "the particles of `{name}` come from a file: they have one resolution only"
        )));
    }
    if let Some(norm) = arguments.norm.as_deref().and_then(ErrorNorm::from_name) {
        subject.norm = norm;
    }
    if let Some(field) = &arguments.field {
        if !subject.fields.contains(field) {
            return Err(Failure::Input(miette::miette!(
                help = format!("`{name}` has {}", subject.fields.join(", ")),
                "there is no field `{}`",
                shortened(field)
            )));
        }
        subject.field.clone_from(field);
    }
    Ok(subject)
}

/// The numbers of particles, the smallest first.
fn counts(
    arguments: &ConvergeArguments,
    base: &AnyScenario,
    subject: &Subject,
) -> Result<Vec<usize>, Failure> {
    let number = |flag: &str, text: &str| -> Result<usize, Failure> {
        let number = whole_number(flag, text)?;
        // The largest that a scenario takes: more is refused there, with the cure.
        Ok(usize::try_from(number).unwrap_or(usize::MAX))
    };
    let counts = if arguments.ladder.is_empty() {
        let (levels, dimension) = (arguments.levels, base.dimension() as u32);
        let first = match &arguments.particles {
            Some(text) => number("--particles", text)?,
            None => {
                let mut first = coarsest(base.particles(), levels, dimension);
                while first < subject.least {
                    first <<= dimension;
                }
                first
            }
        };
        ladder(first, levels, dimension).ok_or_else(|| {
            Failure::Input(miette::miette!(
                help = "give fewer --levels, or fewer --particles to begin with",
                "{levels} levels from {first} particles are more than can be counted"
            ))
        })?
    } else {
        let numbers = arguments.ladder.iter().map(|text| number("--ladder", text));
        let mut counts = numbers.collect::<Result<Vec<_>, _>>()?;
        counts.sort_unstable();
        counts
    };
    if let Some(pair) = counts.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(Failure::Input(miette::miette!(
            help = "give each number of particles once",
            "--ladder has {} twice",
            pair[0]
        )));
    }
    if counts.len() < 2 {
        return Err(Failure::Input(miette::miette!(
            help = "give --levels 3 or more, or as many numbers to --ladder",
            "an order needs at least 2 levels: there is {}",
            counts.len()
        )));
    }
    // Now rather than after the runs before it.
    if let Some(&finest) = counts.last() {
        Plan::check_size(&at(arguments, finest)?).map_err(Failure::input)?;
    }
    Ok(counts)
}

/// The scenario with that many particles.
fn at(arguments: &ConvergeArguments, count: usize) -> Result<AnyScenario, Failure> {
    let particles = count.to_string();
    any_scenario(&arguments.scenario, Some(&particles), &arguments.overrides)
}

/// What the runs share.
struct Runs<'a> {
    arguments: &'a ConvergeArguments,
    field: &'a str,
    scalar: ScalarName,
    engine: Threads,
    progress: Progress,
    interrupt: Interrupt,
    /// Of the runs: those of all levels once, others with their level.
    warnings: Vec<String>,
}

impl Runs<'_> {
    /// Runs a level.
    fn level(&mut self, count: usize) -> Result<Level, Failure> {
        let scenario = at(self.arguments, count)?;
        self.progress.begin(count);
        let (progress, interrupt) = (&self.progress, &self.interrupt);
        let mut patience = Patience::new(self.arguments.longest);
        let mut control = Control {
            samples: scenario.samples(),
            progress: &mut |done| {
                progress.show(done);
                interrupt.goes_on()
            },
            look: &mut |simulation| patience.look(simulation),
            keep: None,
            from: None,
        };
        let experiment = Experiment::run(
            scenario,
            (self.scalar, false),
            &mut self.engine,
            &mut control,
        )
        .map_err(|error| within(count, experiment_failure(error)))?;
        let summary = Summary::new(&experiment, self.scalar.name(), self.engine.threads());
        self.warn(count, summary.warnings, &experiment.doubts);
        let level = level(&experiment, self.field);
        level.ok_or_else(|| {
            Failure::Input(miette::miette!(
                help = "begin with more particles (-n), or widen output.window",
                "none of {count} particles is in output.window: there is no error to tell"
            ))
        })
    }

    /// Keeps what a careful reader should know: what all levels share (`doubts`) once.
    fn warn(&mut self, count: usize, warnings: Vec<String>, doubts: &[String]) {
        for warning in warnings {
            let warning = match doubts.contains(&warning) {
                true => warning,
                false => format!("n = {count}: {warning}"),
            };
            if !self.warnings.contains(&warning) {
                self.warnings.push(warning);
            }
        }
    }
}

/// An error that says at which level it happened.
fn within(count: usize, failure: Failure) -> Failure {
    let told = |report: Report| report.wrap_err(format!("at the level of {count} particles"));
    match failure {
        Failure::Input(report) => Failure::Input(told(report)),
        Failure::Run(report) => Failure::Run(told(report)),
        Failure::Interrupted(report) => Failure::Interrupted(report),
    }
}
