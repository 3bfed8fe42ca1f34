//! Wendland's cut-offs (Wendland 1995; Dehnen & Aly 2012, table 1), support 2ε.
//!
//! With `u = q/2` and `t = (1-u)₊`. The polynomials of one dimension differ from those of
//! two and three. Their Fourier transforms are positive: particles do not pair.

use core::f64::consts::PI;

use super::{CutOff, positive, square};
use crate::scalar::Number;

/// `u` and `t = (1-u)₊`.
#[inline(always)]
fn halves<N: Number>(q: N) -> (N, N) {
    let u = N::literal(0.5) * q;
    (u, positive(N::literal(1.0) - u))
}

/// `c₀ + c₁ u + c₂ u² + c₃ u³`.
#[inline(always)]
fn polynomial<N: Number>(u: N, [c0, c1, c2, c3]: [f64; 4]) -> N {
    let mut sum = N::literal(c0) + N::literal(c1) * u;
    if c2 != 0.0 || c3 != 0.0 {
        sum += N::literal(c2) * square(u);
    }
    if c3 != 0.0 {
        sum += N::literal(c3) * (square(u) * u);
    }
    sum
}

/// `z = t³(1+3u)` in 1D, `t⁴(1+4u)` in 2D and 3D.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WendlandC2;

impl CutOff for WendlandC2 {
    #[inline(always)]
    fn support(self) -> u32 {
        2
    }

    fn smoothness<const D: usize>(self) -> u32 {
        if D == 1 { 3 } else { 4 }
    }

    fn normalisation<const D: usize>(self) -> f64 {
        match D {
            1 => 5.0 / 8.0,
            2 => 7.0 / (4.0 * PI),
            _ => 21.0 / (16.0 * PI),
        }
    }

    #[inline(always)]
    fn value<const D: usize, N: Number>(self, q: N) -> N {
        let (u, t) = halves(q);
        if D == 1 {
            square(t) * t * polynomial(u, [1.0, 3.0, 0.0, 0.0])
        } else {
            square(square(t)) * polynomial(u, [1.0, 4.0, 0.0, 0.0])
        }
    }

    #[inline(always)]
    fn gradient<const D: usize, N: Number>(self, q: N) -> N {
        let (_, t) = halves(q);
        if D == 1 {
            N::literal(-3.0) * square(t)
        } else {
            N::literal(-5.0) * (square(t) * t)
        }
    }

    #[inline(always)]
    fn curvature<const D: usize, N: Number>(self, q: N) -> N {
        let (u, t) = halves(q);
        if D == 1 {
            t * polynomial(u, [-3.0, 9.0, 0.0, 0.0])
        } else {
            square(t) * polynomial(u, [-5.0, 20.0, 0.0, 0.0])
        }
    }
}

/// `z = t⁵(1+5u+8u²)` in 1D, `t⁶(1+6u+35/3 u²)` in 2D and 3D.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WendlandC4;

impl CutOff for WendlandC4 {
    #[inline(always)]
    fn support(self) -> u32 {
        2
    }

    fn smoothness<const D: usize>(self) -> u32 {
        if D == 1 { 5 } else { 6 }
    }

    fn normalisation<const D: usize>(self) -> f64 {
        match D {
            1 => 3.0 / 4.0,
            2 => 9.0 / (4.0 * PI),
            _ => 495.0 / (256.0 * PI),
        }
    }

    #[inline(always)]
    fn value<const D: usize, N: Number>(self, q: N) -> N {
        let (u, t) = halves(q);
        let t4 = square(square(t));
        if D == 1 {
            t4 * t * polynomial(u, [1.0, 5.0, 8.0, 0.0])
        } else {
            t4 * square(t) * polynomial(u, [1.0, 6.0, 35.0 / 3.0, 0.0])
        }
    }

    #[inline(always)]
    fn gradient<const D: usize, N: Number>(self, q: N) -> N {
        let (u, t) = halves(q);
        let t4 = square(square(t));
        if D == 1 {
            t4 * polynomial(u, [-3.5, -14.0, 0.0, 0.0])
        } else {
            t4 * t * polynomial(u, [-14.0 / 3.0, -70.0 / 3.0, 0.0, 0.0])
        }
    }

    #[inline(always)]
    fn curvature<const D: usize, N: Number>(self, q: N) -> N {
        let (u, t) = halves(q);
        if D == 1 {
            square(t) * t * polynomial(u, [-3.5, -10.5, 84.0, 0.0])
        } else {
            square(square(t)) * polynomial(u, [-14.0 / 3.0, -56.0 / 3.0, 490.0 / 3.0, 0.0])
        }
    }
}

/// `z = t⁷(1+7u+19u²+21u³)` in 1D, `t⁸(1+8u+25u²+32u³)` in 2D and 3D.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WendlandC6;

impl CutOff for WendlandC6 {
    #[inline(always)]
    fn support(self) -> u32 {
        2
    }

    fn smoothness<const D: usize>(self) -> u32 {
        if D == 1 { 7 } else { 8 }
    }

    fn normalisation<const D: usize>(self) -> f64 {
        match D {
            1 => 55.0 / 64.0,
            2 => 39.0 / (14.0 * PI),
            _ => 1365.0 / (512.0 * PI),
        }
    }

    #[inline(always)]
    fn value<const D: usize, N: Number>(self, q: N) -> N {
        let (u, t) = halves(q);
        let t4 = square(square(t));
        if D == 1 {
            t4 * (square(t) * t) * polynomial(u, [1.0, 7.0, 19.0, 21.0])
        } else {
            square(t4) * polynomial(u, [1.0, 8.0, 25.0, 32.0])
        }
    }

    #[inline(always)]
    fn gradient<const D: usize, N: Number>(self, q: N) -> N {
        let (u, t) = halves(q);
        let t4 = square(square(t));
        if D == 1 {
            t4 * square(t) * polynomial(u, [-4.5, -27.0, -52.5, 0.0])
        } else {
            t4 * (square(t) * t) * polynomial(u, [-5.5, -38.5, -88.0, 0.0])
        }
    }

    #[inline(always)]
    fn curvature<const D: usize, N: Number>(self, q: N) -> N {
        let (u, t) = halves(q);
        let t4 = square(square(t));
        if D == 1 {
            t4 * t * polynomial(u, [-4.5, -22.5, 58.5, 472.5])
        } else {
            t4 * square(t) * polynomial(u, [-5.5, -33.0, 82.5, 880.0])
        }
    }
}
