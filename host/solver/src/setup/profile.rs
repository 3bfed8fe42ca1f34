//! States that vary from place to place.

use super::arrange::Arranger;
use super::block::Block;
use super::{Placed, SetupError, sampled};
use crate::exact::flow::FlowState;
use crate::flows;
use crate::scenario::{Arrangement, Profile, Scenario, Share};

/// The particles of a profile.
pub(super) fn place(profile: &Profile, scenario: &Scenario) -> Result<Vec<Placed>, SetupError> {
    let Some(state) = flows::initial(scenario)? else {
        return Ok(Vec::new());
    };
    let block = Block::new(&scenario.domain.extent, &scenario.domain);
    let resolution = &scenario.resolution;
    let even = resolution.arrangement == Arrangement::EqualMass && resolution.share == Share::Mass;
    if resolution.arrangement == Arrangement::Sampled || even && !profile.is_uniform() {
        let (points, mass) = sampled::points(&block, resolution.particles, &state)?;
        return Ok(points
            .into_iter()
            .map(|point| placed(scenario, state(point), point, mass))
            .collect());
    }
    let asked = resolution.particles as f64;
    let points = Arranger::new(scenario).points(&block, block.volume() / asked, asked)?;
    let volume = block.volume() / points.len() as f64;
    let place = |point| {
        let state = state(point);
        placed(scenario, state, point, state.density * volume)
    };
    Ok(points.into_iter().map(place).collect())
}

fn placed(scenario: &Scenario, state: FlowState, position: [f64; 3], mass: f64) -> Placed {
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
