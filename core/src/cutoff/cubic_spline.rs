//! The cubic B-spline M4.

use core::f64::consts::PI;

use super::{CutOff, positive, square};
use crate::scalar::Number;

/// M4 (Schoenberg; Monaghan & Lattanzio 1985), support 2ε, twice continuously differentiable:
///
/// `z(q) = 1/4 (2-q)₊³ - (1-q)₊³`, `σ = 2/3, 10/(7π), 1/π`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CubicSpline;

impl CutOff for CubicSpline {
    #[inline(always)]
    fn support(self) -> u32 {
        2
    }

    fn smoothness<const D: usize>(self) -> u32 {
        3
    }

    fn normalisation<const D: usize>(self) -> f64 {
        match D {
            1 => 2.0 / 3.0,
            2 => 10.0 / (7.0 * PI),
            _ => 1.0 / PI,
        }
    }

    #[inline(always)]
    fn value<const D: usize, N: Number>(self, q: N) -> N {
        let outer = positive(N::literal(2.0) - q);
        let inner = positive(N::literal(1.0) - q);
        N::literal(0.25) * (square(outer) * outer) - square(inner) * inner
    }

    /// `-3/4 (2-p)₊²/p - 9/4 (1-q)₊` with `p = max(q, 1)`: the two pieces of `z'/q`
    /// without cancellation and without a singularity at 0.
    #[inline(always)]
    fn gradient<const D: usize, N: Number>(self, q: N) -> N {
        let p = q.max(N::literal(1.0));
        let outer = positive(N::literal(2.0) - p);
        let inner = positive(N::literal(1.0) - q);
        N::literal(-0.75) * square(outer) / p - N::literal(2.25) * inner
    }

    #[inline(always)]
    fn curvature<const D: usize, N: Number>(self, q: N) -> N {
        let outer = positive(N::literal(2.0) - q);
        let inner = positive(N::literal(1.0) - q);
        N::literal(1.5) * outer - N::literal(6.0) * inner
    }
}
