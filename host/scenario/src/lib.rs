//! Scenarios of motes: what to simulate, read from TOML and checked once.
//!
//! Turns text into values and solves nothing: what reads, lists or writes scenarios needs this
//! crate alone. A file describes a gas ([`Scenario`]) or, with `[system]`, a linear first-order
//! system or convection-diffusion ([`LinearScenario`]); [`AnyScenario`] is either. After reading,
//! every number is finite and in its range, every list has the scenario's dimension, and every box
//! lies in the domain. `docs/scenario.md` has every key.
//!
//! ```
//! use motes_scenario::{AnyScenario, Source};
//!
//! // A built-in scenario, or a file: "tube.toml". Changes are those of `motes run --set`.
//! let changes = ["material.gamma=1.6".to_owned()];
//! let AnyScenario::Gas(sod) = AnyScenario::read(Source::from("sod"), &changes)? else {
//!     unreachable!("sod has no [system]");
//! };
//! assert_eq!((sod.dimension, sod.resolution.particles), (1, 900));
//! assert_eq!(sod.regions[1].pressure, 0.1);
//! // The text after the changes, with the comments of the file: reading it gives `sod` again.
//! assert!(sod.text.contains("gamma = 1.6                       # > 1; 1.4 for air"));
//! # Ok::<(), motes_scenario::ScenarioError>(())
//! ```
//!
//! What cannot be used is refused with its place in the text and its cure:
//!
//! ```
//! use motes_scenario::{AnyScenario, Source};
//!
//! let refused = AnyScenario::read(Source::from("sod"), &["material.gamma=0.9".to_owned()]);
//! let error = refused.unwrap_err();
//! assert_eq!(error.to_string(), "material.gamma = 0.9 is out of range: need > 1");
//! // As a `miette::Report` it also shows the line and the cure.
//! assert!(error.line_and_column().is_some());
//! ```
//!
//! # Modules
//!
//! | files | hold |
//! |---|---|
//! | `source`, `files`, `builtin` | where text comes from: a file, or what comes with the program |
//! | `document` | the text, parsed once |
//! | `set`, `edit` | `--set section.key=value`, made in the text |
//! | `keys` | the one list of sections and keys, which reading, `--set` and messages share |
//! | `section`, `entry`, `bound` | typed values out of a parsed document, each with its place |
//! | `define` | constants and functions of the user, for formulas |
//! | `check` | from a source to a scenario |
//! | `heading`, `domain`, `geometry`, `resolution`, `cut_off`, `output`, `tolerance` | the sections that every scenario has |
//! | [`gas`] | the sections of a gas |
//! | [`linear`] | those of linear systems and convection-diffusion |
//! | [`table`] | CSV files of particles or times |
//! | `read` | the bytes of a file, bounded |
//! | `error`, `problem`, `help`, `nearest`, `snippet` | what is wrong, where, and the cure |

mod any;
mod bound;
mod builtin;
mod check;
mod cut_off;
mod define;
mod document;
mod domain;
mod edit;
mod entry;
mod error;
mod files;
pub mod gas;
mod geometry;
mod heading;
mod help;
mod keys;
pub mod linear;
mod nearest;
mod output;
mod problem;
mod read;
mod resolution;
mod section;
mod set;
mod snippet;
mod source;
pub mod table;
#[cfg(test)]
mod tests;
mod tolerance;

pub use any::AnyScenario;
pub use builtin::{BUILT_IN, BuiltIn, SHIPPED_FILES, ShippedFile, built_in, shipped_file};
pub use cut_off::{CutOff, Width, fineness};
pub use domain::{Ball, Domain, Extent, Side};
pub use error::ScenarioError;
pub use gas::{
    Anchor, Arrangement, Deposit, Diffusion, EnergyRule, EquationOfState, Exact, GradientKind,
    Inflow, Material, NoSlipWalls, Outflow, Output, Piece, Profile, Region, Resolution, Ring,
    Scenario, Share, StateFormulas, Switch, Time, Viscosity, ViscosityKind, Weights,
};
pub use heading::Units;
pub use keys::Family;
pub use linear::LinearScenario;
pub use motes_formula as formula;
pub use output::{Interval, SnapshotFormat, Snapshots};
pub use problem::Problem;
pub use snippet::{shortened, shortened_sentence};
pub use source::Source;
pub use tolerance::{Field, Norm, Tolerance};
