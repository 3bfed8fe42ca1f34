//! Velocity fields in solver units.

use motes_core::equation::linear::systems::Units;
use motes_core::equation::linear::{
    Compression, NamedField, Place, Rotation, Shear, Uniform, VelocityField, Wave,
};
use motes_core::scalar::Scalar;

use crate::scenario::Extent;
use crate::scenario::linear::Field;

/// A scenario's field, and what it takes to see it in solver units.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::families) struct PlannedField {
    /// It.
    pub field: Field,
    /// Of the domain, in the scenario's units.
    pub extent: Extent,
    /// What the solver units are.
    pub units: Units,
}

impl PlannedField {
    /// The field in the scalar and dimension of a run.
    pub fn named<S: Scalar, const D: usize>(&self) -> NamedField<S, D> {
        let Units { length, velocity } = self.units;
        let rate = |rate: f64| S::from_f64(rate * length / velocity);
        let center = |center: &[f64]| {
            std::array::from_fn(|i| S::from_f64((center[i] - self.middle(i)) / length))
        };
        match &self.field {
            Field::Still => NamedField::Still,
            Field::Uniform { velocity: u } => NamedField::Uniform(Uniform {
                velocity: std::array::from_fn(|i| S::from_f64(u[i] / velocity)),
            }),
            Field::Rotation { rate: r, center: c } => NamedField::Rotation(Rotation {
                rate: rate(*r),
                center: center(c),
            }),
            Field::Shear { rate: r, center: c } => NamedField::Shear(Shear {
                rate: rate(*r),
                center: center(c),
            }),
            Field::Compression { rate: r, center: c } => NamedField::Compression(Compression {
                rate: rate(*r),
                center: center(c),
            }),
            Field::Wave { amplitude } => NamedField::Wave(Wave {
                amplitude: S::from_f64(amplitude / velocity),
                length: S::from_f64((self.extent.upper[0] - self.extent.lower[0]) / length),
                // The solver's 0 is the middle of the domain.
                phase: S::from_f64(0.5),
            }),
        }
    }

    fn middle(&self, axis: usize) -> f64 {
        0.5 * (self.extent.lower[axis] + self.extent.upper[axis])
    }
}

impl PlannedField {
    /// The largest `|a|` at some places of the scenario; meant for `Units::ONE`.
    pub fn fastest(&self, positions: &[[f64; 3]]) -> f64 {
        let dimension = self.extent.lower.len();
        let speed = |position: &[f64; 3]| {
            let centred: [f64; 3] = std::array::from_fn(|i| match i < dimension {
                true => position[i] - self.middle(i),
                false => 0.0,
            });
            let velocity = match dimension {
                1 => self.velocity::<1>(centred),
                2 => self.velocity::<2>(centred),
                _ => self.velocity::<3>(centred),
            };
            velocity.iter().map(|u| u * u).sum::<f64>().sqrt()
        };
        positions.iter().map(speed).fold(0.0, f64::max)
    }

    fn velocity<const D: usize>(&self, position: [f64; 3]) -> [f64; 3] {
        let place = Place {
            position: std::array::from_fn(|i| position[i]),
            time: 0.0,
        };
        let velocity = self.named::<f64, D>().velocity(&place);
        std::array::from_fn(|i| velocity.get(i).copied().unwrap_or(0.0))
    }
}
