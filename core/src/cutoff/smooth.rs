//! Smooth cut-offs of order 2, 4 and 6 that need no square root.

use core::f64::consts::PI;

use super::root_free::{integral, power};
use super::{CutOff, positive};
use crate::scalar::{Number, Scalar};

/// `z(q) = p(q²) tᴹ` with `t = (1-q²/9)₊` and a polynomial `p` of degree `(R-2)/2`, support 3ε: of
/// order `R`, one of 2, 4 and 6, and in W^(M,1); `M >= 4`.
///
/// With `N = M + (R-2)/2` and `T = q d/dq`:
///
/// - order 2: `z = tᴺ`
/// - order 4: `z = (T+D+2)/2 tᴺ`
/// - order 6: `z = (T+D+2)(T+D+4)/8 tᴺ`
///
/// since `T` multiplies the moments of degree `2j` by `-(D+2j)` (integrate by parts): the second
/// moments vanish, then the fourth ones too, and the integral stays as it is. With
/// `T tⁿ = 2n (tⁿ - tⁿ⁻¹)` all three are `c₀ tᴺ + c₁ tᴺ⁻¹ + c₂ tᴺ⁻²`. From order 4 on `z` is negative
/// somewhere: fit for the linear systems, not for the density of a gas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Smooth<const M: usize, const R: usize>;

impl<const M: usize, const R: usize> Smooth<M, R> {
    /// `N`, the highest power.
    const HIGHEST: usize = M + R / 2 - 1;

    /// `c₀, c₁, c₂`.
    fn coefficients<const D: usize>() -> [f64; 3] {
        let (n, d) = (Self::HIGHEST as f64, D as f64);
        match R {
            2 => [1.0, 0.0, 0.0],
            4 => [n + 0.5 * d + 1.0, -n, 0.0],
            _ => [
                (2.0 * n + d + 4.0) * (2.0 * n + d + 2.0) / 8.0,
                -0.5 * n * (2.0 * n + d + 2.0),
                0.5 * n * (n - 1.0),
            ],
        }
    }

    /// `Σ_j c_j Π_(i<derivative) (N-j-i) tᴺ⁻ʲ⁻ⁱ`: the derivative of that order in `t`.
    #[inline(always)]
    fn derivative<const D: usize, N: Number>(t: N, derivative: usize) -> N {
        let c = Self::coefficients::<D>();
        let terms = R / 2;
        let factor =
            |j: usize| (0..derivative).fold(c[j], |f, i| f * (Self::HIGHEST - j - i) as f64);
        // Horner in t over the lowest power that is there.
        let mut sum = N::literal(factor(0));
        for j in 1..terms {
            sum = sum * t + N::literal(factor(j));
        }
        sum * power(t, M - derivative)
    }
}

impl<const M: usize, const R: usize> CutOff for Smooth<M, R> {
    #[inline(always)]
    fn support(self) -> u32 {
        3
    }

    fn order(self) -> u32 {
        R as u32
    }

    fn smoothness<const D: usize>(self) -> u32 {
        M as u32
    }

    #[inline(always)]
    fn normalisation<const D: usize>(self) -> f64 {
        const {
            // 3^D times that of the root-free cut-off.
            let ball = match D {
                1 => 6.0,
                2 => 9.0 * PI,
                _ => 36.0 * PI,
            };
            1.0 / integral(ball, Self::HIGHEST, D)
        }
    }

    #[inline(always)]
    fn value<const D: usize, N: Number>(self, q_squared: N) -> N {
        Self::derivative::<D, N>(within(q_squared), 0)
    }

    /// `dt/dq = -2q/9`, so `z'/q = -2/9 dz/dt`.
    #[inline(always)]
    fn gradient<const D: usize, N: Number>(self, q_squared: N) -> N {
        N::literal(-2.0 / 9.0) * Self::derivative::<D, N>(within(q_squared), 1)
    }

    /// `z'' = F + q F'`, `q F' = -2 (1-t) dF/dt`.
    #[inline(always)]
    fn curvature<const D: usize, N: Number>(self, q_squared: N) -> N {
        let t = within(q_squared);
        let rest = N::literal(4.0 / 9.0) * (N::literal(1.0) - t);
        self.gradient::<D, N>(q_squared) + rest * Self::derivative::<D, N>(t, 2)
    }

    #[inline(always)]
    fn argument<N: Number>(self, distance_squared: N) -> N {
        distance_squared
    }
    #[inline(always)]
    fn scale<S: Scalar>(self, inverse_epsilon: S) -> S {
        inverse_epsilon * inverse_epsilon
    }
    #[inline(always)]
    fn edge<S: Scalar>(self) -> S {
        S::count(9)
    }
}

/// `(1-q²/9)₊`.
#[inline(always)]
fn within<N: Number>(q_squared: N) -> N {
    positive(N::literal(1.0) - N::literal(1.0 / 9.0) * q_squared)
}
