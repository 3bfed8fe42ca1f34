//! The matter on one side of a Riemann problem, whatever its equation of state, and its wave.

use super::barotropic::Barotropic;
use super::state::{Front, GasState};
use super::wave::Gas;
use crate::scenario::EquationOfState;

/// Uniform matter with a wave running to the left into it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Side {
    /// Its pressure depends on the energy.
    Gas(Gas),
    /// The density alone gives it.
    Barotropic(Barotropic),
}

/// A wave and the matter that it runs into.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wave {
    side: Side,
    pub front: Front,
}

/// What is added to the pressure to have one that is 0 where the density is: `p_inf`, or `B`.
pub(super) fn stiffness(law: &EquationOfState) -> f64 {
    match *law {
        EquationOfState::IdealGas { .. } | EquationOfState::Isothermal { .. } => 0.0,
        EquationOfState::StiffenedGas {
            pressure_at_infinity,
            ..
        } => pressure_at_infinity,
        EquationOfState::Tait {
            density,
            sound_speed,
            exponent,
        } => density * sound_speed * sound_speed / f64::from(exponent),
    }
}

impl Side {
    pub fn new(state: GasState, law: &EquationOfState, floor: f64) -> Self {
        let stiffness = stiffness(law);
        match *law {
            EquationOfState::IdealGas { gamma } | EquationOfState::StiffenedGas { gamma, .. } => {
                Self::Gas(Gas::new(state, gamma, stiffness, floor))
            }
            EquationOfState::Isothermal { .. } => {
                Self::Barotropic(Barotropic::new(state, 1.0, stiffness, floor))
            }
            EquationOfState::Tait { exponent, .. } => Self::Barotropic(Barotropic::new(
                state,
                f64::from(exponent),
                stiffness,
                floor,
            )),
        }
    }

    /// Outside.
    pub fn state(&self) -> GasState {
        match self {
            Self::Gas(gas) => gas.state,
            Self::Barotropic(matter) => matter.state,
        }
    }

    /// Pressure outside, above the least that both sides bear.
    pub fn level(&self) -> f64 {
        match self {
            Self::Gas(gas) => gas.level,
            Self::Barotropic(matter) => matter.level,
        }
    }

    /// How much slower the matter is behind the wave at that level of pressure, and the derivative by
    /// it.
    pub fn f(&self, level: f64) -> (f64, f64) {
        match self {
            Self::Gas(gas) => gas.f(level),
            Self::Barotropic(matter) => matter.f(level),
        }
    }

    /// The speed beside a vacuum; not finite where none can open.
    pub fn vacuum_edge(&self) -> f64 {
        match self {
            Self::Gas(gas) => gas.vacuum_edge(),
            Self::Barotropic(matter) => matter.vacuum_edge(),
        }
    }

    /// The wave behind which level and velocity are as given.
    pub fn wave(self, level: f64, velocity: f64) -> Wave {
        let front = match self {
            Self::Gas(gas) => gas.front(level, velocity),
            Self::Barotropic(matter) => matter.front(level, velocity),
        };
        Wave { side: self, front }
    }
}

impl Wave {
    /// The state at `xi`, left of the contact.
    pub fn sample(&self, xi: f64) -> GasState {
        if xi <= self.front.head {
            return self.side.state();
        }
        if xi >= self.front.tail {
            return self.front.inside;
        }
        match &self.side {
            Side::Gas(gas) => gas.fan(xi),
            Side::Barotropic(matter) => matter.fan(xi),
        }
    }

    /// The internal energy per mass of the state at `xi`.
    pub fn internal_energy(&self, state: GasState, xi: f64) -> f64 {
        match &self.side {
            Side::Gas(gas) => {
                let p = state.pressure + gas.gamma * gas.pressure_at_infinity;
                p / ((gas.gamma - 1.0) * state.density)
            }
            Side::Barotropic(_) if xi <= self.front.head => 0.0,
            Side::Barotropic(matter) => {
                matter.internal_energy(state, self.front.head == self.front.tail)
            }
        }
    }
}
