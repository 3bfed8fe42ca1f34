//! The flows that scenarios name: from a profile to what it is at any time.

use crate::exact::flow::{Flow, FlowError};
use crate::exact::gresho::GreshoProblem;
use crate::exact::moving_centre::MovingCentre;
use crate::exact::noh::NohProblem;
use crate::exact::sound_wave::SoundWaveProblem;
use crate::exact::yee_vortex::YeeVortexProblem;
use crate::scenario::{EquationOfState, Profile, Scenario, Side};

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
        Profile::KelvinHelmholtz => None,
    })
}
