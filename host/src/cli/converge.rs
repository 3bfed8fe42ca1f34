//! `motes converge`.

use std::io::IsTerminal;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::{ProgressBar, ProgressStyle};
use miette::{IntoDiagnostic, Report, WrapErr};

use super::Failure;
use super::arguments::{ConvergeArguments, scalar, scenario, whole_number};
use super::run::failure;
use crate::comparison::{ExactSolution, FIELDS};
use crate::engine::Threads;
use crate::experiment::Experiment;
use crate::io;
use crate::report::convergence::Convergence;
use crate::report::summary::Summary;
use crate::scenario::Scenario;
use crate::simulation::{Control, Plan, ScalarName};
use crate::study::{ErrorNorm, Level, Study, coarsest, gas_level, ladder};

fn input(error: impl Into<Report>) -> Failure {
    Failure::Input(error.into())
}

/// Runs all levels, writes, prints.
pub(super) fn converge(arguments: &ConvergeArguments) -> Result<(), Failure> {
    let scalar = scalar(&arguments.scalar)?;
    let base = scenario(&arguments.scenario, None, &arguments.overrides)?;
    comparable(&base)?;
    let counts = counts(arguments, &base)?;
    let norm = arguments.norm.as_deref().and_then(ErrorNorm::from_name);
    let norm = norm.unwrap_or(ErrorNorm::L1);
    let field = arguments.field.clone();
    let field = field.unwrap_or_else(|| first_field(&base).to_owned());
    let name = format!("converge-{}", base.name);
    let out = arguments.out.clone();
    let out = out.unwrap_or_else(|| Path::new("out").join(name));
    // Now rather than after the runs: a folder that cannot be written to costs no time.
    io::writable(&out).map_err(input)?;

    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    // Without the handler Ctrl-C still ends the program, only less politely.
    let _ = ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed));
    let mut runs = Runs {
        arguments,
        field: &field,
        scalar,
        engine: Threads::new(arguments.threads).map_err(input)?,
        progress: Progress::new(arguments.json, &counts, base.dimension),
        interrupted,
        warnings: Vec::new(),
    };
    // Gas dynamics has no theorem to compare with.
    let study = Study::run(&counts, norm, None, |count| runs.level(count))?;
    runs.progress.bar.finish_and_clear();

    let names = (base.name.as_str(), field.as_str(), scalar.name());
    let convergence = Convergence::new(&study, names, runs.warnings);
    let picture = convergence.picture(&study).map_err(Report::new);
    let write = |result: Result<(), io::WriteError>| result.map_err(|e| Failure::Run(e.into()));
    write(io::write_levels(&out.join("converge.csv"), &study))?;
    let picture = picture.map_err(Failure::Run)?;
    write(io::write_text(&out.join("converge.svg"), &picture))?;
    if arguments.json {
        let json = serde_json::to_string(&convergence)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        return super::print(&format!("{json}\n"));
    }
    super::print(&format!("{convergence}\nresults    {}\n", out.display()))
}

/// That there is something to compare with, and that the number of particles can be changed.
fn comparable(scenario: &Scenario) -> Result<(), Failure> {
    let name = &scenario.name;
    if scenario.output.exact.is_none() {
        return Err(Failure::Input(miette::miette!(
            help = "add `exact` to [output] (docs/scenario.md says which solutions there are), or \
                    take a scenario that has it, such as sod or sound-wave",
            "`{name}` has no exact solution to converge to"
        )));
    }
    if scenario.resolution.particles == 0 {
        return Err(Failure::Input(miette::miette!(
            help = "choose another resolution.arrangement",
            "the particles of `{name}` come from a file: they have one resolution only"
        )));
    }
    Ok(())
}

/// The first field that the scenario holds to a bound, else the first of all.
fn first_field(scenario: &Scenario) -> &'static str {
    let bounded = scenario.tolerances.first();
    bounded.map_or(FIELDS[0], |tolerance| tolerance.field.name())
}

/// The numbers of particles, the smallest first.
fn counts(arguments: &ConvergeArguments, scenario: &Scenario) -> Result<Vec<usize>, Failure> {
    let number = |flag: &str, text: &str| -> Result<usize, Failure> {
        let number = whole_number(flag, text)?;
        // The largest that a scenario takes: more is refused there, with the cure.
        Ok(usize::try_from(number).unwrap_or(usize::MAX))
    };
    let counts = if arguments.ladder.is_empty() {
        let (levels, dimension) = (arguments.levels, scenario.dimension as u32);
        let first = match &arguments.particles {
            Some(text) => number("--particles", text)?,
            None => coarsest(scenario.resolution.particles, levels, dimension),
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
        Plan::check_size(&at(arguments, finest)?).map_err(input)?;
    }
    Ok(counts)
}

/// The scenario with that many particles.
fn at(arguments: &ConvergeArguments, count: usize) -> Result<Scenario, Failure> {
    let particles = count.to_string();
    scenario(&arguments.scenario, Some(&particles), &arguments.overrides)
}

/// What the runs share.
struct Runs<'a> {
    arguments: &'a ConvergeArguments,
    field: &'a str,
    scalar: ScalarName,
    engine: Threads,
    progress: Progress,
    interrupted: Arc<AtomicBool>,
    /// Of the runs: those of all levels once, others with their level.
    warnings: Vec<String>,
}

impl Runs<'_> {
    fn level(&mut self, count: usize) -> Result<Level, Failure> {
        let at_level = || format!("at the level of {count} particles");
        let within = |report: Report| report.wrap_err(at_level());
        let scenario = at(self.arguments, count)?;
        let exact = ExactSolution::of(&scenario).map_err(Report::new);
        let exact = exact.wrap_err_with(at_level).map_err(Failure::Input)?;
        let plan = Plan::new(&scenario).map_err(Report::new);
        let plan = plan.wrap_err_with(at_level).map_err(Failure::Input)?;
        let (progress, interrupted) = (&mut self.progress, &self.interrupted);
        progress.begin(count);
        let mut control = Control {
            samples: scenario.output.samples,
            progress: &mut |done| {
                progress.show(done);
                !interrupted.load(Ordering::Relaxed)
            },
            look: &mut |_| Ok(()),
        };
        let how = (self.scalar, false);
        let engine = &mut self.engine;
        let experiment = Experiment::run(scenario, &plan, exact, how, engine, &mut control)
            .map_err(|error| match failure(error) {
                Failure::Input(report) => Failure::Input(within(report)),
                Failure::Run(report) => Failure::Run(within(report)),
                Failure::Interrupted(report) => Failure::Interrupted(report),
            })?;
        let summary = Summary::new(&experiment, self.scalar.name(), self.engine.threads());
        for warning in summary.warnings {
            let of_all = experiment.doubts.contains(&warning);
            let warning = match of_all {
                true => warning,
                false => format!("n = {count}: {warning}"),
            };
            if !self.warnings.contains(&warning) {
                self.warnings.push(warning);
            }
        }
        gas_level(&experiment, &plan, self.field).ok_or_else(|| {
            Failure::Input(miette::miette!(
                help = "begin with more particles (-n), or widen output.window",
                "none of {count} particles is in output.window: there is no error to tell"
            ))
        })
    }
}

/// The bar: each level has a part of it that is as long as its work.
struct Progress {
    bar: ProgressBar,
    dimension: usize,
    total: f64,
    before: f64,
    level: f64,
}

impl Progress {
    fn new(hidden: bool, counts: &[usize], dimension: usize) -> Self {
        let bar = match hidden || !std::io::stderr().is_terminal() {
            true => ProgressBar::hidden(),
            false => ProgressBar::new(1000),
        };
        let style = ProgressStyle::with_template("{wide_bar} {percent}% {msg}");
        Self {
            bar: bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())),
            total: counts.iter().map(|&count| work(count, dimension)).sum(),
            dimension,
            before: 0.0,
            level: 0.0,
        }
    }

    fn begin(&mut self, count: usize) {
        self.before += self.level;
        self.level = work(count, self.dimension);
        self.bar.set_message(format!("{count} particles"));
    }

    fn show(&self, done: f64) {
        let share = (self.before + done * self.level) / self.total;
        self.bar.set_position((1000.0 * share) as u64);
    }
}

/// Particles times steps, which are as many as spacings along an edge.
fn work(count: usize, dimension: usize) -> f64 {
    libm::pow(count as f64, 1.0 + 1.0 / dimension as f64)
}
