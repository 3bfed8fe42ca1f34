//! From a scenario to what the solver needs, in solver units.

use motes_core::cutoff::{CutOff, Named};
use motes_core::domain::Side;
use motes_core::equation::gas::{Stretch, Tube, Width};

use crate::scenario::{
    self, Arrangement, CutOffShape, EnergyRule, EquationOfState, Region, Scenario, Share,
    Viscosity, ViscosityKind, Weights,
};
use crate::setup::{SetupError, apportion};
use crate::units::SolverUnits;

/// A one-dimensional gas run in solver units, every number still an `f64`.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// What the solver units are.
    pub units: SolverUnits,
    /// The middle of the domain, in the scenario's units: 0 for the solver.
    pub middle: f64,
    /// Half the length of the domain.
    pub half_length: f64,
    /// Its sides.
    pub sides: [Side; 2],
    /// The gas at the start.
    pub stretches: Vec<Stretch<f64>>,
    /// Ratio of specific heats.
    pub gamma: f64,
    /// Width of the cut-off.
    pub width: Width<f64>,
    /// Pseudo-viscosity.
    pub viscosity: Viscosity,
    /// Duration.
    pub end: f64,
    /// Factor of the time step.
    pub courant: f64,
    /// The cut-off.
    pub cut_off: Named,
}

/// A scenario that cannot be planned.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum PlanError {
    /// Only one dimension so far.
    #[error("`{name}` has dimension {dimension}: `motes run` solves one-dimensional gases so far")]
    #[diagnostic(help(
        "set dimension = 1; `motes bench` exercises the engine in 2 and 3 dimensions"
    ))]
    Dimension {
        /// The scenario.
        name: String,
        /// Its dimension.
        dimension: usize,
    },
    /// Particles cannot be placed.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Setup(SetupError),
    /// Something that can be read but not solved yet.
    #[error("the scenario has {what}: `motes run` does not solve that so far")]
    #[diagnostic(help("take it out of the scenario"))]
    Unsolved {
        /// What it has.
        what: &'static str,
    },
    /// A region that would get no particle.
    #[error("region {region} would get no particle: it holds {share:.3} of one")]
    #[diagnostic(help("use more particles (-n, resolution.particles), or remove the region"))]
    EmptyRegion {
        /// Its number, from 0.
        region: usize,
        /// Its share of the particles.
        share: f64,
    },
    /// A cut-off that reaches too few or too many particles.
    #[error(
        "eta = {eta} makes the cut-off `{cut_off}` reach {reach} spacings: need {least} to {most}"
    )]
    #[diagnostic(help("set cut-off.eta between {} and {}", least / support, most / support))]
    Reach {
        /// Width in spacings.
        eta: f64,
        /// Name of the cut-off.
        cut_off: &'static str,
        /// Its support in units of its width.
        support: f64,
        /// Their product.
        reach: f64,
        /// The least that works.
        least: f64,
        /// The most that is allowed.
        most: f64,
    },
    /// Numbers so large or small that the solver's units are not finite.
    #[error("the unit of {unit} would be {value:e}")]
    #[diagnostic(help("give the scenario in units in which its numbers are nearer to 1"))]
    Extreme {
        /// Which solver unit.
        unit: &'static str,
        /// What it would be.
        value: f64,
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
}

/// Ids, cells and words of neighbour lists are 32 bits wide; cells are up to four a particle.
const LARGEST: usize = 1 << 29;

impl Plan {
    /// Plans a run.
    ///
    /// # Errors
    /// Scenarios that are not one-dimensional, regions too small for one particle.
    pub fn new(scenario: &Scenario) -> Result<Self, PlanError> {
        if scenario.dimension != 1 {
            let (name, dimension) = (scenario.name.clone(), scenario.dimension);
            return Err(PlanError::Dimension { name, dimension });
        }
        let particles = scenario.resolution.particles;
        if particles > LARGEST {
            return Err(PlanError::TooMany {
                particles,
                limit: LARGEST,
            });
        }
        if let Some(what) = unsolved(scenario) {
            return Err(PlanError::Unsolved { what });
        }
        let EquationOfState::IdealGas { gamma } = scenario.materials[0].law else {
            return Err(PlanError::Unsolved {
                what: "another equation of state than ideal-gas",
            });
        };
        let extent = &scenario.domain.extent;
        let (lower, upper) = (extent.lower[0], extent.upper[0]);
        let masses: Vec<f64> = scenario
            .regions
            .iter()
            .map(|region| region.density * (region.extent.upper[0] - region.extent.lower[0]))
            .collect();
        let mass = masses.iter().sum::<f64>() / particles as f64;
        let sound = |region: &Region| (gamma * region.pressure / region.density).sqrt();
        let units = SolverUnits {
            length: (upper - lower) / particles as f64,
            mass,
            velocity: scenario.regions.iter().map(sound).fold(0.0, f64::max),
            dimension: 1,
        };
        check_units(&units)?;
        check_reach(scenario)?;
        let middle = 0.5 * (lower + upper);
        let counts = apportion(&masses, particles).map_err(|error| match error {
            SetupError::EmptyRegion { region, share } => PlanError::EmptyRegion { region, share },
            error => PlanError::Setup(error),
        })?;
        let stretches = scenario.regions.iter().zip(counts).zip(&masses).map(
            |((region, count), &region_mass)| Stretch {
                lower: (region.extent.lower[0] - middle) / units.length,
                upper: (region.extent.upper[0] - middle) / units.length,
                particles: count,
                mass: region_mass / f64::from(count) / units.mass,
                velocity: region.velocity[0] / units.velocity,
                energy: region.pressure / region.density / (gamma - 1.0) / units.energy(),
            },
        );
        Ok(Self {
            units,
            middle,
            half_length: 0.5 * (upper - lower) / units.length,
            sides: scenario.domain.sides[0].map(|side| match side {
                scenario::Side::Free => Side::Free,
                scenario::Side::Periodic => Side::Periodic,
                scenario::Side::Mirror => Side::Mirror,
            }),
            stretches: stretches.collect(),
            gamma,
            width: match scenario.cut_off.width {
                scenario::Width::Adaptive { eta } => Width::Adaptive { eta },
                scenario::Width::Constant { epsilon } => Width::Constant {
                    epsilon: epsilon / units.length,
                },
            },
            viscosity: scenario.viscosity,
            end: scenario.time.end / units.time(),
            courant: scenario.time.courant,
            cut_off: named(scenario.cut_off.shape),
        })
    }

    /// The tube that the core runs.
    pub fn tube(&self) -> Tube<'_> {
        Tube {
            half_length: self.half_length,
            sides: self.sides,
            stretches: &self.stretches,
            gamma: self.gamma,
            width: self.width,
            courant: self.courant,
            end: self.end,
        }
    }

    /// Number of particles.
    pub fn particles(&self) -> usize {
        self.stretches
            .iter()
            .map(|stretch| stretch.particles as usize)
            .sum()
    }
}

/// What a scenario has that is not solved yet, so that nothing is passed over in silence.
fn unsolved(scenario: &Scenario) -> Option<&'static str> {
    let viscosity = &scenario.viscosity;
    let resolution = &scenario.resolution;
    let found = [
        (scenario.profile.is_some(), "a profile"),
        (
            scenario.regions.iter().any(|region| region.ball.is_some()),
            "a ball",
        ),
        (scenario.materials.len() > 1, "several materials"),
        (!scenario.deposits.is_empty(), "a deposit"),
        (
            resolution.arrangement != Arrangement::EqualMass
                || resolution.share != Share::Mass
                || resolution.jitter > 0.0,
            "another arrangement than equal-mass",
        ),
        (scenario.weights != Weights::Mass, "number weights"),
        (
            viscosity.kind == ViscosityKind::Limited
                || viscosity.switch.is_some()
                || viscosity.balsara,
            "a limited or switched viscosity",
        ),
        (scenario.conduction > 0.0, "conduction"),
        (
            scenario.diffusion.viscosity > 0.0 || scenario.diffusion.heat > 0.0,
            "diffusion",
        ),
        (scenario.acceleration.iter().any(|&a| a != 0.0), "a force"),
        (
            scenario.time.energy != EnergyRule::LeapFrog,
            "another energy rule than leapfrog",
        ),
        (scenario.output.ring.is_some(), "a ring"),
        (scenario.output.snapshots.is_some(), "snapshots"),
        (!scenario.tolerances.is_empty(), "tolerances"),
    ];
    found
        .into_iter()
        .find(|(has, _)| *has)
        .map(|(_, what)| what)
}

/// Reaches in spacings between which a density sum makes sense: one neighbour on either side
/// with room to move, and no more than a solver wants to look at.
const REACH: [f64; 2] = [1.5, 40.0];

/// Refuses an η with which particles would see nobody, or everybody.
fn check_reach(scenario: &Scenario) -> Result<(), PlanError> {
    let scenario::Width::Adaptive { eta } = scenario.cut_off.width else {
        return Ok(());
    };
    let cut_off = named(scenario.cut_off.shape);
    let support = f64::from(cut_off.support());
    let ([least, most], reach) = (REACH, eta * support);
    if (least..=most).contains(&reach) {
        return Ok(());
    }
    Err(PlanError::Reach {
        eta,
        cut_off: cut_off.name(),
        support,
        reach,
        least,
        most,
    })
}

/// Refuses units that `f64` cannot hold with room around them.
fn check_units(units: &SolverUnits) -> Result<(), PlanError> {
    let sizes = [
        ("length", units.length),
        ("mass", units.mass),
        ("velocity", units.velocity),
        ("time", units.time()),
        ("energy", units.energy()),
    ];
    match sizes
        .into_iter()
        .find(|(_, value)| !(1e-200..1e200).contains(value))
    {
        Some((unit, value)) => Err(PlanError::Extreme { unit, value }),
        None => Ok(()),
    }
}

/// The core's cut-off of that shape.
fn named(shape: CutOffShape) -> Named {
    match shape {
        CutOffShape::CubicSpline => Named::CubicSpline,
        CutOffShape::QuinticSpline => Named::QuinticSpline,
        CutOffShape::WendlandC2 => Named::WendlandC2,
        CutOffShape::WendlandC4 => Named::WendlandC4,
        CutOffShape::WendlandC6 => Named::WendlandC6,
        CutOffShape::RootFree => Named::RootFree,
    }
}
