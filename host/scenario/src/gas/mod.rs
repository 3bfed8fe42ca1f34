//! Gases: regions or a profile at t = 0, and what acts on them.

mod inflow;
mod material;
mod method;
mod outflow;
mod output;
mod profile;
mod region;
mod resolution;
mod wall;

use crate::define::Definitions;
use crate::domain::Domain;
use crate::error::{Fault, ScenarioError};
use crate::files::Files;
use crate::heading::{self, Units};
use crate::problem::Problem;
use crate::section::Section;
use crate::source::Source;
use crate::tolerance::{self, Tolerance};
use crate::{CutOff, check, cut_off};

pub use inflow::Inflow;
pub use material::{EquationOfState, Material};
pub use method::{
    Diffusion, EnergyRule, GradientKind, Switch, Time, Viscosity, ViscosityKind, Weights,
};
pub use outflow::Outflow;
pub use output::{Exact, Output, Ring};
pub use profile::{Piece, Profile, StateFormulas};
pub use region::{Deposit, Region};
pub use resolution::{Anchor, Arrangement, Resolution, Share};
pub use wall::NoSlipWalls;

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
    /// The gas far beyond the outflow sides.
    pub outflow: Outflow,
    /// Energy added at t = 0.
    pub deposits: Vec<Deposit>,
    /// How many particles, and how they are placed.
    pub resolution: Resolution,
    /// What a particle's weight in the sums is.
    pub weights: Weights,
    /// The function that smears a particle.
    pub cut_off: CutOff,
    /// What the forces of pressure act along.
    pub gradient: GradientKind,
    /// The pseudo-viscosity.
    pub viscosity: Viscosity,
    /// Factor of the artificial conductivity, >= 0; 0 for none.
    pub conduction: f64,
    /// Physical diffusion.
    pub diffusion: Diffusion,
    /// The walls that the gas sticks to by its viscosity.
    pub walls: NoSlipWalls,
    /// Acceleration of everything.
    pub acceleration: Vec<f64>,
    /// The pressure that the forces between particles leave out, >= 0; 0 for none.
    pub background: f64,
    /// How long, and in what steps.
    pub time: Time,
    /// What is written and measured.
    pub output: Output,
    /// The largest errors that a run may have; empty without `output.exact`.
    pub tolerances: Vec<Tolerance>,
    /// The TOML text after `--set`, comments included: reading it gives this scenario.
    pub text: String,
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
        region::riemann_direction(&self.regions).ok()
    }

    /// The direction across the walls of a channel.
    ///
    /// # Errors
    /// Why there is no channel.
    pub fn channel(&self) -> Result<usize, &'static str> {
        wall::channel(
            (&self.walls, &self.domain),
            &self.acceleration,
            &self.regions,
        )
    }

    /// The point around which the solution is round, with zeros beyond the dimension; `None` in one
    /// dimension, and of what is not.
    pub fn center(&self) -> Option<[f64; 3]> {
        if self.dimension == 1 {
            return None;
        }
        match (self.output.exact, &self.profile) {
            (Some(Exact::Sedov), _) => {
                let center = &self.deposits.first()?.ball.center;
                Some(std::array::from_fn(|i| {
                    center.get(i).copied().unwrap_or(0.0)
                }))
            }
            (_, Some(Profile::Noh { .. })) => Some([0.0; 3]),
            (_, Some(Profile::YeeVortex { velocity, .. } | Profile::Gresho { velocity, .. })) => {
                velocity.iter().all(|&u| u == 0.0).then_some([0.0; 3])
            }
            _ => None,
        }
    }
}

/// The scenario of a text.
pub(super) fn scenario(
    root: &Section<'_>,
    files: Files<'_>,
    text: &str,
) -> Result<Scenario, Fault> {
    let section = |key| root.required(key)?.section();
    let heading = heading::heading(root)?;
    let (dimension, domain) = (heading.dimension, heading.domain);
    let force = method::force(root, &domain)?;
    let definitions = Definitions::of(root, dimension)?;
    let gas = state(root, &domain, &definitions)?;
    let resolution = resolution::resolution(
        &section("resolution")?,
        files.folder(),
        &domain,
        gas.profile.as_ref(),
    )?;
    // A file of particles says itself how the gas is.
    let described = !gas.regions.is_empty() || gas.profile.is_some();
    if !described && !matches!(resolution.arrangement, Arrangement::File(_)) {
        return Err(Fault::new(Problem::Gas { both: false }, root.span()));
    }
    let output = output::output(root, &domain.extent, &gas, &definitions)?;
    inflow::check_output(root, &domain, &output)?;
    let diffusion = method::diffusion(root)?;
    let scenario = Scenario {
        name: heading.name,
        description: heading.description,
        dimension,
        units: heading.units,
        inflow: inflow::inflow(root, &domain, &gas.materials)?,
        outflow: outflow::outflow(root, &domain, &gas.materials)?,
        walls: wall::walls(root, &domain, &diffusion)?,
        domain,
        regions: gas.regions,
        profile: gas.profile,
        materials: gas.materials,
        deposits: gas.deposits,
        resolution,
        weights: method::weights(root)?,
        cut_off: cut_off::of_gas(root, dimension)?,
        gradient: method::gradient(root)?,
        viscosity: method::viscosity(root)?,
        conduction: method::conduction(root)?,
        diffusion,
        acceleration: force.acceleration,
        background: force.background,
        time: method::time(&section("time")?)?,
        tolerances: tolerance::of_gas(root, output.exact.is_some())?,
        output,
        text: text.to_owned(),
    };
    output::check_channel(root, &scenario.output, scenario.channel())?;
    tolerance::check_center(root, scenario.center().is_some())?;
    Ok(scenario)
}

/// What there is at t = 0.
fn state(root: &Section<'_>, domain: &Domain, definitions: &Definitions<'_>) -> Result<Gas, Fault> {
    let materials = material::materials(root)?;
    let (region, profile) = (root.optional("region"), root.optional("profile"));
    if let (Some(_), Some(profile)) = (&region, &profile) {
        return Err(profile.fault(Problem::Gas { both: true }));
    }
    let pieces = match &region {
        Some(entry) => region::pieces(entry, &domain.extent, &materials, definitions)?,
        None => None,
    };
    let region = region.filter(|_| pieces.is_none());
    Ok(Gas {
        regions: match region {
            Some(entry) => region::regions(&entry, &domain.extent, &materials)?,
            None => Vec::new(),
        },
        profile: match profile {
            Some(entry) => Some(profile::profile(&entry, domain, &materials, definitions)?),
            None => pieces.map(Profile::Formula),
        },
        deposits: region::deposits(root, &domain.extent, &materials)?,
        materials,
    })
}
