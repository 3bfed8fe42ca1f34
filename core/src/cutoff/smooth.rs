//! Smooth cut-offs of order 2, 4 and 6 that need no square root.

use core::f64::consts::PI;

use super::root_free::power;
use super::{CutOff, positive};
use crate::scalar::{Number, Scalar};

/// `z(q) = p(T) tᴹ` with `t = (1-q²/9)₊`, `T = q d/dq`, support 3ε: of order `R`, one of 2, 4
/// and 6; `M >= 5`.
///
/// `T` multiplies the moments of degree `2j` by `-(D+2j)` (integrate by parts), so that
///
/// - order 2: `p = 1`
/// - order 4: `p = (T+D+2)/2` takes away the second moments,
/// - order 6: `p = (T+D+2)(T+D+4)/8` the fourth ones too,
///
/// and leaves the integral as it is. With `T tⁿ = 2n (tⁿ - tⁿ⁻¹)` all three are
/// `c₀ tᴹ + c₁ tᴹ⁻¹ + c₂ tᴹ⁻²`. The lowest power that is there makes the smoothness: `z` lies in
/// W^(M-(R-2)/2, 1). From order 4 on `z` is negative somewhere: fit for the linear systems,
/// not for the density of a gas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Smooth<const M: usize, const R: usize>;

impl<const M: usize, const R: usize> Smooth<M, R> {
    /// `c₀, c₁, c₂`.
    fn coefficients<const D: usize>() -> [f64; 3] {
        let (m, d) = (M as f64, D as f64);
        match R {
            2 => [1.0, 0.0, 0.0],
            4 => [m + 0.5 * d + 1.0, -m, 0.0],
            _ => [
                (2.0 * m + d + 4.0) * (2.0 * m + d + 2.0) / 8.0,
                -0.5 * m * (2.0 * m + d + 2.0),
                0.5 * m * (m - 1.0),
            ],
        }
    }

    /// `Σ_j c_j Π_(i<derivative) (M-j-i) tᴹ⁻ʲ⁻ⁱ`: the derivative of that order in `t`.
    #[inline(always)]
    fn derivative<const D: usize, N: Number>(t: N, derivative: usize) -> N {
        let c = Self::coefficients::<D>();
        let terms = R / 2;
        let factor = |j: usize| (0..derivative).fold(c[j], |f, i| f * (M - j - i) as f64);
        // Horner in t over the lowest power that is there.
        let mut sum = N::literal(factor(0));
        for j in 1..terms {
            sum = sum * t + N::literal(factor(j));
        }
        sum * power(t, M + 1 - terms - derivative)
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
        (M + 1 - R / 2) as u32
    }

    fn normalisation<const D: usize>(self) -> f64 {
        // 3^D times the integral of (1-q²)^M, as for the root-free cut-off.
        let mut integral = match D {
            1 => 6.0,
            2 => 9.0 * PI,
            _ => 36.0 * PI,
        };
        for m in 1..=M {
            integral *= 2.0 * m as f64 / (2 * m + D) as f64;
        }
        1.0 / integral
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
