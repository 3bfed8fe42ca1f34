//! The telegraph line.

use super::super::system::{FirstOrderSystem, mirrored};
use super::Units;
use crate::cloud::Place;
use crate::pairs::Nothing;
use crate::scalar::{Number, Scalar};

/// `C ∂V/∂t + ∂I/∂x + G V = 0`, `L ∂I/∂t + ∂V/∂x + R I = 0`: `u = (V, I)`, losses in `A⁰`.
///
/// Not symmetric as written; symmetriser `diag(C, L)`. At a wall, an open end, `I` is odd.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Telegraph<S> {
    /// `C, L`.
    storage: [S; 2],
    /// `1/C, 1/L`.
    inverse: [S; 2],
    /// `G/C, R/L`.
    losses: [S; 2],
    /// `1/√(LC)`.
    speed: S,
}

impl<S: Scalar> Telegraph<S> {
    /// Of a line with that capacitance and inductance > 0 and losses (conductance, resistance)
    /// >= 0, all per length.
    pub fn new([capacitance, inductance]: [f64; 2], losses: [f64; 2], units: Units) -> Self {
        let inverse = [capacitance, inductance].map(|storage| units.flux(1.0 / storage));
        let product: f64 = inverse[0] * inverse[1];
        Self {
            storage: inverse.map(|inverse| S::from_f64(1.0 / inverse)),
            inverse: inverse.map(S::from_f64),
            losses: [losses[0] / capacitance, losses[1] / inductance]
                .map(|rate| S::from_f64(units.rate(rate))),
            speed: S::from_f64(Number::sqrt(product)),
        }
    }
}

impl<S: Scalar> FirstOrderSystem<S, 1, 2> for Telegraph<S> {
    type Medium = Nothing;
    const IS_UNIFORM: bool = true;

    fn medium(&self, _: &Place<S, 1>) -> Nothing {
        Nothing
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(&self, _: &Nothing, n: &[N; 1], u: &[N; 2]) -> [N; 2] {
        let [voltage, current] = *u;
        [
            N::splat(self.inverse[0]) * (n[0] * current),
            N::splat(self.inverse[1]) * (n[0] * voltage),
        ]
    }
    fn decay(&self, _: &Place<S, 1>, u: &[S; 2]) -> [S; 2] {
        [self.losses[0] * u[0], self.losses[1] * u[1]]
    }
    fn speed(&self, _: &Nothing) -> S {
        self.speed
    }
    fn damping(&self) -> S {
        self.losses[0].greater(self.losses[1])
    }
    fn symmetrised(&self, _: &Nothing, u: &[S; 2]) -> [S; 2] {
        [self.storage[0] * u[0], self.storage[1] * u[1]]
    }
    fn growth(&self) -> S {
        -self.losses[0].lesser(self.losses[1])
    }
    fn reflected(&self, u: &[S; 2], axis: usize) -> [S; 2] {
        mirrored(u, 1, axis)
    }
}
