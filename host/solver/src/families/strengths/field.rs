//! Velocity fields in solver units.

use motes_core::cloud::{Frame, Units};
use motes_core::equation::linear::{
    Compression, NamedField, Place, Rotation, Shear, Uniform, VelocityField, Wave,
};
use motes_core::scalar::Scalar;

use super::frame::{BETWEEN, all_over, frame, times};
use crate::scenario::Extent;
use crate::scenario::linear::{Field, FormulaField};

/// A scenario's field, and what it takes to see it in solver units.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::families) struct PlannedField {
    field: Field,
    /// Of the domain, in the scenario's units.
    extent: Extent,
    units: Units,
    /// Of a field of formulas.
    steepest: Steepest,
}

/// Bounds of the slopes of a field, in the scenario's units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Steepest {
    /// Of `|∂_i a^j|`.
    gradient: f64,
    /// Of `-div a`.
    convergence: f64,
}

/// A field in the scalar and dimension of a run.
#[derive(Clone, Debug, PartialEq)]
pub enum RunField<S, const D: usize> {
    /// One that the core has.
    Named(NamedField<S, D>),
    /// Formulas.
    Formula(Box<ScaledField>),
}

/// A field of formulas, seen in solver units. What it computes is an `f64`, rounded once to the
/// scalar.
#[derive(Clone, Debug, PartialEq)]
pub struct ScaledField {
    field: FormulaField,
    frame: Frame,
    steepest: Steepest,
}

impl ScaledField {
    /// Its velocities and their slopes, in the scenario's units.
    pub fn formulas(&self) -> &FormulaField {
        &self.field
    }

    /// The way to their places.
    pub fn frame(&self) -> Frame {
        self.frame
    }
}

impl<S: Scalar, const D: usize> VelocityField<S, D> for ScaledField {
    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        let point = self.frame.point(place);
        let of = |i: usize| self.field.velocity.get(i).map_or(0.0, |of| of.at(&point));
        std::array::from_fn(|i| self.frame.velocity(of(i)))
    }
    fn divergence(&self, place: &Place<S, D>) -> S {
        let point = self.frame.point(place);
        self.frame.rate(divergence(&self.field, &point))
    }
    fn gradient(&self) -> S {
        self.frame.rate(self.steepest.gradient)
    }
    fn convergence(&self) -> S {
        self.frame.rate(self.steepest.convergence)
    }
}

impl<S: Scalar, const D: usize> VelocityField<S, D> for RunField<S, D> {
    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        match self {
            Self::Named(field) => field.velocity(place),
            Self::Formula(field) => field.velocity(place),
        }
    }
    fn divergence(&self, place: &Place<S, D>) -> S {
        match self {
            Self::Named(field) => field.divergence(place),
            Self::Formula(field) => field.divergence(place),
        }
    }
    fn gradient(&self) -> S {
        match self {
            Self::Named(field) => field.gradient(),
            Self::Formula(field) => VelocityField::<S, D>::gradient(&**field),
        }
    }
    fn convergence(&self) -> S {
        match self {
            Self::Named(field) => field.convergence(),
            Self::Formula(field) => VelocityField::<S, D>::convergence(&**field),
        }
    }
    fn is_still(&self) -> bool {
        match self {
            Self::Named(field) => field.is_still(),
            Self::Formula(_) => false,
        }
    }
}

/// `Σ_i ∂_i a_i`.
fn divergence(field: &FormulaField, point: &[f64]) -> f64 {
    let dimension = field.velocity.len();
    let diagonal = field.slopes.iter().step_by(dimension + 1);
    diagonal.map(|slope| slope.at(point)).sum()
}

impl Steepest {
    /// That of a field over a box, from 0 to a time.
    fn of(field: &FormulaField, extent: &Extent, duration: f64) -> Self {
        let mut steepest = Self::default();
        for time in times(duration) {
            all_over(extent, time, |point| {
                let slopes = field.slopes.iter().map(|slope| slope.at(point).abs());
                steepest.gradient = slopes.fold(steepest.gradient, f64::max);
                let converges = -divergence(field, point);
                steepest.convergence = steepest.convergence.max(converges);
            });
        }
        Self {
            gradient: BETWEEN * steepest.gradient,
            convergence: BETWEEN * steepest.convergence,
        }
    }
}

impl PlannedField {
    /// A field over a box, from 0 to a time.
    pub fn new(field: &Field, extent: &Extent, units: Units, duration: f64) -> Self {
        Self {
            steepest: match field {
                Field::Formula(field) => Steepest::of(field, extent, duration),
                _ => Steepest::default(),
            },
            field: field.clone(),
            extent: extent.clone(),
            units,
        }
    }

    /// Another field over the same box.
    pub fn with(&self, field: &Field, duration: f64) -> Self {
        Self::new(field, &self.extent, self.units, duration)
    }

    /// The field in the scalar and dimension of a run.
    pub fn run<S: Scalar, const D: usize>(&self) -> RunField<S, D> {
        let Field::Formula(field) = &self.field else {
            return RunField::Named(self.named());
        };
        RunField::Formula(Box::new(ScaledField {
            field: field.clone(),
            frame: frame(&self.extent, self.units),
            steepest: self.steepest,
        }))
    }

    /// One that the core has, in the scalar and dimension of a run; of formulas none.
    fn named<S: Scalar, const D: usize>(&self) -> NamedField<S, D> {
        let Units { length, velocity } = self.units;
        let rate = |rate: f64| S::from_f64(rate * length / velocity);
        let center = |center: &[f64]| {
            std::array::from_fn(|i| S::from_f64((center[i] - self.middle(i)) / length))
        };
        match &self.field {
            Field::Still | Field::Formula(_) => NamedField::Still,
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
        let velocity = self.run::<f64, D>().velocity(&place);
        std::array::from_fn(|i| velocity.get(i).copied().unwrap_or(0.0))
    }
}
