//! Maxwell's equations in the plane, transverse electric.

use super::super::system::FirstOrderSystem;
use super::Units;
use crate::cloud::Place;
use crate::pairs::Nothing;
use crate::scalar::{Number, Scalar};

/// `ϵ ∂E/∂t = (∂_y H, -∂_x H)`, `μ ∂H/∂t = ∂_y E_x - ∂_x E_y`: `u = (E_x, E_y, H)`.
///
/// Symmetriser `diag(ϵ, ϵ, μ)`: twice the field energy. A wall is a perfect conductor: along it
/// `E` is odd.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxwellTe<S> {
    /// `ϵ, μ`.
    storage: [S; 2],
    /// `1/ϵ, 1/μ`.
    inverse: [S; 2],
    /// `1/√(ϵμ)`.
    speed: S,
}

impl<S: Scalar> MaxwellTe<S> {
    /// Of a medium with that permittivity and permeability, both > 0.
    pub fn new(permittivity: f64, permeability: f64, units: Units) -> Self {
        let inverse = [permittivity, permeability].map(|storage| units.flux(1.0 / storage));
        let product: f64 = inverse[0] * inverse[1];
        Self {
            storage: inverse.map(|inverse| S::from_f64(1.0 / inverse)),
            inverse: inverse.map(S::from_f64),
            speed: S::from_f64(Number::sqrt(product)),
        }
    }
}

impl<S: Scalar> FirstOrderSystem<S, 2, 3> for MaxwellTe<S> {
    type Medium = Nothing;
    const IS_UNIFORM: bool = true;

    fn medium(&self, _: &Place<S, 2>) -> Nothing {
        Nothing
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(&self, _: &Nothing, n: &[N; 2], u: &[N; 3]) -> [N; 3] {
        let [x, y, magnetic] = *u;
        let magnetic = N::splat(self.inverse[0]) * magnetic;
        [
            -(n[1] * magnetic),
            n[0] * magnetic,
            N::splat(self.inverse[1]) * (n[0] * y - n[1] * x),
        ]
    }
    fn speed(&self, _: &Nothing) -> S {
        self.speed
    }
    fn symmetrised(&self, _: &Nothing, u: &[S; 3]) -> [S; 3] {
        let [permittivity, permeability] = self.storage;
        [
            permittivity * u[0],
            permittivity * u[1],
            permeability * u[2],
        ]
    }
    fn reflected(&self, u: &[S; 3], axis: usize) -> [S; 3] {
        match axis {
            0 => [u[0], -u[1], u[2]],
            _ => [-u[0], u[1], u[2]],
        }
    }
}
