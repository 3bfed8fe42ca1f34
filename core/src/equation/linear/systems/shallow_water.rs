//! Linear shallow water on a turning plane.

use super::super::system::{FirstOrderSystem, mirrored};
use super::Units;
use crate::cloud::Place;
use crate::domain::Wall;
use crate::record;
use crate::scalar::{Number, Scalar};

record! {
    /// Where a particle is; only walls ask for it.
    pub struct Location<N> {
        /// `x`.
        pub position: [N; 2],
    }
}

/// `∂η/∂t + H div v = 0`, `∂v/∂t + g ∇η + f ẑ×v = 0`: `u = (η, v_x, v_y)`, Coriolis in `A⁰`.
///
/// Symmetriser `diag(g, H, H)`: twice the energy over the density. At a wall `v` is odd along the
/// normal, and the surface has the slope that holds Coriolis' force there, `g ∂_n η = -f (ẑ×v)_n`:
/// the image lies on that straight line, not at the same height. Of first order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShallowWater<S> {
    /// `g`.
    gravity: S,
    /// `f/g`.
    tilt: S,
    /// `H`.
    depth: S,
    /// `f`.
    coriolis: S,
    /// `√(gH)`.
    speed: S,
}

impl<S: Scalar> ShallowWater<S> {
    /// Of water with gravity and depth > 0; `coriolis`: `f`, twice the rate of turning.
    pub fn new(gravity: f64, depth: f64, coriolis: f64, units: Units) -> Self {
        let (gravity, depth) = (units.flux(gravity), units.flux(depth));
        Self {
            gravity: S::from_f64(gravity),
            tilt: S::from_f64(units.rate(coriolis) / gravity),
            depth: S::from_f64(depth),
            coriolis: S::from_f64(units.rate(coriolis)),
            speed: S::from_f64(Number::sqrt(gravity * depth)),
        }
    }
}

impl<S: Scalar> FirstOrderSystem<S, 2, 3> for ShallowWater<S> {
    type Medium = Location<S>;
    const IS_UNIFORM: bool = true;

    fn medium(&self, place: &Place<S, 2>) -> Location<S> {
        Location {
            position: place.position,
        }
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(&self, _: &Location<N>, n: &[N; 2], u: &[N; 3]) -> [N; 3] {
        let [elevation, x, y] = *u;
        let push = N::splat(self.gravity) * elevation;
        [
            N::splat(self.depth) * N::dot(n, &[x, y]),
            n[0] * push,
            n[1] * push,
        ]
    }
    fn decay(&self, _: &Place<S, 2>, u: &[S; 3]) -> [S; 3] {
        [S::ZERO, -(self.coriolis * u[2]), self.coriolis * u[1]]
    }
    fn speed(&self, _: &Location<S>) -> S {
        self.speed
    }
    fn damping(&self) -> S {
        self.coriolis.abs()
    }
    fn symmetrised(&self, _: &Location<S>, u: &[S; 3]) -> [S; 3] {
        [self.gravity * u[0], self.depth * u[1], self.depth * u[2]]
    }
    fn reflected(&self, u: &[S; 3], axis: usize) -> [S; 3] {
        mirrored(u, 1, axis)
    }
    fn behind(&self, medium: &Location<S>, image: &[S; 3], wall: &Wall<S>) -> [S; 3] {
        let [elevation, x, y] = *image;
        // g ∂η/∂x = f v_y where v_x = 0, g ∂η/∂y = -f v_x where v_y = 0.
        let [at_x, at_y] = medium.position;
        let (place, slope) = match wall.axis {
            0 => (at_x, self.tilt * y),
            _ => (at_y, -(self.tilt * x)),
        };
        let half = slope * (wall.position - place);
        [elevation + (half + half), x, y]
    }
}
