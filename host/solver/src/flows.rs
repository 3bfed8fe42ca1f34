//! The flows that scenarios name: what a profile is at the start, and at any time.

use crate::exact::channel::{ChannelFlow, ChannelProblem};
use crate::exact::finite_volume::{Ends, FiniteVolume, Grid};
use crate::exact::flow::{Flow, FlowError, FlowState};
use crate::exact::formula::FormulaFlow;
use crate::exact::gresho::GreshoProblem;
use crate::exact::kelvin_helmholtz;
use crate::exact::moving_centre::MovingCentre;
use crate::exact::noh::NohProblem;
use crate::exact::sound_wave::SoundWaveProblem;
use crate::exact::taylor_green::TaylorGreenProblem;
use crate::exact::yee_vortex::YeeVortexProblem;
use crate::scenario::{EquationOfState, Piece, Profile, Scenario, Side};

/// The flow that a profile begins, known at all times; `None` where only its beginning is.
///
/// # Errors
/// Numbers for which the flow does not exist.
pub fn profile_flow(scenario: &Scenario) -> Result<Option<Box<dyn Flow>>, FlowError> {
    let (Some(profile), EquationOfState::IdealGas { gamma }) =
        (&scenario.profile, scenario.materials[0].law)
    else {
        return Ok(None);
    };
    let extent = &scenario.domain.extent;
    let length = |i: usize| extent.upper[i] - extent.lower[i];
    let centre = |velocity: &[f64]| MovingCentre {
        position: [0.0; 2],
        velocity: [velocity[0], velocity[1]],
        period: (scenario.domain.sides.iter())
            .all(|sides| *sides == [Side::Periodic; 2])
            .then(|| [length(0), length(1)]),
    };
    Ok(match profile {
        &Profile::Noh {
            density,
            speed,
            pressure,
        } => Some(Box::new(
            NohProblem {
                dimension: scenario.dimension,
                gamma,
                density,
                speed,
                pressure,
            }
            .solve()?,
        )),
        &Profile::SoundWave {
            amplitude,
            density,
            pressure,
        } => Some(Box::new(
            SoundWaveProblem {
                gamma,
                density,
                pressure,
                amplitude,
                wavelength: length(0),
            }
            .solve()?,
        )),
        Profile::YeeVortex { strength, velocity } => Some(Box::new(
            YeeVortexProblem {
                gamma,
                strength: *strength,
                centre: centre(velocity),
            }
            .solve()?,
        )),
        Profile::Gresho { velocity, mach } => Some(Box::new(
            GreshoProblem {
                gamma,
                central_pressure: match *mach {
                    Some(mach) => GreshoProblem::central_pressure_of_mach(mach, gamma),
                    None => 5.0,
                },
                centre: centre(velocity),
            }
            .solve()?,
        )),
        Profile::KelvinHelmholtz | Profile::Formula(_) => None,
        &Profile::TaylorGreen {
            density,
            speed,
            pressure,
        } => Some(Box::new(
            TaylorGreenProblem {
                gamma,
                density,
                speed,
                pressure,
                viscosity: scenario.diffusion.viscosity,
                corner: [extent.lower[0], extent.lower[1]],
                lengths: [length(0), length(1)],
            }
            .solve()?,
        )),
    })
}

/// The flow between the walls of a channel; `None` where there is none.
///
/// # Errors
/// Numbers for which the flow does not exist.
pub fn channel_flow(scenario: &Scenario) -> Result<Option<ChannelFlow>, FlowError> {
    let (Ok(axis), Some(region)) = (scenario.channel(), scenario.regions.first()) else {
        return Ok(None);
    };
    let vector = |of: &[f64]| std::array::from_fn(|i| of.get(i).copied().unwrap_or(0.0));
    let law = &scenario.materials[region.material].law;
    let [lower, upper] = &scenario.walls[axis];
    let velocity = |wall: &Option<Vec<f64>>| wall.as_deref().map_or([0.0; 3], vector);
    let problem = ChannelProblem {
        axis,
        walls: [
            scenario.domain.extent.lower[axis],
            scenario.domain.extent.upper[axis],
        ],
        velocities: [velocity(lower), velocity(upper)],
        viscosity: scenario.diffusion.viscosity,
        acceleration: vector(&scenario.acceleration),
        start: FlowState {
            density: region.density,
            velocity: vector(&region.velocity),
            pressure: region.pressure,
            energy: law.energy(region.density, region.pressure),
        },
    };
    problem.solve().map(Some)
}

/// A gas whose state is given as formulas.
pub fn formula_flow(scenario: &Scenario, pieces: Vec<Piece>) -> FormulaFlow {
    FormulaFlow {
        pieces,
        law: scenario.materials[0].law,
    }
}

/// A state of gas as a function of the place.
pub type Field = Box<dyn Fn([f64; 3]) -> FlowState>;

/// What a scenario's profile is at t = 0; `None` without a profile.
///
/// # Errors
/// Numbers for which the flow does not exist.
pub fn initial(scenario: &Scenario) -> Result<Option<Field>, FlowError> {
    Ok(match &scenario.profile {
        None => None,
        Some(Profile::Formula(pieces)) => {
            let flow = formula_flow(scenario, pieces.clone());
            Some(Box::new(move |position| flow.at(position, 0.0)))
        }
        Some(Profile::KelvinHelmholtz) => Some(Box::new(kelvin_helmholtz::initial)),
        Some(_) => profile_flow(scenario)?
            .map(|flow| -> Field { Box::new(move |position| flow.at(position, 0.0)) }),
    })
}

/// What a scenario is at t = 0: its profile, or its regions.
///
/// # Errors
/// Numbers for which the flow does not exist.
pub fn start(scenario: &Scenario) -> Result<Field, FlowError> {
    if let Some(profile) = initial(scenario)? {
        return Ok(profile);
    }
    let regions = scenario.regions.clone();
    let laws: Vec<EquationOfState> = scenario.materials.iter().map(|of| of.law).collect();
    Ok(Box::new(move |position| {
        let holds = |region: &&crate::scenario::Region| {
            (region.extent.lower[0]..=region.extent.upper[0]).contains(&position[0])
        };
        // Balls lie on top of boxes, later ones over earlier ones.
        let ball = regions.iter().rev().find(|r| r.ball.is_some() && holds(r));
        match ball.or_else(|| regions.iter().find(holds)) {
            Some(region) => FlowState {
                density: region.density,
                velocity: [region.velocity[0], 0.0, 0.0],
                pressure: region.pressure,
                energy: laws[region.material].energy(region.density, region.pressure),
            },
            None => FlowState {
                density: 0.0,
                velocity: [0.0; 3],
                pressure: 0.0,
                energy: 0.0,
            },
        }
    }))
}

/// Cells of the reference solution: its error at a jump is far below that of particles.
const REFERENCE_CELLS: usize = 3200;

/// A converged finite-volume run of a one-dimensional scenario of one ideal gas, at its end.
///
/// # Errors
/// Numbers for which the scheme does not run, or not in a minute.
pub fn reference(
    scenario: &Scenario,
    progress: &mut dyn FnMut(f64),
) -> Result<FiniteVolume, FlowError> {
    let gamma = match scenario.materials[0].law {
        EquationOfState::IdealGas { gamma } => gamma,
        _ => f64::NAN,
    };
    let extent = &scenario.domain.extent;
    let grid = Grid {
        cells: REFERENCE_CELLS,
        extent: [extent.lower[0], extent.upper[0]],
        ends: match scenario.domain.sides[0] {
            [Side::Periodic, _] => Ends::Periodic,
            [Side::Mirror, Side::Mirror] => Ends::Reflecting,
            _ => Ends::Transmissive,
        },
    };
    let start = start(scenario)?;
    let flow = FiniteVolume::new(grid, gamma, |x| start([x, 0.0, 0.0]))?;
    flow.run_to_watched(scenario.time.end, progress)
}
