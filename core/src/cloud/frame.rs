//! Solver units, seen from those of a problem: the way of numbers in and out.

use super::place::Place;
use crate::scalar::Scalar;

/// What is 1 for the solver, in the units that a system's numbers are given in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// The unit of length: the mean spacing.
    pub length: f64,
    /// The unit of velocity: the fastest wave.
    pub velocity: f64,
}

impl Units {
    /// Numbers are in solver units already.
    pub const ONE: Self = Self {
        length: 1.0,
        velocity: 1.0,
    };

    /// The unit of time.
    pub fn time(&self) -> f64 {
        self.length / self.velocity
    }

    /// A factor of a space derivative in solver units.
    pub(crate) fn flux(&self, factor: f64) -> f64 {
        factor / self.velocity
    }

    /// A rate in solver units.
    pub(crate) fn rate(&self, rate: f64) -> f64 {
        rate * self.time()
    }
}

/// The way between a problem in units of its own, SI for one, and the solver: what its units are, and
/// which place is 0. Values `u` stay what they are.
///
/// ```
/// # use motes_core::cloud::{Frame, Place, Units};
/// // A wall of 0.24 m in 48 particles, 5 mm each; diffusivity 5e-7 m²/s is to be 1.
/// let units = Units { length: 0.005, velocity: 5e-7 / 0.005 };
/// let wall = Frame { middle: [0.12, 0.0, 0.0], units };
/// assert_eq!(wall.diffusivity::<f32>(5e-7), 1.0);
/// assert_eq!(wall.duration::<f32>(3600.0), 72.0);
/// assert_eq!(wall.place::<f32, 1>([0.24]), [24.0]);
/// let [x, _, _, t] = wall.point(&Place { position: [24.0f32], time: 72.0 });
/// assert!((x - 0.24).abs() < 1e-9 && (t - 3600.0).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The place that is 0 for the solver; 0 beyond the dimension.
    pub middle: [f64; 3],
    /// What the solver units are.
    pub units: Units,
}

impl Frame {
    /// Where and when in the problem's units, `[x, y, z, t]`; 0 beyond the dimension.
    pub fn point<S: Scalar, const D: usize>(&self, place: &Place<S, D>) -> [f64; 4] {
        let x = |i: usize| match (place.position.get(i), self.middle.get(i)) {
            (Some(x), Some(middle)) => middle + x.to_f64() * self.units.length,
            _ => 0.0,
        };
        [x(0), x(1), x(2), self.seconds(place.time)]
    }

    /// A time of the solver in the problem's unit.
    pub fn seconds<S: Scalar>(&self, time: S) -> f64 {
        time.to_f64() * self.units.time()
    }

    /// A place of the problem, for the solver.
    pub fn place<S: Scalar, const D: usize>(&self, x: [f64; D]) -> [S; D] {
        let mut place = [S::ZERO; D];
        for ((place, x), middle) in place.iter_mut().zip(x).zip(self.middle) {
            *place = self.number((x - middle) / self.units.length);
        }
        place
    }

    /// A length, in spacings.
    pub fn length<S: Scalar>(&self, length: f64) -> S {
        self.number(length / self.units.length)
    }

    /// A time.
    pub fn duration<S: Scalar>(&self, seconds: f64) -> S {
        self.number(seconds / self.units.time())
    }

    /// A velocity, or another factor of a derivative in space.
    pub fn velocity<S: Scalar>(&self, velocity: f64) -> S {
        self.number(self.units.flux(velocity))
    }

    /// What is divided by a time: a rate, a source, the slope of a velocity.
    pub fn rate<S: Scalar>(&self, rate: f64) -> S {
        self.number(self.units.rate(rate))
    }

    /// A diffusivity, length²/time.
    pub fn diffusivity<S: Scalar>(&self, diffusivity: f64) -> S {
        self.number(diffusivity / (self.units.length * self.units.velocity))
    }

    /// A number without a unit, rounded once. What is no number stays none in floats; a format that has
    /// none takes its largest number, which no proof lets pass.
    pub fn number<S: Scalar>(&self, value: f64) -> S {
        match value.is_nan() && S::WRAPS {
            true => S::LARGEST,
            false => S::from_f64(value),
        }
    }
}
