//! A gas held at one temperature.

use super::{EquationOfState, logarithm};
use crate::scalar::Scalar;

/// `p = c² ρ` with a constant sound speed c > 0; the internal energy plays no part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isothermal<S> {
    sound_speed: S,
    squared: S,
}

impl<S: Scalar> Isothermal<S> {
    /// A gas with that sound speed, length per time, > 0.
    pub fn new(sound_speed: f64) -> Self {
        Self {
            sound_speed: S::from_f64(sound_speed),
            squared: S::from_f64(sound_speed * sound_speed),
        }
    }
}

impl<S: Scalar> EquationOfState<S> for Isothermal<S> {
    #[inline]
    fn pressure(&self, density: S, _: S) -> S {
        self.squared * density
    }

    #[inline]
    fn sound_speed(&self, _: S, _: S) -> S {
        self.sound_speed
    }

    /// `e + c² ln(ρ'/ρ)`.
    #[inline]
    fn compressed(&self, densities: [S; 2], energy: S) -> S {
        energy + self.squared * logarithm(densities)
    }

    fn largest(&self, [_, density]: [f64; 2], _: f64) -> f64 {
        self.squared.to_f64() * density
    }

    fn feels_energy(&self) -> bool {
        false
    }
}
