//! The stiffened gas: a liquid or solid under strong pressure.

use super::{EquationOfState, growth};
use crate::scalar::Scalar;

/// `p = (γ-1) ρ e - γ p∞`, `c² = γ (p + p∞)/ρ`; γ > 1, p∞ >= 0 (Harlow & Amsden, LA-4700,
/// 1971). With p∞ = 0 it is the ideal gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StiffenedGas<S> {
    gamma: S,
    gamma_minus_one: S,
    /// `p∞`.
    stiffness: S,
}

impl<S: Scalar> StiffenedGas<S> {
    /// A material with that γ > 1 and `p∞` >= 0, a pressure.
    pub fn new(gamma: f64, stiffness: f64) -> Self {
        Self {
            gamma: S::from_f64(gamma),
            gamma_minus_one: S::from_f64(gamma - 1.0),
            stiffness: S::from_f64(stiffness),
        }
    }
}

impl<S: Scalar> EquationOfState<S> for StiffenedGas<S> {
    #[inline]
    fn pressure(&self, density: S, energy: S) -> S {
        self.gamma_minus_one * density * energy - self.gamma * self.stiffness
    }

    #[inline]
    fn sound_speed(&self, density: S, energy: S) -> S {
        let stiff = self.pressure(density, energy) + self.stiffness;
        (self.gamma * (stiff.greater(S::ZERO) / density)).sqrt()
    }

    /// `p∞/ρ' + (e - p∞/ρ) (ρ'/ρ)^(γ-1)`.
    #[inline]
    fn compressed(&self, [before, after]: [S; 2], energy: S) -> S {
        let cold = self.stiffness / before;
        let growth = growth([before, after], self.gamma_minus_one);
        energy + (energy - cold) * growth + (self.stiffness / after - cold)
    }

    fn largest(&self, [least, density]: [f64; 2], energy: f64) -> f64 {
        let (gamma, stiffness) = (self.gamma.to_f64(), self.stiffness.to_f64());
        let (warm, stiff) = (self.gamma_minus_one.to_f64() * energy, gamma * stiffness);
        let dense = self.gamma_minus_one.to_f64() * density;
        let squared = gamma * (warm + stiff / least).min(S::LARGEST.to_f64());
        dense.max(density * warm + stiff + stiffness).max(squared)
    }
}
