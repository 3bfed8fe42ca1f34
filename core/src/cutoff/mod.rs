//! Cut-off functions `ζ` of order r = 2, 4 and 6: even (1.22), compactly supported, of unit
//! integral, with vanishing moments of degree 1 to r-1 (2.5).
//!
//! | | support | order r | smoothness in 1D, and in 2D and 3D |
//! |---|---|---|---|
//! | [`CubicSpline`], [`QuinticSpline`] | 2ε, 3ε | 2 | 3, 5 |
//! | [`WendlandC2`], [`WendlandC4`], [`WendlandC6`] | 2ε | 2 | 3, 5, 7 and 4, 6, 8 |
//! | [`RootFree`]`<M>` | ε | 2 | M |
//! | [`QuinticSplineFour`] | 3ε | 4 | 4 |
//! | [`Smooth`]`<M, R>` | 3ε | R | M |
//!
//! Each is `ζ(x) = σ_D z(q)`, `q = |x|`, and is scaled as `ζ_ε(x) = ε^-D ζ(x/ε)` (1.12).
//! The pair loops use the shape `z` and its derivatives; `σ_D` and the powers of `1/ε` are
//! applied once per particle. The gradient is
//!
//! `∇ζ_ε(x) = σ_D ε^-(D+2) F(q) x`, `q = |x|/ε`, `F = z'/q`,
//!
//! and `F` has no singularity at 0. Shapes are written as their own support, in powers of
//! `max(1 - q/s, 0)`, so that a point out of reach contributes exactly 0 without a branch.
//!
//! Adding a cut-off: a file here with an implementation of [`CutOff`], its row in
//! [`Named`], and the tests of this folder run over it.

mod cubic_spline;
mod named;
mod peaks;
mod quintic_spline;
mod quintic_spline_four;
mod root_free;
mod shape;
mod smooth;
#[cfg(test)]
mod tests;
mod wendland;

pub use cubic_spline::CubicSpline;
pub use named::Named;
pub use peaks::Peaks;
pub use quintic_spline::QuinticSpline;
pub use quintic_spline_four::QuinticSplineFour;
pub use root_free::RootFree;
pub use shape::{BLOCK, Needs, PairBlock, Parts, Shape, Shapes, Widths};
pub use smooth::Smooth;
pub use wendland::{WendlandC2, WendlandC4, WendlandC6};

use crate::scalar::{Number, Scalar};

/// A cut-off function. `D` is the dimension of space: 1, 2 or 3.
///
/// The functions of `q` take the *argument* `a`: `q` itself, or `q²` for a cut-off that
/// needs no root. `argument` makes it from `|r|²`, `scale` from `1/ε`, so that
/// `a = argument(|r|²) * scale(1/ε)`.
pub trait CutOff: Copy + Send + Sync + 'static {
    /// Radius of the support in units of ε.
    fn support(self) -> u32;
    /// The order `r`: moments of degree 1 to `r-1` vanish (2.5), that of degree `r` does not.
    fn order(self) -> u32 {
        2
    }
    /// The largest `j` with ζ in W^(j,1)(R^D): the `m + s` of Theorem 1.
    fn smoothness<const D: usize>(self) -> u32;
    /// `σ_D`: makes the integral over R^D one.
    fn normalisation<const D: usize>(self) -> f64;
    /// `z(q)`.
    fn value<const D: usize, N: Number>(self, a: N) -> N;
    /// `F(q) = z'(q)/q`; at most 0 for order 2.
    fn gradient<const D: usize, N: Number>(self, a: N) -> N;
    /// `z''(q)`.
    fn curvature<const D: usize, N: Number>(self, a: N) -> N;

    /// The part of the argument that a pair determines: `|r|`.
    #[inline(always)]
    fn argument<N: Number>(self, distance_squared: N) -> N {
        distance_squared.sqrt()
    }
    /// The part of the argument that a particle determines: `1/ε`.
    #[inline(always)]
    fn scale<S: Scalar>(self, inverse_epsilon: S) -> S {
        inverse_epsilon
    }
    /// The argument at the edge of the support.
    #[inline(always)]
    fn edge<S: Scalar>(self) -> S {
        S::count(self.support())
    }

    /// The shapes of one pair; `scales` are those of `k` and `l`, see [`CutOff::scale`].
    ///
    /// A cut-off that is chosen at run time may be chosen here, once for the pair.
    #[inline(always)]
    fn shapes_of_pair<const D: usize, N: Number>(
        self,
        needs: Needs,
        distance_squared: N,
        scales: [N; 2],
    ) -> Shapes<N> {
        Shapes::make::<Self, D>(self, needs, distance_squared, scales)
    }

    /// Makes the shapes of the first `count` pairs of a block, whose receivers have that scale.
    ///
    /// A cut-off that is chosen at run time is chosen here, once for all of them.
    #[inline(always)]
    fn shapes<const D: usize, N: Number>(
        self,
        needs: Needs,
        scale: N,
        count: usize,
        pairs: &mut PairBlock<N>,
    ) {
        pairs.make::<Self, D>(self, needs, scale, count);
    }
}

/// `t²`.
#[inline(always)]
fn square<N: Number>(t: N) -> N {
    t * t
}

/// `max(t, 0)`.
#[inline(always)]
fn positive<N: Number>(t: N) -> N {
    t.max(N::zero())
}

/// `ζ̄(q) = ∫ ζ(q e + s) ds` over all s across the unit vector e, by the midpoint rule: how much of
/// a particle at distance q from a plane each piece of it has; of integral one over q.
pub fn across<S: Scalar, C: CutOff, const D: usize>(cut_off: C, q: S) -> S {
    const POINTS: u32 = 32;
    let sigma = S::from_f64(cut_off.normalisation::<D>());
    let value = |across: S| {
        let argument = cut_off.argument(q * q + across * across);
        cut_off.value::<D, S>(argument * cut_off.scale(S::ONE))
    };
    if D == 1 {
        return sigma * value(S::ZERO);
    }
    let width = f64::from(cut_off.support()) / f64::from(POINTS);
    let mut sum = S::ZERO;
    for i in 0..POINTS {
        let s = width * (f64::from(i) + 0.5);
        // Both directions along a line, or a ring in a plane.
        let measure = match D {
            2 => 2.0 * width,
            _ => core::f64::consts::TAU * s * width,
        };
        sum += S::from_f64(measure) * value(S::from_f64(s));
    }
    if D == 3 {
        // Euler and Maclaurin: of the rings, which do not end flat.
        let part = core::f64::consts::TAU * width * width / 24.0;
        sum -= S::from_f64(part) * value(S::ZERO);
    }
    sigma * sum
}

/// `∫ |∂_1 ζ| dx = c_D σ_D ∫ |z'| q^(D-1) dq`, `c = 2, 4, 2π`, by the midpoint rule.
pub fn slope<C: CutOff, const D: usize>(cut_off: C) -> f64 {
    const POINTS: u32 = 256;
    let sphere = match D {
        1 => 2.0,
        2 => 4.0,
        _ => core::f64::consts::TAU,
    };
    let width = f64::from(cut_off.support()) / f64::from(POINTS);
    let mut sum = 0.0;
    for i in 0..POINTS {
        let q = width * (f64::from(i) + 0.5);
        let argument = cut_off.argument(q * q);
        let slope = cut_off.gradient::<D, f64>(argument) * q;
        let size = if slope < 0.0 { -slope } else { slope };
        sum += size * Scalar::powi(q, D.saturating_sub(1));
    }
    sphere * cut_off.normalisation::<D>() * width * sum
}
