//! Flags and their help.

mod compare;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

use super::Failure;
use super::watch::LONGEST;
use crate::checkpoints::Often;
use crate::run::{ScalarName, UnknownScalar};
use crate::scenario::{AnyScenario, Source, shortened};
use crate::study::ErrorNorm;

pub(super) use compare::CompareArguments;

/// A deterministic particle solver for first-order systems of partial differential equations.
#[derive(Parser)]
#[command(name = "motes", version, arg_required_else_help = true)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// Run a scenario and compare it with its exact solution
    Run(RunArguments),
    /// Go on with a run that was interrupted, from its last checkpoint, to the same bits
    Resume(ResumeArguments),
    /// Print what a checkpoint is of
    Inspect(InspectArguments),
    /// List the built-in scenarios
    List,
    /// Print a scenario's TOML, to copy and edit
    Show {
        /// A built-in scenario, see `motes list`, or a file that one names
        name: String,
    },
    /// Write a scenario of your own, to edit
    New(NewArguments),
    /// Run the test suite against its exact solutions and write a report
    Suite(SuiteArguments),
    /// Run a scenario at several resolutions and tell the order of its error
    Converge(ConvergeArguments),
    /// Run a scenario in several number formats and tell what each loses
    Compare(CompareArguments),
    /// Print a scenario as Rust source for a device
    Export(ExportArguments),
    /// Measure speed: gas dynamics in a jittered periodic box, particle updates a second
    Bench(BenchArguments),
    /// Print completions for a shell, to be sourced
    Completions {
        /// Which
        shell: clap_complete::Shell,
    },
    /// Print a manual page
    Man {
        /// Of which command; of the program without
        command: Option<String>,
    },
}

const EXAMPLES: &str = "\
Examples:
  motes run sod                                     the built-in shock tube
  motes run sod --scalar q12.19 -n 450              in 32-bit fixed point, with 450 particles
  motes run sod --set viscosity.kind=von_neumann    with another viscosity
  motes run sod --set region.1.pressure=0.01        with a stronger shock
  motes show sod > tube.toml; motes run tube.toml   a scenario of your own
  motes run sod --json | jq .errors.density.l1      for a script
  motes run sod3d --checkpoint-every 10m            and motes resume out/sod3d goes on with it

Files written into --out: particles.csv (with the exact solution), series.csv (the
diagnostics over time), figure.svg and other pictures, scenario.toml (what was run, with --set
applied).
Exit codes: 0 done, 1 the run failed, 2 the input cannot be used, 130 interrupted.";

#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct RunArguments {
    /// A built-in scenario, or a file that ends in .toml
    #[arg(value_name = "NAME|FILE.toml")]
    pub scenario: String,
    /// The number format: f64, f32, micromath, or fixed point such as q12.19
    #[arg(long, default_value = "f64", value_name = "SCALAR")]
    pub scalar: String,
    /// Number of threads; 0 for all cores. The results do not depend on it
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub threads: usize,
    /// Number of particles; the same as --set resolution.particles=N
    #[arg(short = 'n', long, value_name = "N")]
    pub particles: Option<String>,
    /// Folder for the results [default: out/<name>]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Change a value of the scenario; may be given several times
    #[arg(long = "set", value_name = "SECTION.KEY=VALUE")]
    pub overrides: Vec<String>,
    /// Print one JSON object on standard output, and nothing else
    #[arg(long)]
    pub json: bool,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
    /// Stop a run that at its pace would take more days than this
    #[arg(long, default_value_t = LONGEST, value_name = "DAYS")]
    pub longest: f64,
    /// Keep a checkpoint after so many steps, such as 500, or so much time, such as 60s, 10m, 2h, to
    /// go on from with `motes resume`. Ctrl-C keeps one, too
    #[arg(long, value_name = "STEPS|TIME")]
    pub checkpoint_every: Option<Often>,
    /// Fixed point: stop at the first overflow and name its particle and quantity. Same
    /// digits, about five times slower
    #[arg(long)]
    pub check_overflow: bool,
    /// Fixed point: go on, with a warning, where sums cannot be proven to stay in the range of the
    /// format
    #[arg(long)]
    pub allow_unproven: bool,
}

const RESUME_EXAMPLES: &str = "\
Examples:
  motes run sod3d --checkpoint-every 10m            a run that keeps checkpoints
  motes resume out/sod3d                            from the last one, after whatever ended it
  motes resume out/sod3d/checkpoints/step_000500.motes
  motes inspect out/sod3d                           what it is of

State, series and files are, to the bit, those of a run that was never interrupted.
Exit codes: as those of `motes run`.";

#[derive(Args)]
#[command(after_help = RESUME_EXAMPLES)]
pub(super) struct ResumeArguments {
    /// The folder of a run, or one of its checkpoints
    #[arg(value_name = "FILE|DIR")]
    pub from: PathBuf,
    /// Number of threads; 0 for all cores. The results do not depend on it
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub threads: usize,
    /// Folder for the results [default: that of the run]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// As for `motes run`
    #[arg(long, value_name = "STEPS|TIME")]
    pub checkpoint_every: Option<Often>,
    /// Print one JSON object on standard output, and nothing else
    #[arg(long)]
    pub json: bool,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
    /// Stop a run that at its pace would take more days than this
    #[arg(long, default_value_t = LONGEST, value_name = "DAYS")]
    pub longest: f64,
}

#[derive(Args)]
pub(super) struct NewArguments {
    /// The file to write, which must not be there yet
    #[arg(value_name = "FILE.toml")]
    pub file: PathBuf,
    /// The built-in scenario to begin with, see `motes list`
    #[arg(long, default_value = "sod", value_name = "NAME")]
    pub from: String,
}

#[derive(Args)]
pub(super) struct InspectArguments {
    /// The folder of a run, or one of its checkpoints
    #[arg(value_name = "FILE|DIR")]
    pub from: PathBuf,
    /// Print one JSON object on standard output, and nothing else
    #[arg(long)]
    pub json: bool,
}

const SUITE_EXAMPLES: &str = "\
Examples:
  motes suite                            all of it in f64, f32 and q12.19: some 20 minutes
  motes suite sod noh1d                  two of its scenarios
  motes suite --scalars f64 --json       for a script

Files written into --out: accuracy.md, accuracy.html, images/. Fixed point is for the
one-dimensional part. Exit codes: 0 all bounds kept, 1 a bound missed or a run failed, 2 the
input cannot be used, 130 interrupted.";

#[derive(Args)]
#[command(after_help = SUITE_EXAMPLES)]
pub(super) struct SuiteArguments {
    /// Scenarios of the suite; all without
    #[arg(value_name = "NAME")]
    pub cases: Vec<String>,
    /// The number formats, separated by commas
    #[arg(long, default_value = SUITE_SCALARS, value_delimiter = ',', value_name = "SCALARS")]
    pub scalars: Vec<String>,
    /// Number of threads; 0 for all cores. The results do not depend on it
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub threads: usize,
    /// Folder for the report
    #[arg(long, default_value = SUITE_FOLDER, value_name = "DIR")]
    pub out: PathBuf,
    /// Print the rows as one JSON list on standard output, and nothing else
    #[arg(long)]
    pub json: bool,
}

/// Where the report of the suite goes.
pub(super) const SUITE_FOLDER: &str = "out/suite";

/// The formats of the suite that this build has.
#[cfg(feature = "fixed-point")]
pub(super) const SUITE_SCALARS: &str = "f64,f32,q12.19";
#[cfg(not(feature = "fixed-point"))]
pub(super) const SUITE_SCALARS: &str = "f64,f32";

#[derive(Args)]
pub(super) struct ExportArguments {
    /// A built-in scenario, or a file that ends in .toml
    #[arg(value_name = "NAME|FILE.toml")]
    pub scenario: String,
    /// Number of particles; the same as --set resolution.particles=N
    #[arg(short = 'n', long, value_name = "N")]
    pub particles: Option<String>,
    /// Change a value of the scenario; may be given several times
    #[arg(long = "set", value_name = "SECTION.KEY=VALUE")]
    pub overrides: Vec<String>,
}

#[derive(Args)]
pub(super) struct BenchArguments {
    /// Which cases: 1d, 2d, 3d; all without
    #[arg(value_name = "CASE")]
    pub cases: Vec<String>,
    /// The number format: f32, f64
    #[arg(long, default_value = "f32", value_name = "SCALAR")]
    pub scalar: String,
    /// Number of threads; 0 for all cores
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub threads: usize,
    /// Print one JSON list on standard output, and nothing else
    #[arg(long)]
    pub json: bool,
}

const CONVERGE_EXAMPLES: &str = "\
Examples:
  motes converge sound-wave                         four levels, up to its own 200 particles
  motes converge sod --ladder 225,450,900 --json    for a script
  motes converge acoustics1d --set cut-off.name=smooth-4 --set cut-off.eta=1
  motes converge yee-vortex --levels 2 --field velocity --norm l2

Files written into --out: converge.csv, converge.svg. The scenario needs an exact solution
(output.exact). Exit codes: 0 done, 1 a run failed, 2 the input cannot be used, 130
interrupted.";

#[derive(Args)]
#[command(after_help = CONVERGE_EXAMPLES)]
pub(super) struct ConvergeArguments {
    /// A built-in scenario, or a file that ends in .toml
    #[arg(value_name = "NAME|FILE.toml")]
    pub scenario: String,
    /// Number of levels; from each to the next the spacing halves
    #[arg(long, default_value_t = 4, value_name = "K")]
    pub levels: u32,
    /// Number of particles of the coarsest level [default: such that the finest is the
    /// scenario's own, but no less than what its cut-off fits into]
    #[arg(short = 'n', long, value_name = "N")]
    pub particles: Option<String>,
    /// The numbers of particles themselves, separated by commas
    #[arg(long, value_delimiter = ',', value_name = "N,N,N", conflicts_with_all = ["levels", "particles"])]
    pub ladder: Vec<String>,
    /// The field compared: of a gas density, velocity, pressure or energy [default: the first that
    /// it holds to a tolerance]; of a linear system a component, `state` or `reconstruction`
    #[arg(long, value_name = "FIELD")]
    pub field: Option<String>,
    /// The norm of the orders: l1, l2 or linf [default: l1 of a gas, l2 of a linear system]
    #[arg(long, value_parser = ErrorNorm::ALL.map(ErrorNorm::name), value_name = "NORM")]
    pub norm: Option<String>,
    /// The number format: f64, f32, micromath, or fixed point such as q12.19
    #[arg(long, default_value = "f64", value_name = "SCALAR")]
    pub scalar: String,
    /// Number of threads; 0 for all cores. The results do not depend on it
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub threads: usize,
    /// Folder for the results [default: out/converge-<name>]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Change a value of the scenario; may be given several times
    #[arg(long = "set", value_name = "SECTION.KEY=VALUE")]
    pub overrides: Vec<String>,
    /// Stop a run that at its pace would take more days than this
    #[arg(long, default_value_t = LONGEST, value_name = "DAYS")]
    pub longest: f64,
    /// Print one JSON object on standard output, and nothing else
    #[arg(long)]
    pub json: bool,
}

/// The scenario of that name or file, a gas or a linear system, with its changes.
pub(super) fn any_scenario(
    name: &str,
    particles: Option<&str>,
    overrides: &[String],
) -> Result<AnyScenario, Failure> {
    let overrides = with_particles(particles, overrides)?;
    AnyScenario::read(Source::from(name), &overrides).map_err(|error| Failure::Input(error.into()))
}

/// The changes of `--set`, and on top of them that of `--particles`.
fn with_particles(particles: Option<&str>, overrides: &[String]) -> Result<Vec<String>, Failure> {
    let mut overrides = overrides.to_vec();
    if let Some(particles) = particles {
        overrides.push(format!(
            "resolution.particles={}",
            whole_number("--particles", particles)?
        ));
    }
    Ok(overrides)
}

/// A positive whole number, also as 1e6, that stands behind a flag.
pub(super) fn whole_number(flag: &str, text: &str) -> Result<u64, Failure> {
    let exact = text.parse::<u64>().ok();
    let scientific = || {
        text.parse::<f64>()
            .ok()
            .filter(|x| x.fract() == 0.0 && *x < 1e18)
    };
    match exact.or_else(|| scientific().filter(|x| *x >= 0.0).map(|x| x as u64)) {
        Some(number) if number > 0 => Ok(number),
        _ => Err(Failure::Input(miette::miette!(
            help = "give a whole number above 0, such as -n 900 or -n 1e6",
            "{flag} {} is not a number of particles",
            shortened(text)
        ))),
    }
}

/// The scalar of that name, or an error that lists them.
pub(super) fn scalar(name: &str) -> Result<ScalarName, Failure> {
    name.parse()
        .map_err(|error: UnknownScalar| Failure::Input(error.into()))
}
