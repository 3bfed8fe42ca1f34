//! Acoustics.

use super::super::system::{FirstOrderSystem, mirrored};
use super::Units;
use crate::cloud::Place;
use crate::pairs::Nothing;
use crate::scalar::{Number, Scalar};

/// `∂p/∂t + ρ c² div v = 0`, `∂v/∂t + ∇p/ρ = 0`: `u = (p, v)`, `P = D + 1`.
///
/// Symmetriser `diag(1/(ρc²), ρ, ..)`: twice the acoustic energy. At a wall `v` is odd along the
/// normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acoustics<S> {
    /// `ρ c²`.
    stiffness: S,
    /// `1/ρ`.
    lightness: S,
    /// `1/(ρ c²)`.
    compliance: S,
    /// `ρ`.
    density: S,
    /// `c`.
    sound_speed: S,
}

impl<S: Scalar> Acoustics<S> {
    /// Of a fluid with that density and sound speed, both > 0.
    pub fn new(density: f64, sound_speed: f64, units: Units) -> Self {
        let stiffness = units.flux(density * sound_speed * sound_speed);
        let lightness = units.flux(1.0 / density);
        Self {
            stiffness: S::from_f64(stiffness),
            lightness: S::from_f64(lightness),
            compliance: S::from_f64(1.0 / stiffness),
            density: S::from_f64(1.0 / lightness),
            sound_speed: S::from_f64(units.flux(sound_speed)),
        }
    }
}

impl<S: Scalar, const D: usize, const P: usize> FirstOrderSystem<S, D, P> for Acoustics<S> {
    type Medium = Nothing;
    const IS_UNIFORM: bool = true;

    fn medium(&self, _: &Place<S, D>) -> Nothing {
        const { assert!(P == D + 1) };
        Nothing
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(&self, _: &Nothing, n: &[N; D], u: &[N; P]) -> [N; P] {
        let mut flux = [N::zero(); P];
        let mut across = [N::zero(); D];
        let push = N::splat(self.lightness) * u[0];
        for i in 0..D {
            across[i] = u[1 + i];
            flux[1 + i] = n[i] * push;
        }
        flux[0] = N::splat(self.stiffness) * N::dot(n, &across);
        flux
    }
    fn speed(&self, _: &Nothing) -> S {
        self.sound_speed
    }
    fn symmetrised(&self, _: &Nothing, u: &[S; P]) -> [S; P] {
        let mut result = u.map(|v| self.density * v);
        result[0] = self.compliance * u[0];
        result
    }
    fn reflected(&self, u: &[S; P], axis: usize) -> [S; P] {
        mirrored(u, 1, axis)
    }
}
