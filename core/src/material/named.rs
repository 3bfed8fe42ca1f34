//! A material chosen while the program runs.

use super::{EquationOfState, IdealGas, Isothermal, StiffenedGas, Tait};
use crate::scalar::Scalar;

/// Any of the materials; gives the bits of the one it names. Its laws are functions of their own: no pair
/// asks for them, and they are long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Named<S> {
    /// [`IdealGas`].
    IdealGas(IdealGas<S>),
    /// [`StiffenedGas`].
    StiffenedGas(StiffenedGas<S>),
    /// [`Isothermal`].
    Isothermal(Isothermal<S>),
    /// [`Tait`].
    Tait(Tait<S>),
}

impl<S: Scalar> EquationOfState<S> for Named<S> {
    #[inline(never)]
    fn pressure(&self, density: S, energy: S) -> S {
        match self {
            Self::IdealGas(law) => law.pressure(density, energy),
            Self::StiffenedGas(law) => law.pressure(density, energy),
            Self::Isothermal(law) => law.pressure(density, energy),
            Self::Tait(law) => law.pressure(density, energy),
        }
    }

    #[inline(never)]
    fn sound_speed(&self, density: S, energy: S) -> S {
        match self {
            Self::IdealGas(law) => law.sound_speed(density, energy),
            Self::StiffenedGas(law) => law.sound_speed(density, energy),
            Self::Isothermal(law) => law.sound_speed(density, energy),
            Self::Tait(law) => law.sound_speed(density, energy),
        }
    }

    #[inline(never)]
    fn compressed(&self, densities: [S; 2], energy: S) -> S {
        match self {
            Self::IdealGas(law) => law.compressed(densities, energy),
            Self::StiffenedGas(law) => law.compressed(densities, energy),
            Self::Isothermal(law) => law.compressed(densities, energy),
            Self::Tait(law) => law.compressed(densities, energy),
        }
    }

    #[inline(never)]
    fn largest(&self, densities: [f64; 2], energy: f64) -> f64 {
        match self {
            Self::IdealGas(law) => law.largest(densities, energy),
            Self::StiffenedGas(law) => law.largest(densities, energy),
            Self::Isothermal(law) => law.largest(densities, energy),
            Self::Tait(law) => law.largest(densities, energy),
        }
    }

    fn feels_energy(&self) -> bool {
        matches!(self, Self::IdealGas(_) | Self::StiffenedGas(_))
    }
}
