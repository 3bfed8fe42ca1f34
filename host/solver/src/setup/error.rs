//! Why a scenario gives no particles.

use crate::scenario::table::CloudError;

/// Why a scenario gives no particles.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum SetupError {
    /// A region that would get no particle.
    #[error("region {region} would get no particle: it holds {share:.3} of one")]
    #[diagnostic(help("use more particles (-n, resolution.particles), or remove the region"))]
    EmptyRegion {
        /// Its number, from 0.
        region: usize,
        /// Its share of the particles.
        share: f64,
    },
    /// A deposit with no particle inside.
    #[error(
        "deposit {deposit} holds no particle: its radius is {radius}, the nearest is {nearest:.3e} from its centre"
    )]
    #[diagnostic(help(
        "enlarge deposit.{deposit}.radius, or use more particles (-n, resolution.particles)"
    ))]
    EmptyDeposit {
        /// Its number, from 0.
        deposit: usize,
        /// Its radius.
        radius: f64,
        /// Distance of the particle nearest to its centre; infinite without particles.
        nearest: f64,
    },
    /// A turned lattice of which not even one cell fits.
    #[error(
        "a lattice turned by atan({p}/{q}) needs {cell} particles a cell: too many for this box"
    )]
    #[diagnostic(help(
        "use more particles (-n, resolution.particles), or smaller numbers in resolution.rotation"
    ))]
    Rotation {
        /// Numerator of the tangent.
        p: u32,
        /// Denominator of the tangent.
        q: u32,
        /// Particles of its smallest cell.
        cell: u64,
    },
    /// A lattice of far more points than were asked for.
    #[error(
        "the lattice that fits has {fitted:.3e} particles where {asked:.0} were asked for: \
         the box is thinner than their spacing in some direction"
    )]
    #[diagnostic(help(
        "leave the thin direction out (a lower dimension), make the domain or region less flat, or \
         use more particles (-n, resolution.particles)"
    ))]
    Flat {
        /// How many there would be.
        fitted: f64,
        /// How many there should be.
        asked: f64,
    },
    /// An inflow so dense that one layer of it outnumbers the gas.
    #[error(
        "a layer of the inflow would have {fitted:.3e} particles, the whole gas at the start has \
         {particles}"
    )]
    #[diagnostic(help(
        "bring inflow.density nearer to that of the gas, set resolution.share = \"volume\", or use \
         more particles (-n, resolution.particles)"
    ))]
    Inflow {
        /// How many a layer would have.
        fitted: f64,
        /// How many there are at the start.
        particles: usize,
    },
    /// No memory for the points.
    #[error("there is no memory for {particles:.0} particles")]
    #[diagnostic(help("use fewer particles (-n, resolution.particles)"))]
    Room {
        /// How many.
        particles: f64,
    },
    /// A glass that the engine cannot relax.
    #[error("cannot relax the glass: {source}")]
    #[diagnostic(help(
        "use more particles (-n, resolution.particles): a glass between periodic sides needs at least 9 in each direction"
    ))]
    Glass {
        /// What the engine says.
        source: motes_core::error::Error,
    },
    /// A profile that does not exist.
    #[error("the profile does not exist: {0}")]
    #[diagnostic(help("change the numbers of [profile]"))]
    Profile(#[from] crate::exact::flow::FlowError),
    /// A formula that gives a state that no gas can have.
    #[error("at t = 0 the {quantity} is {value} at x = {position:?}: need {need}")]
    #[diagnostic(help(
        "change the formulas of [profile] so that it is so everywhere in the domain"
    ))]
    State {
        /// Which quantity.
        quantity: &'static str,
        /// What it is.
        value: f64,
        /// What it should be.
        need: &'static str,
        /// Where, in the scenario's units.
        position: Vec<f64>,
    },
    /// More particles than ids.
    #[error("{particles} particles are more than this build can number ({limit})")]
    #[diagnostic(help("use fewer particles (-n, resolution.particles)"))]
    TooMany {
        /// How many were asked for.
        particles: usize,
        /// How many there can be.
        limit: usize,
    },
    /// A file that is no cloud of particles.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Cloud(#[from] Box<CloudError>),
}
