//! Gas dynamics, linearised about a uniform flow.

use super::super::system::{FirstOrderSystem, mirrored};
use super::Units;
use crate::cloud::Place;
use crate::pairs::Nothing;
use crate::scalar::{Number, Scalar};

/// `Dρ/Dt + ρ₀ div v = 0`, `Dv/Dt + ∇p/ρ₀ = 0`, `Dp/Dt + ρ₀ c² div v = 0`, `D/Dt = ∂/∂t + U·∇`:
/// `u = (ρ, v, p)`, `P = D + 2`.
///
/// Not symmetric as written. With the entropy `s = ρ - p/c²`, which is only carried, twice the
/// energy is `ρ₀ v² + p²/(ρ₀c²) + c² s²/ρ₀`; its matrix is the symmetriser. At a wall `v` is odd
/// along the normal, along which `U` must be 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearisedGas<S, const D: usize> {
    /// `U`.
    velocity: [S; D],
    /// `ρ₀` as it stands in the first equation.
    density: S,
    /// `1/ρ₀` in the second.
    lightness: S,
    /// `ρ₀ c²` in the third.
    stiffness: S,
    /// `1/(ρ₀ c²)`, to the unit of velocity.
    compliance: S,
    /// `ρ₀`, likewise.
    inertia: S,
    /// `1/c²`.
    softness: S,
    /// `c²/ρ₀`, to the unit of velocity.
    entropy: S,
    /// `c`.
    sound_speed: S,
}

impl<S: Scalar, const D: usize> LinearisedGas<S, D> {
    /// About a flow of that density, sound speed (both > 0) and velocity.
    pub fn new(density: f64, sound_speed: f64, velocity: [f64; D], units: Units) -> Self {
        let squared = sound_speed * sound_speed;
        Self {
            velocity: velocity.map(|u| S::from_f64(units.flux(u))),
            density: S::from_f64(units.flux(density)),
            lightness: S::from_f64(units.flux(1.0 / density)),
            stiffness: S::from_f64(units.flux(density * squared)),
            compliance: S::from_f64(units.velocity / (density * squared)),
            inertia: S::from_f64(density * units.velocity),
            softness: S::from_f64(1.0 / squared),
            entropy: S::from_f64(units.velocity * squared / density),
            sound_speed: S::from_f64(units.flux(sound_speed)),
        }
    }
}

impl<S: Scalar, const D: usize, const P: usize> FirstOrderSystem<S, D, P> for LinearisedGas<S, D> {
    type Medium = Nothing;
    const IS_UNIFORM: bool = true;

    fn velocity(&self, _: &Place<S, D>) -> [S; D] {
        self.velocity
    }
    fn medium(&self, _: &Place<S, D>) -> Nothing {
        const { assert!(P == D + 2) };
        Nothing
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(&self, _: &Nothing, n: &[N; D], u: &[N; P]) -> [N; P] {
        let mut flux = [N::zero(); P];
        let mut across = [N::zero(); D];
        let push = N::splat(self.lightness) * u[P - 1];
        for i in 0..D {
            across[i] = u[1 + i];
            flux[1 + i] = n[i] * push;
        }
        let dilation = N::dot(n, &across);
        flux[0] = N::splat(self.density) * dilation;
        flux[P - 1] = N::splat(self.stiffness) * dilation;
        flux
    }
    fn speed(&self, _: &Nothing) -> S {
        self.sound_speed
    }
    fn symmetrised(&self, _: &Nothing, u: &[S; P]) -> [S; P] {
        let mut result = u.map(|v| self.inertia * v);
        let entropy = self.entropy * (u[0] - self.softness * u[P - 1]);
        result[0] = entropy;
        result[P - 1] = self.compliance * u[P - 1] - self.softness * entropy;
        result
    }
    fn reflected(&self, u: &[S; P], axis: usize) -> [S; P] {
        mirrored(u, 1, axis)
    }
}
