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
//! | `check` | from the document to a scenario |
//! | `geometry`, `region`, `material`, `profile`, `inflow`, `resolution`, `cut_off`, `method`, `output`, `tolerance` | a section of a gas each; some are shared |
//! | [`linear`] | the sections of linear systems and convection-diffusion |
//! | [`table`] | CSV files of particles or times |
//! | `error`, `problem`, `help`, `nearest` | what is wrong, where, and the cure |

mod any;
mod bound;
mod builtin;
mod check;
mod cut_off;
mod document;
mod edit;
mod entry;
mod error;
mod files;
mod geometry;
mod help;
mod inflow;
mod keys;
pub mod linear;
mod material;
mod method;
mod nearest;
mod output;
mod problem;
mod profile;
mod region;
mod resolution;
mod section;
mod set;
mod source;
pub mod table;
#[cfg(test)]
mod tests;
mod tolerance;

pub use any::AnyScenario;
pub use builtin::{BUILT_IN, BuiltIn, SHIPPED_FILES, ShippedFile, built_in, shipped_file};
pub use cut_off::{CutOff, Width};
pub use error::ScenarioError;
pub use inflow::Inflow;
pub use keys::Family;
pub use linear::LinearScenario;
pub use material::{EquationOfState, Material};
pub use method::{Diffusion, EnergyRule, Switch, Time, Viscosity, ViscosityKind, Weights};
pub use output::{Exact, Interval, Output, Ring, SnapshotFormat, Snapshots};
pub use problem::Problem;
pub use profile::Profile;
pub use region::{Deposit, Region};
pub use resolution::{Anchor, Arrangement, Resolution, Share};
pub use source::Source;
pub use tolerance::{Field, Norm, Tolerance};

/// A gas to simulate. All numbers are in the scenario's own units.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Scenario {
    /// Letters, digits, `-` and `_`: fit to name a file.
    pub name: String,
    /// One line for lists and headings; may be empty.
    pub description: String,
    /// 1, 2 or 3: the length of every `Vec` of numbers below.
    pub dimension: usize,
    /// Labels of the units.
    pub units: Units,
    /// The box that is simulated, and its sides.
    pub domain: Domain,
    /// The gas at t = 0, in the order of the file: no two boxes overlap, balls lie on top of
    /// boxes and of earlier balls. Empty with a profile; may be empty with a file.
    pub regions: Vec<Region>,
    /// The gas at t = 0 where it varies from place to place: made of the first material.
    pub profile: Option<Profile>,
    /// The substances, at least one; regions name them by their place here.
    pub materials: Vec<Material>,
    /// What comes in through the inflow side; `None` without one.
    pub inflow: Option<Inflow>,
    /// Energy added at t = 0.
    pub deposits: Vec<Deposit>,
    /// How many particles, and how they are placed.
    pub resolution: Resolution,
    /// What a particle's weight in the sums is.
    pub weights: Weights,
    /// The function that smears a particle.
    pub cut_off: CutOff,
    /// The pseudo-viscosity.
    pub viscosity: Viscosity,
    /// Factor of the artificial conductivity, >= 0; 0 for none.
    pub conduction: f64,
    /// Physical diffusion.
    pub diffusion: Diffusion,
    /// Acceleration of everything.
    pub acceleration: Vec<f64>,
    /// How long, and in what steps.
    pub time: Time,
    /// What is written and measured.
    pub output: Output,
    /// The largest errors that a run may have; empty without `output.exact`.
    pub tolerances: Vec<Tolerance>,
    /// The TOML text after `--set`, comments included: reading it gives this scenario.
    pub text: String,
}

/// Labels of the units, `"1"` for none; nothing is converted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Units {
    /// Of lengths.
    pub length: String,
    /// Of masses.
    pub mass: String,
    /// Of times.
    pub time: String,
}

/// An axis-aligned box: `lower < upper` in every direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Extent {
    /// The corner with the smallest coordinates.
    pub lower: Vec<f64>,
    /// The corner with the largest coordinates.
    pub upper: Vec<f64>,
}

impl Extent {
    /// The product of its lengths.
    pub fn volume(&self) -> f64 {
        let lengths = self.lower.iter().zip(&self.upper);
        lengths.map(|(lower, upper)| upper - lower).product()
    }

    /// The coordinate of its middle along a direction; 0 beyond its dimension.
    pub fn middle(&self, axis: usize) -> f64 {
        let bounds = self.lower.get(axis).zip(self.upper.get(axis));
        bounds.map_or(0.0, |(lower, upper)| 0.5 * (lower + upper))
    }

    /// Whether a point is in it, its sides included.
    pub fn contains(&self, point: &[f64]) -> bool {
        let bounds = self.lower.iter().zip(&self.upper).zip(point);
        bounds
            .into_iter()
            .all(|((lower, upper), x)| (lower..=upper).contains(&x))
    }
}

/// The box that is simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct Domain {
    /// Its place.
    pub extent: Extent,
    /// A direction: the side at `lower`, the side at `upper`; both or none periodic. One
    /// direction at most has inflow and outflow sides, and one side at most is an inflow.
    pub sides: Vec<[Side; 2]>,
}

impl Domain {
    /// Between which coordinates a particle may be along a direction: infinite where the side
    /// is free.
    pub fn bounds(&self, axis: usize) -> [f64; 2] {
        let sides = self.sides[axis];
        let bound = |end: usize, side: f64, beyond: f64| match sides[end] {
            Side::Free => beyond,
            _ => side,
        };
        [
            bound(0, self.extent.lower[axis], f64::NEG_INFINITY),
            bound(1, self.extent.upper[axis], f64::INFINITY),
        ]
    }
}

/// What happens at a side of the domain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// What leaves comes in at the other side.
    Periodic,
    /// A wall: the gas is mirrored.
    Mirror,
    /// Nothing: particles may leave.
    Free,
    /// Gas comes in.
    Inflow,
    /// Gas goes out.
    Outflow,
}

impl Side {
    /// Whether gas is taken in or out there.
    pub fn is_open(self) -> bool {
        matches!(self, Self::Inflow | Self::Outflow)
    }
}

/// A ball: an interval in one dimension, a disc in two.
#[derive(Debug, Clone, PartialEq)]
pub struct Ball {
    /// Its centre.
    pub center: Vec<f64>,
    /// > 0.
    pub radius: f64,
}

impl Ball {
    /// The box around it.
    pub fn extent(&self) -> Extent {
        Extent {
            lower: self.center.iter().map(|x| x - self.radius).collect(),
            upper: self.center.iter().map(|x| x + self.radius).collect(),
        }
    }

    /// Squared distance of a point from the centre.
    pub fn distance_squared(&self, point: &[f64]) -> f64 {
        let components = self.center.iter().zip(point);
        components.map(|(c, x)| (x - c) * (x - c)).sum()
    }
}

/// What a scenario says of the state at t = 0.
struct Gas {
    regions: Vec<Region>,
    profile: Option<Profile>,
    deposits: Vec<Deposit>,
    materials: Vec<Material>,
}

impl Scenario {
    /// Reads a scenario that describes a gas; `overrides` are `section.key=value` as given to `--set`,
    /// the later ones on top of the earlier.
    ///
    /// # Errors
    /// Whatever keeps the text from being a scenario: the first fault found, with
    /// its place and cure. A linear system is one.
    pub fn read(source: Source, overrides: &[String]) -> Result<Self, ScenarioError> {
        check::read(&source, overrides, check::gas)
    }

    /// The direction across which the two regions of a Riemann problem touch; none if it is
    /// no Riemann problem.
    pub fn riemann_direction(&self) -> Option<usize> {
        geometry::riemann_direction(&self.regions).ok()
    }
}
