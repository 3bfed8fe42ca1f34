//! States that vary from place to place.

use std::f64::consts::PI;

use super::arrange::Arranger;
use super::block::Block;
use super::{Placed, SetupError, sampled};
use crate::scenario::{Arrangement, EquationOfState, Profile, Scenario, Share};

/// The state of the gas at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State {
    pub(super) density: f64,
    pub(super) velocity: [f64; 3],
    pub(super) pressure: f64,
}

/// The state at t = 0 as a function of the place.
pub(super) type Field = Box<dyn Fn([f64; 3]) -> State>;

/// The particles of a profile.
pub(super) fn place(profile: &Profile, scenario: &Scenario) -> Result<Vec<Placed>, SetupError> {
    let state = initial(profile, scenario);
    let block = Block::new(&scenario.domain.extent, &scenario.domain);
    let resolution = &scenario.resolution;
    let even = resolution.arrangement == Arrangement::EqualMass && resolution.share == Share::Mass;
    if resolution.arrangement == Arrangement::Sampled || even && !profile.is_uniform() {
        let (points, mass) = sampled::points(&block, resolution.particles, &state);
        return Ok(points
            .into_iter()
            .map(|point| placed(scenario, state(point), point, mass))
            .collect());
    }
    let volume = block.volume() / resolution.particles as f64;
    let points = Arranger::new(scenario).points(&block, volume)?;
    let volume = block.volume() / points.len() as f64;
    let place = |point| {
        let state = state(point);
        placed(scenario, state, point, state.density * volume)
    };
    Ok(points.into_iter().map(place).collect())
}

fn placed(scenario: &Scenario, state: State, position: [f64; 3], mass: f64) -> Placed {
    let law = &scenario.materials[0].law;
    Placed {
        position,
        velocity: state.velocity,
        mass,
        density: state.density,
        pressure: state.pressure,
        energy: law.energy(state.density, state.pressure),
        material: 0,
    }
}

/// The state at t = 0: the one place where a profile's name becomes its formula.
fn initial(profile: &Profile, scenario: &Scenario) -> Field {
    // Reading sees to it that the first material is an ideal gas.
    let gamma = match scenario.materials[0].law {
        EquationOfState::IdealGas { gamma } | EquationOfState::StiffenedGas { gamma, .. } => gamma,
        EquationOfState::Isothermal { .. } | EquationOfState::Tait { .. } => 1.0,
    };
    let extent = &scenario.domain.extent;
    match *profile {
        Profile::Noh {
            density,
            speed,
            pressure,
        } => Box::new(move |x| noh(x, density, speed, pressure)),
        Profile::SoundWave {
            amplitude,
            density,
            pressure,
        } => {
            let (start, length) = (extent.lower[0], extent.upper[0] - extent.lower[0]);
            Box::new(move |x| {
                let wave = amplitude * libm::sin(2.0 * PI * ((x[0] - start) / length));
                let sound = (gamma * pressure / density).sqrt();
                State {
                    density: density * (1.0 + wave),
                    velocity: [sound * wave, 0.0, 0.0],
                    pressure: pressure * (1.0 + gamma * wave),
                }
            })
        }
        Profile::YeeVortex {
            strength,
            ref velocity,
        } => {
            let drift = [velocity[0], velocity[1]];
            Box::new(move |x| yee_vortex(x, strength, drift, gamma))
        }
        Profile::Gresho { ref velocity, mach } => {
            let drift = [velocity[0], velocity[1]];
            let centre = mach.map_or(5.0, |mach| 1.0 / (gamma * mach * mach));
            Box::new(move |x| gresho(x, drift, centre))
        }
        Profile::KelvinHelmholtz => Box::new(kelvin_helmholtz),
    }
}

/// `u = -speed x/r`.
fn noh(x: [f64; 3], density: f64, speed: f64, pressure: f64) -> State {
    let r = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt();
    // At the origin no direction is inward: the mean of all of them.
    let inward = if r > 0.0 { -speed / r } else { 0.0 };
    State {
        density,
        velocity: x.map(|x| inward * x),
        pressure,
    }
}

/// `T = 1 - (gamma - 1) beta^2/(8 gamma pi^2) exp(1 - r^2)`, `rho = T^(1/(gamma - 1))`,
/// `p = rho T`, `u = drift + beta/(2 pi) exp((1 - r^2)/2) (-y, x)`.
fn yee_vortex([x, y, _]: [f64; 3], strength: f64, drift: [f64; 2], gamma: f64) -> State {
    let bell = libm::exp(0.5 * (1.0 - (x * x + y * y)));
    let spin = strength / (2.0 * PI) * bell;
    let temperature = 1.0 - (gamma - 1.0) / (2.0 * gamma) * spin * spin;
    let density = libm::pow(temperature, 1.0 / (gamma - 1.0));
    State {
        density,
        velocity: [drift[0] - spin * y, drift[1] + spin * x, 0.0],
        pressure: density * temperature,
    }
}

/// Azimuthal velocity `5r` up to 0.2, `2 - 5r` up to 0.4, then 0; density 1; the pressure
/// balances the centrifugal force, `centre` at r = 0.
fn gresho([x, y, _]: [f64; 3], drift: [f64; 2], centre: f64) -> State {
    let r = (x * x + y * y).sqrt();
    let (spin, rise) = if r < 0.2 {
        (5.0, 12.5 * r * r)
    } else if r < 0.4 {
        let rise = 12.5 * r * r + 4.0 * (1.0 - 5.0 * r + libm::log(5.0 * r));
        (2.0 / r - 5.0, rise)
    } else {
        (0.0, 4.0 * std::f64::consts::LN_2 - 2.0)
    };
    State {
        density: 1.0,
        velocity: [drift[0] - spin * y, drift[1] + spin * x, 0.0],
        pressure: centre + rise,
    }
}

/// Equations (1) to (4) of McNally et al. 2012: gas of density 2 between y = 1/4 and 3/4
/// against gas of density 1, the jumps smoothed over L = 0.025.
fn kelvin_helmholtz([x, y, _]: [f64; 3]) -> State {
    // Half the difference of the two sides, faded by e^(-distance/L) from the nearest jump.
    let distance = (y - 0.25).abs().min((y - 0.75).abs());
    let fade = 0.5 * libm::exp(-distance / 0.025);
    let (density, velocity) = if (0.25..0.75).contains(&y) {
        (2.0 - fade, -0.5 + fade)
    } else {
        (1.0 + fade, 0.5 - fade)
    };
    State {
        density,
        velocity: [velocity, 0.01 * libm::sin(4.0 * PI * x), 0.0],
        pressure: 2.5,
    }
}
