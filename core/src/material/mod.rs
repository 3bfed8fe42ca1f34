//! Materials: what pressure and sound speed a density and an internal energy give.
//!
//! Adding one: a file here with an implementation of [`EquationOfState`], and its row in
//! [`Named`].

mod ideal_gas;
mod isothermal;
mod named;
mod stiffened_gas;
mod tait;
#[cfg(test)]
mod tests;

pub use ideal_gas::IdealGas;
pub use isothermal::Isothermal;
pub use named::Named;
pub use stiffened_gas::StiffenedGas;
pub use tait::Tait;

use crate::scalar::Scalar;

/// An equation of state (3.2): `p = p(ρ, e)`, and its sound speed.
pub trait EquationOfState<S: Scalar>: Copy + Send + Sync {
    /// Pressure; `density` in mass per volume, `energy` internal energy per mass.
    fn pressure(&self, density: S, energy: S) -> S;
    /// Sound speed; 0 where its square would be negative.
    fn sound_speed(&self, density: S, energy: S) -> S;
    /// Whether the pressure depends on the internal energy. Where it does not, the energy is
    /// only kept account of, and may fall below 0.
    fn feels_energy(&self) -> bool {
        true
    }
}
