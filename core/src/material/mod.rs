//! Materials: what pressure and sound speed a density and an internal energy give.

mod ideal_gas;

pub use ideal_gas::IdealGas;

use crate::scalar::Scalar;

/// An equation of state (3.2): `p = p(ρ, e)`, and its sound speed.
pub trait EquationOfState<S: Scalar>: Copy + Send + Sync {
    /// Pressure; `density` in mass per volume, `energy` internal energy per mass.
    fn pressure(&self, density: S, energy: S) -> S;
    /// Sound speed; 0 where its square would be negative.
    fn sound_speed(&self, density: S, energy: S) -> S;
}
