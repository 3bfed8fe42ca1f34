//! Waves in an isotropic elastic solid, plane strain.

use super::super::system::FirstOrderSystem;
use super::Units;
use crate::cloud::Place;
use crate::pairs::Nothing;
use crate::scalar::{Number, Scalar};

/// `ρ ∂v/∂t = div s`, `∂s/∂t = λ (div v) I + μ (∇v + ∇vᵀ)`:
/// `u = (v_x, v_y, s_xx, s_yy, s_xy)`.
///
/// Not symmetric as written; the symmetriser is `ρ` for `v` and the compliance for `s`: twice the
/// elastic energy. At a wall the normal velocity and the shear stress are odd: it slips.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticWaves<S> {
    /// `1/ρ`.
    lightness: S,
    /// `λ+2μ, λ, μ`.
    stiffness: [S; 3],
    /// `ρ`.
    density: S,
    /// Inverse of the stiffness: direct, across, shear.
    compliance: [S; 3],
    /// `√((λ+2μ)/ρ)`.
    speed: S,
}

impl<S: Scalar> ElasticWaves<S> {
    /// Of a solid with density > 0 and Lamé's `λ`, `μ`: `μ > 0`, `λ + μ > 0`.
    pub fn new(density: f64, [lambda, mu]: [f64; 2], units: Units) -> Self {
        let lightness = units.flux(1.0 / density);
        let (lambda, mu) = (units.flux(lambda), units.flux(mu));
        let direct = lambda + 2.0 * mu;
        let determinant = direct * direct - lambda * lambda;
        let compliance = [direct / determinant, -lambda / determinant, 1.0 / mu];
        Self {
            lightness: S::from_f64(lightness),
            stiffness: [direct, lambda, mu].map(S::from_f64),
            density: S::from_f64(1.0 / lightness),
            compliance: compliance.map(S::from_f64),
            speed: S::from_f64(Number::sqrt(direct * lightness)),
        }
    }
}

impl<S: Scalar> FirstOrderSystem<S, 2, 5> for ElasticWaves<S> {
    type Medium = Nothing;
    const IS_UNIFORM: bool = true;

    fn medium(&self, _: &Place<S, 2>) -> Nothing {
        Nothing
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(&self, _: &Nothing, n: &[N; 2], u: &[N; 5]) -> [N; 5] {
        let [v_x, v_y, s_xx, s_yy, s_xy] = *u;
        let [direct, across, shear] = self.stiffness.map(N::splat);
        let lightness = N::splat(self.lightness);
        let (stretch_x, stretch_y) = (n[0] * v_x, n[1] * v_y);
        [
            -(lightness * N::dot(n, &[s_xx, s_xy])),
            -(lightness * N::dot(n, &[s_xy, s_yy])),
            -(direct * stretch_x + across * stretch_y),
            -(across * stretch_x + direct * stretch_y),
            -(shear * (n[0] * v_y + n[1] * v_x)),
        ]
    }
    fn speed(&self, _: &Nothing) -> S {
        self.speed
    }
    fn symmetrised(&self, _: &Nothing, u: &[S; 5]) -> [S; 5] {
        let [v_x, v_y, s_xx, s_yy, s_xy] = *u;
        let [direct, across, shear] = self.compliance;
        [
            self.density * v_x,
            self.density * v_y,
            direct * s_xx + across * s_yy,
            across * s_xx + direct * s_yy,
            shear * s_xy,
        ]
    }
    fn reflected(&self, u: &[S; 5], axis: usize) -> [S; 5] {
        let [v_x, v_y, s_xx, s_yy, s_xy] = *u;
        match axis {
            0 => [-v_x, v_y, s_xx, s_yy, -s_xy],
            _ => [v_x, -v_y, s_xx, s_yy, -s_xy],
        }
    }
}
