//! The solution that belongs to the initial state of a first-order system.

use crate::exact::linear::acoustics::{
    Medium, plane::AcousticWaveProblem, pulse::AcousticPulseProblem, pulse::Pulse,
    radial::RadialPulseProblem,
};
use crate::exact::linear::elastic::ElasticProblem;
use crate::exact::linear::error::SolutionError;
use crate::exact::linear::linearised_gas::LinearisedGasProblem;
use crate::exact::linear::maxwell::MaxwellProblem;
use crate::exact::linear::modes::ModeProblem;
use crate::exact::linear::plane_wave::PlaneWave;
use crate::exact::linear::shallow_water::ShallowWaterProblem;
use crate::exact::linear::system::System as Coefficients;
use crate::exact::linear::telegraph::TelegraphProblem;
use crate::exact::linear::transport::TransportProblem;
use crate::exact::solution::Solution;
use crate::families::strengths::{flow, length, periods, spread, wave_vector};
use crate::scenario::linear::{Initial, LinearScenario, System};

/// The solution of a scenario; `None` where a file holds its initial state.
///
/// # Errors
/// Numbers for which there is none.
pub(in crate::families) fn solution(
    scenario: &LinearScenario,
) -> Result<Option<Box<dyn Solution>>, SolutionError> {
    let Some(initial) = &scenario.initial else {
        return Ok(None);
    };
    let solution: Box<dyn Solution> = match initial {
        Initial::Gaussian {
            center,
            width,
            amplitude,
        } => gaussian(scenario, spread(center), *width, *amplitude)?,
        Initial::ExpSine => Box::new(pulse(
            scenario,
            Pulse::ExpSine {
                length: length(scenario, 0),
                lower: scenario.domain.extent.lower[0],
            },
        )?),
        Initial::PlaneWave { wave, amplitude } => plane_wave(scenario, wave, *amplitude)?,
        Initial::StandingWave { wave, amplitude } => standing_wave(scenario, wave, *amplitude)?,
        Initial::Modes { wave, state } => mode(scenario, wave, state)?,
        Initial::Uniform { .. }
        | Initial::Band { .. }
        | Initial::Legendre { .. }
        | Initial::Spots { .. }
        | Initial::Formula { .. }
        | Initial::Manufactured { .. } => return Ok(None),
    };
    Ok(Some(solution))
}

/// The medium of acoustics; that of no other system is asked for.
fn medium(scenario: &LinearScenario) -> Medium {
    match scenario.system {
        System::Acoustics {
            density,
            sound_speed,
        } => Medium {
            density,
            sound_speed,
        },
        _ => Medium {
            density: 1.0,
            sound_speed: 1.0,
        },
    }
}

fn pulse(scenario: &LinearScenario, pulse: Pulse) -> Result<impl Solution + use<>, SolutionError> {
    let medium = medium(scenario);
    AcousticPulseProblem { medium, pulse }.solve()
}

fn gaussian(
    scenario: &LinearScenario,
    center: [f64; 3],
    width: f64,
    amplitude: f64,
) -> Result<Box<dyn Solution>, SolutionError> {
    Ok(match &scenario.system {
        System::Transport {
            velocity,
            decay,
            source,
        } => Box::new(
            TransportProblem {
                field: flow(scenario, velocity),
                center,
                width,
                amplitude,
                decay: *decay,
                source: *source,
                periods: periods(scenario),
            }
            .solve()?,
        ),
        _ if scenario.dimension == 1 => Box::new(pulse(
            scenario,
            Pulse::Gaussian {
                center: center[0],
                width,
                amplitude,
                period: periods(scenario)[0],
            },
        )?),
        _ => Box::new(
            RadialPulseProblem {
                medium: medium(scenario),
                center: [center[0], center[1]],
                width,
                amplitude,
            }
            .solve()?,
        ),
    })
}

/// A wave that runs: in a solid a pressure and a shear wave, in a gas sound, entropy and, in
/// more than one dimension, vorticity, all with the same wave vector and amplitude.
fn plane_wave(
    scenario: &LinearScenario,
    wave: &[i32],
    amplitude: f64,
) -> Result<Box<dyn Solution>, SolutionError> {
    let wave = PlaneWave {
        wave_vector: wave_vector(scenario, wave),
        amplitude,
    };
    let dimension = scenario.dimension;
    Ok(match &scenario.system {
        System::ShallowWater {
            gravity,
            depth,
            coriolis,
        } => Box::new(
            ShallowWaterProblem {
                depth: *depth,
                gravity: *gravity,
                coriolis: *coriolis,
                wave,
            }
            .solve()?,
        ),
        System::ElasticWaves {
            density,
            lambda,
            mu,
        } => Box::new(
            ElasticProblem {
                density: *density,
                lambda: *lambda,
                mu: *mu,
                pressure_wave: wave,
                shear_wave: wave,
            }
            .solve()?,
        ),
        System::LinearisedGas {
            density,
            pressure,
            gamma,
            velocity,
        } => Box::new(
            LinearisedGasProblem {
                dimension,
                density: *density,
                velocity: spread(velocity),
                pressure: *pressure,
                gamma: *gamma,
                sound: wave,
                entropy: wave,
                vorticity: if dimension > 1 { wave } else { PlaneWave::NONE },
            }
            .solve()?,
        ),
        _ => Box::new(
            AcousticWaveProblem {
                medium: medium(scenario),
                dimension,
                wave,
            }
            .solve()?,
        ),
    })
}

fn standing_wave(
    scenario: &LinearScenario,
    wave: &[i32],
    amplitude: f64,
) -> Result<Box<dyn Solution>, SolutionError> {
    Ok(match &scenario.system {
        System::MaxwellTe {
            permittivity,
            permeability,
        } => Box::new(
            MaxwellProblem {
                permittivity: *permittivity,
                permeability: *permeability,
                lengths: [length(scenario, 0), length(scenario, 1)],
                modes: [wave[0].unsigned_abs(), wave[1].unsigned_abs()],
                amplitude,
            }
            .solve()?,
        ),
        System::Telegraph {
            inductance,
            capacitance,
            resistance,
            conductance,
        } => Box::new(
            TelegraphProblem {
                inductance: *inductance,
                capacitance: *capacitance,
                resistance: *resistance,
                conductance: *conductance,
                wavelength: length(scenario, 0) / f64::from(wave[0].abs()),
                amplitude,
            }
            .solve()?,
        ),
        _ => mode(scenario, wave, &[amplitude])?,
    })
}

/// A wave of a system given by matrices: `state cos k·(x - lower)` at t = 0; whole wavelengths
/// make `lower` a shift of the phase.
fn mode(
    scenario: &LinearScenario,
    wave: &[i32],
    state: &[f64],
) -> Result<Box<dyn Solution>, SolutionError> {
    let (fluxes, reaction) = match &scenario.system {
        System::Matrices { flux, decay, .. } => (flux.clone(), decay.clone()),
        _ => (Vec::new(), Vec::new()),
    };
    let wave_vector = wave_vector(scenario, wave);
    let lower = spread(&scenario.domain.extent.lower);
    let phase: f64 = wave_vector.iter().zip(lower).map(|(k, x)| k * x).sum();
    let times = |factor: f64| state.iter().map(|u| factor * u).collect();
    Ok(Box::new(
        ModeProblem {
            system: Coefficients {
                components: state.len(),
                fluxes,
                reaction,
            },
            wave_vector,
            cosine: times(libm::cos(phase)),
            sine: times(libm::sin(phase)),
        }
        .solve()?,
    ))
}
