//! Where a scenario lies and how it flows, as exact solutions take it.

use std::f64::consts::TAU;

use crate::exact::linear::transport::field::Field as Flow;
use crate::scenario::Side;
use crate::scenario::linear::{Field, LinearScenario};

/// A vector with zeros beyond the dimension.
pub(in crate::families) fn spread(vector: &[f64]) -> [f64; 3] {
    std::array::from_fn(|i| vector.get(i).copied().unwrap_or(0.0))
}

/// The length of the domain along a direction.
pub(in crate::families) fn length(scenario: &LinearScenario, axis: usize) -> f64 {
    let extent = &scenario.domain.extent;
    extent.upper[axis] - extent.lower[axis]
}

/// `2π` times whole wavelengths over the lengths of the domain.
pub(in crate::families) fn wave_vector(scenario: &LinearScenario, wave: &[i32]) -> [f64; 3] {
    std::array::from_fn(|i| match wave.get(i) {
        Some(&number) => TAU * f64::from(number) / length(scenario, i),
        None => 0.0,
    })
}

/// The periods of a periodic domain.
pub(in crate::families) fn periods(scenario: &LinearScenario) -> [Option<f64>; 3] {
    std::array::from_fn(|i| {
        let sides = scenario.domain.sides.get(i)?;
        (sides[0] == Side::Periodic).then(|| length(scenario, i))
    })
}

/// A velocity field as the solutions take it.
pub(in crate::families) fn flow(scenario: &LinearScenario, field: &Field) -> Flow {
    match field {
        Field::Still => Flow::Still,
        Field::Uniform { velocity } => Flow::Uniform {
            velocity: spread(velocity),
        },
        Field::Rotation { rate, center } => Flow::Rotation {
            rate: *rate,
            center: spread(center),
        },
        Field::Shear { rate, center } => Flow::Shear {
            rate: *rate,
            center: spread(center),
        },
        Field::Compression { rate, center } => Flow::Compression {
            rate: *rate,
            center: spread(center),
            dimension: scenario.dimension,
        },
        Field::Wave { amplitude } => Flow::Wave {
            amplitude: *amplitude,
            lower: scenario.domain.extent.lower[0],
            length: length(scenario, 0),
        },
        // Nothing but the state at t = 0 is asked for then.
        Field::Formula(_) => Flow::Still,
    }
}
