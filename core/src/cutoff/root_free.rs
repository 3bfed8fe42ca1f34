//! The cut-off that needs no square root.

use core::f64::consts::PI;

use super::{CutOff, positive};
use crate::scalar::{Number, Scalar};

/// `z(q) = (1-q²)₊^M`, support ε, `M-1` times continuously differentiable; `M >= 2`.
///
/// A polynomial in `q²`: the argument of its functions is `q²`. `σ_D` follows from the
/// integrals of `(1-q²)^M`, `I_M = I_(M-1) 2M/(2M+D)`, `I_0` the volume of the unit ball.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RootFree<const M: usize>;

/// `tⁿ`.
#[inline(always)]
pub(super) fn power<N: Number>(t: N, n: usize) -> N {
    let mut result = N::literal(1.0);
    for _ in 0..n {
        result = result * t;
    }
    result
}

/// `∫ (1-q²)ᵐ`, with a volume of the ball in `dimension` dimensions: a constant where it is used.
pub(super) const fn integral(ball: f64, m: usize, dimension: usize) -> f64 {
    let mut integral = ball;
    let mut i = 1;
    while i <= m {
        integral *= 2.0 * i as f64 / (2 * i + dimension) as f64;
        i += 1;
    }
    integral
}

impl<const M: usize> CutOff for RootFree<M> {
    #[inline(always)]
    fn support(self) -> u32 {
        1
    }

    fn smoothness<const D: usize>(self) -> u32 {
        M as u32
    }

    #[inline(always)]
    fn normalisation<const D: usize>(self) -> f64 {
        const {
            let ball = match D {
                1 => 2.0,
                2 => PI,
                _ => 4.0 * PI / 3.0,
            };
            1.0 / integral(ball, M, D)
        }
    }

    #[inline(always)]
    fn value<const D: usize, N: Number>(self, q_squared: N) -> N {
        power(positive(N::literal(1.0) - q_squared), M)
    }

    #[inline(always)]
    fn gradient<const D: usize, N: Number>(self, q_squared: N) -> N {
        let t = positive(N::literal(1.0) - q_squared);
        N::literal(-2.0 * M as f64) * power(t, M - 1)
    }

    #[inline(always)]
    fn curvature<const D: usize, N: Number>(self, q_squared: N) -> N {
        let t = positive(N::literal(1.0) - q_squared);
        let bracket = N::literal(2.0 * (M - 1) as f64) * q_squared - t;
        N::literal(2.0 * M as f64) * (power(t, M - 2) * bracket)
    }

    #[inline(always)]
    fn argument<N: Number>(self, distance_squared: N) -> N {
        distance_squared
    }
    #[inline(always)]
    fn scale<S: Scalar>(self, inverse_epsilon: S) -> S {
        inverse_epsilon * inverse_epsilon
    }
}
