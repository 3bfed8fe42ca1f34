//! The quintic B-spline M6.

use core::f64::consts::PI;

use super::{CutOff, positive, square};
use crate::scalar::Number;

/// 1/64.
const SCALE: f64 = 0.015625;

/// M6 (Schoenberg), support 3ε, four times continuously differentiable:
///
/// `z(q) = [(3-q)₊⁵ - 6 (2-q)₊⁵ + 15 (1-q)₊⁵]/64`, `σ = 64/120, 448/(478π), 64/(120π)`.
///
/// The 64 is a power of two, exact in every format; without it σ would be 1391 units of the
/// last place in Q12.19. In fixed point M6 needs at least 9 integer bits: 3⁵ = 243.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct QuinticSpline;

impl CutOff for QuinticSpline {
    #[inline(always)]
    fn support(self) -> u32 {
        3
    }

    fn smoothness<const D: usize>(self) -> u32 {
        5
    }

    fn normalisation<const D: usize>(self) -> f64 {
        match D {
            1 => 64.0 / 120.0,
            2 => 448.0 / (478.0 * PI),
            _ => 64.0 / (120.0 * PI),
        }
    }

    #[inline(always)]
    fn value<const D: usize, N: Number>(self, q: N) -> N {
        let (a, b, c) = terms(q);
        let fifth = |t: N| square(square(t)) * t;
        N::literal(SCALE) * (fifth(a) - N::literal(6.0) * fifth(b) + N::literal(15.0) * fifth(c))
    }

    /// `-5 [(3-p)₊⁴ - 6 (2-p)₊⁴]/p + c (50 c² - 30 c - 90)`, over 64, with `p = max(q, 1)`,
    /// `c = (1-q)₊`: the pieces of `z'/q` without a singularity at 0.
    #[inline(always)]
    fn gradient<const D: usize, N: Number>(self, q: N) -> N {
        let p = q.max(N::literal(1.0));
        let (a, b, _) = terms(p);
        let c = positive(N::literal(1.0) - q);
        let outer = square(square(a)) - N::literal(6.0) * square(square(b));
        let inner = (N::literal(50.0) * c - N::literal(30.0)) * c - N::literal(90.0);
        N::literal(SCALE) * (N::literal(-5.0) * outer / p + c * inner)
    }

    #[inline(always)]
    fn curvature<const D: usize, N: Number>(self, q: N) -> N {
        let (a, b, c) = terms(q);
        let cube = |t: N| square(t) * t;
        N::literal(20.0 * SCALE)
            * (cube(a) - N::literal(6.0) * cube(b) + N::literal(15.0) * cube(c))
    }
}

/// The third derivative of the shape.
#[inline(always)]
pub(super) fn third_derivative<N: Number>(q: N) -> N {
    let (a, b, c) = terms(q);
    N::literal(-60.0 * SCALE)
        * (square(a) - N::literal(6.0) * square(b) + N::literal(15.0) * square(c))
}

/// `(3-q)₊`, `(2-q)₊`, `(1-q)₊`.
#[inline(always)]
fn terms<N: Number>(q: N) -> (N, N, N) {
    let term = |edge: f64| positive(N::literal(edge) - q);
    (term(3.0), term(2.0), term(1.0))
}
