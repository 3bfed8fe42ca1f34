//! Scenarios: what to simulate, read from TOML and checked once.
//!
//! After [`Scenario::read`] every number is finite and in its range, every list
//! has the scenario's dimension, and every box lies in the domain.

mod builtin;
mod check;
mod error;
mod geometry;
mod keys;
mod nearest;
mod problem;
mod section;
mod set;
mod source;
#[cfg(test)]
mod tests;

pub use builtin::{BUILT_IN, BuiltIn, built_in};
pub use error::ScenarioError;
pub use problem::Problem;
pub use source::Source;

/// What to simulate. All numbers are in the scenario's own units.
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
    /// The gas at t = 0, in the order of the file; boxes in the domain, none overlapping.
    pub regions: Vec<Region>,
    /// The gas law.
    pub material: Material,
    /// How many particles, and how they are placed.
    pub resolution: Resolution,
    /// The function that smears a particle.
    pub cut_off: CutOff,
    /// The pseudo-viscosity.
    pub viscosity: Viscosity,
    /// How long, and in what steps.
    pub time: Time,
    /// What is written and measured.
    pub output: Output,
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

/// The box that is simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct Domain {
    /// Its place.
    pub extent: Extent,
    /// A direction: the side at `lower`, the side at `upper`; both or none periodic.
    pub sides: Vec<[Side; 2]>,
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
}

/// A box of uniform gas at t = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Its place.
    pub extent: Extent,
    /// Mass / length^dimension, > 0.
    pub density: f64,
    /// Length / time.
    pub velocity: Vec<f64>,
    /// Density * velocity^2, > 0.
    pub pressure: f64,
}

/// The gas law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Material {
    /// `p = (gamma - 1) rho e`.
    IdealGas {
        /// Ratio of the specific heats, > 1.
        gamma: f64,
    },
}

/// How many particles, and how they are placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Resolution {
    /// In all regions together, at least 1.
    pub particles: usize,
    /// How they are placed.
    pub arrangement: Arrangement,
}

/// How the particles are placed at t = 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Arrangement {
    /// All particles have the same mass: denser gas, smaller spacing.
    EqualMass,
}

/// The cut-off: its shape and its width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutOff {
    /// The shape.
    pub shape: CutOffShape,
    /// The width.
    pub width: Width,
}

/// The shape of a cut-off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutOffShape {
    /// The cubic B-spline M4.
    CubicSpline,
    /// The quintic B-spline M6.
    QuinticSpline,
    /// Wendland's C2 function.
    WendlandC2,
    /// Wendland's C4 function.
    WendlandC4,
    /// Wendland's C6 function.
    WendlandC6,
    /// A polynomial in the squared distance: no root to take.
    RootFree,
}

/// The width of a cut-off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Width {
    /// `eps_k = eta (m_k/rho_k)^(1/dimension)`.
    Adaptive {
        /// In mean spacings, > 0.
        eta: f64,
    },
    /// The same for all particles and times.
    Constant {
        /// A length, > 0.
        epsilon: f64,
    },
}

/// The pseudo-viscosity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viscosity {
    /// Its form.
    pub kind: ViscosityKind,
    /// Factor of the linear term, >= 0; 0 for `ViscosityKind::None`.
    pub alpha: f64,
    /// Factor of the quadratic term, >= 0; 0 for `ViscosityKind::None`.
    pub beta: f64,
}

/// The form of the pseudo-viscosity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ViscosityKind {
    /// Along the line of centres, with the signal speed of the pair.
    Pairwise,
    /// Gingold and Monaghan 1983.
    GingoldMonaghan,
    /// Added to the pressure where the gas is compressed.
    VonNeumann,
    /// No pseudo-viscosity.
    None,
}

/// How long, and in what steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Time {
    /// Duration of the run, > 0.
    pub end: f64,
    /// Step / (width / signal speed), in (0, 1].
    pub courant: f64,
}

/// What is written and measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Where errors are measured; in the domain.
    pub window: Extent,
    /// Rows of the time series, equally spaced in time, at least 1.
    pub samples: usize,
    /// The exact solution to compare with.
    pub exact: Option<Exact>,
}

/// An exact solution to compare with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exact {
    /// The Riemann problem: dimension 1, two regions that touch.
    Riemann,
}

impl Scenario {
    /// Reads a scenario; `overrides` are `section.key=value` as given to `--set`,
    /// the later ones on top of the earlier.
    ///
    /// # Errors
    /// Whatever keeps the text from being a scenario: the first fault found, with
    /// its place and cure.
    pub fn read(source: Source, overrides: &[String]) -> Result<Self, ScenarioError> {
        let original = source.text()?;
        if overrides.is_empty() {
            return check::scenario(original, &source.to_string());
        }
        let text = set::with_overrides(&original, &source.to_string(), overrides)?;
        check::scenario(text, &format!("{source} after --set"))
    }
}
