//! Flags of `motes compare` and their help.

use std::path::PathBuf;

use clap::Args;

use crate::cli::watch::LONGEST;

const COMPARE_EXAMPLES: &str = "\
Examples:
  motes compare sod -n 450                          in every format that this build has
  motes compare sod --scalars f64,q12.19,q15.16     in three
  motes compare heat1d --bits 8..28                 fixed point by its bits behind the point
  motes compare wall.toml --scalars f64,f32 --json  for a script

Each run is compared at its end, particle by particle, with that in the finest format, and with the
exact solution where there is one. A format that cannot hold the scenario is told with the reason.
Files written into --out: compare.csv, compare.md, compare.svg.
Exit codes: 0 a format or more ran, 1 none did, 2 the input cannot be used, 130 interrupted.";

#[derive(Args)]
#[command(after_help = COMPARE_EXAMPLES)]
pub(in crate::cli) struct CompareArguments {
    /// A built-in scenario, or a file that ends in .toml
    #[arg(value_name = "NAME|FILE.toml")]
    pub scenario: String,
    /// The number formats, separated by commas [default: all that this build has]
    #[arg(long, value_delimiter = ',', value_name = "SCALARS")]
    pub scalars: Vec<String>,
    /// f64, and the fixed-point formats of this build with A to B bits behind the point
    #[arg(long, value_name = "A..B", conflicts_with = "scalars")]
    pub bits: Option<String>,
    /// The field of the first table, the picture and the line [default: as of `motes converge`; of a
    /// linear system `state`, where particles carry it `reconstruction`]
    #[arg(long, value_name = "FIELD")]
    pub field: Option<String>,
    /// Number of threads, shared by the runs; 0 for all cores. The results do not depend on it
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub threads: usize,
    /// Number of particles; the same as --set resolution.particles=N
    #[arg(short = 'n', long, value_name = "N")]
    pub particles: Option<String>,
    /// Folder for the results [default: out/compare-<name>]
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
