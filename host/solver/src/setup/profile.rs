//! States that vary from place to place.

use super::arrange::Arranger;
use super::block::Block;
use super::{Placed, SetupError, sampled};
use crate::exact::flow::FlowState;
use crate::flows::{self, Field};
use crate::scenario::{Arrangement, Profile, Scenario, Share};

/// The particles of a profile.
pub(super) fn place(profile: &Profile, scenario: &Scenario) -> Result<Vec<Placed>, SetupError> {
    let Some(state) = flows::initial(scenario)? else {
        return Ok(Vec::new());
    };
    let block = Block::new(&scenario.domain.extent, &scenario.domain);
    if let Profile::Formula(_) = profile {
        check(&block, scenario, &state)?;
    }
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

/// Nodes along each direction at which formulas are looked at before particles are placed.
const NODES: [usize; 3] = [4096, 128, 24];

/// Refuses a state that no gas can have, at nodes all over the box.
fn check(block: &Block, scenario: &Scenario, state: &Field) -> Result<(), SetupError> {
    let law = &scenario.materials[0].law;
    let dimension = block.dimension;
    let nodes = NODES[dimension - 1];
    for mut number in 0..nodes.pow(dimension as u32) {
        let mut point = [0.0; 3];
        for (i, x) in point.iter_mut().enumerate().take(dimension) {
            *x = block.at(i, (number % nodes) as f64 + 0.5, nodes);
            number /= nodes;
        }
        let gas = state(point);
        let fault = if !(gas.density.is_finite() && gas.density > 0.0) {
            Some(("density", gas.density, "> 0"))
        } else if let Some(u) = gas.velocity.iter().find(|u| !u.is_finite()) {
            Some(("velocity", *u, "an ordinary number"))
        } else if !gas.pressure.is_finite() {
            Some(("pressure", gas.pressure, "an ordinary number"))
        } else if !law.is_barotropic() && !(law.sound_speed_squared(gas.density, gas.energy) > 0.0)
        {
            Some((
                "pressure",
                gas.pressure,
                "above that at which sound stands still, 0 for an ideal gas",
            ))
        } else {
            None
        };
        if let Some((quantity, value, need)) = fault {
            let position = point[..dimension].to_vec();
            return Err(SetupError::State {
                quantity,
                value,
                need,
                position,
            });
        }
    }
    Ok(())
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
