//! The ideal gas of constant specific heats.

use super::{EquationOfState, growth};
use crate::scalar::Scalar;

/// `p = (γ-1) ρ e`, `c² = γ (γ-1) e`, γ > 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IdealGas<S> {
    /// `γ - 1`.
    gamma_minus_one: S,
    /// `γ (γ - 1)`.
    sound: S,
}

impl<S: Scalar> IdealGas<S> {
    /// A gas with ratio of specific heats `gamma` > 1.
    pub fn new(gamma: f64) -> Self {
        Self {
            gamma_minus_one: S::from_f64(gamma - 1.0),
            sound: S::from_f64(gamma * (gamma - 1.0)),
        }
    }
}

impl<S: Scalar> EquationOfState<S> for IdealGas<S> {
    #[inline]
    fn pressure(&self, density: S, energy: S) -> S {
        self.gamma_minus_one * density * energy
    }

    #[inline]
    fn sound_speed(&self, _: S, energy: S) -> S {
        (self.sound * energy.greater(S::ZERO)).sqrt()
    }

    /// `e (ρ'/ρ)^(γ-1)`.
    #[inline]
    fn compressed(&self, densities: [S; 2], energy: S) -> S {
        energy + energy * growth(densities, self.gamma_minus_one)
    }

    fn largest(&self, [_, density]: [f64; 2], energy: f64) -> f64 {
        let dense = self.gamma_minus_one.to_f64() * density;
        let sound = self.sound.to_f64() * energy;
        dense.max(dense * energy).max(sound)
    }
}
