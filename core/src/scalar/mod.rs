//! The arithmetic of the solver: scalars, and lanes of scalars that the compiler vectorises.
//!
//! Every equation is written once over [`Number`]. A [`Scalar`] is a number; so is
//! [`Lanes`], a small array of scalars that are worked on together. Only `+ - * /`,
//! square roots, minima, maxima and one comparison are used, each defined to the last bit.

mod checked;
pub(crate) mod enclosure;
#[cfg(feature = "fixed")]
mod fixed_point;
mod float;
mod lanes;
#[cfg(feature = "micromath")]
mod micro;
#[cfg(test)]
mod tests;
mod turns;

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

pub use checked::{Checked, CheckedWide};
pub use enclosure::Enclosure;
#[cfg(feature = "fixed")]
pub use fixed_point::{Q32, Q64};
pub use lanes::Lanes;
#[cfg(feature = "micromath")]
pub use micro::Micro;
pub use turns::{cosine_of_turns, sine_of_turns};

/// A scalar, or several of them side by side: what a law computes with.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// What one lane holds.
    type Scalar: Scalar;
    /// Number of lanes.
    const LANES: usize;

    /// The same value in every lane.
    fn splat(value: Self::Scalar) -> Self;
    /// Puts a value into lane `i`; does nothing beyond the last lane.
    fn set_lane(&mut self, i: usize, value: Self::Scalar);
    /// The value in lane `i`; the last lane where `i` is beyond it.
    fn lane(&self, i: usize) -> Self::Scalar;
    /// Square root; 0 for negative arguments in fixed point.
    fn sqrt(self) -> Self;
    /// The smaller of two.
    fn min(self, other: Self) -> Self;
    /// The larger of two.
    fn max(self, other: Self) -> Self;
    /// 1 where `self < bound`, else 0.
    fn below(self, bound: Self) -> Self;
    /// Whether any lane is below its bound.
    fn any_below(self, bound: Self) -> bool;
    /// `Σ_i a_i b_i`, 0 of no components; in fixed point the sum is exact in double width and
    /// rounded once.
    fn dot<const D: usize>(a: &[Self; D], b: &[Self; D]) -> Self;
    /// `|r|²`, cut off so that it cannot wrap: beyond [`Scalar::REACH_LIMIT`] it is only "far".
    fn length_squared<const D: usize>(r: &[Self; D]) -> Self;

    /// A constant of a formula, rounded to the format.
    #[inline(always)]
    fn literal(value: f64) -> Self {
        Self::splat(Self::Scalar::from_f64(value))
    }
    /// 0 in every lane.
    #[inline(always)]
    fn zero() -> Self {
        Self::splat(Self::Scalar::ZERO)
    }
}

/// One number of the solver: `f32`, `f64`, [`Q32`], [`Q64`], [`Micro`] or [`Checked`].
pub trait Scalar: Number<Scalar = Self> + PartialOrd + Debug + Send + Sync + 'static {
    /// Zero, all bits clear.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// Width of the bit pattern in bytes.
    const BYTES: usize;
    /// Largest component of a displacement whose squared length in 3D does not wrap; the
    /// largest reach a cloud may have.
    const REACH_LIMIT: Self;
    /// Largest number of cells along one direction for which a cell index is still exact
    /// to 1/64 of a cell.
    const CELL_LIMIT: u32;
    /// Largest step in ln ε after which the density sums are extrapolated to second order and
    /// not made again: its cube is below the format's rounding, or near it, and its square
    /// (the error of Ω) far below the error of any resolution.
    const EXTRAPOLATION: Self;
    /// Whether a sum or product beyond the range wraps without a trace: fixed point. What is to be
    /// believed must then be proven to stay in range, see [`crate::pairs::Engine::evaluate`].
    const WRAPS: bool = false;
    /// The smallest positive number with all its digits: a divisor in place of 0.
    const TINIEST: Self;
    /// The largest number.
    const LARGEST: Self;

    /// What an exact product of two scalars is kept in: double width in fixed point.
    type Wide: Copy + Debug + Send + Sync + 'static;
    /// No product: 0.
    const NOTHING: Self::Wide;
    /// `a b`, exact where [`Self::Wide`] is wider.
    fn product(a: Self, b: Self) -> Self::Wide;
    /// The sum of two products.
    fn wide_sum(a: Self::Wide, b: Self::Wide) -> Self::Wide;
    /// A sum of products, rounded once.
    fn rounded(wide: Self::Wide) -> Self;
    /// The same; in fixed point the largest number where there is no such scalar.
    #[inline(always)]
    fn saturated(wide: Self::Wide) -> Self {
        Self::rounded(wide)
    }
    /// `a` times a sum of products, which is rounded to the last place of a scalar first, however large.
    fn scaled(a: Self, wide: Self::Wide) -> Self::Wide;
    /// Whether sums of products are exact, whatever their order.
    const HAS_EXACT_SUMS: bool;
    /// A sum of products as `f64`, for reports; never used by the solver.
    fn wide_to_f64(wide: Self::Wide) -> f64;
    /// The bit pattern of a sum of products, for digests.
    fn wide_bits(wide: Self::Wide) -> u128;
    /// The sum of products with that bit pattern: the inverse of [`Scalar::wide_bits`].
    fn from_wide_bits(bits: u128) -> Self::Wide;
    /// The step `a b` of a sum that is made of many, `self` so far, with what rounding has kept from it,
    /// `left`, which becomes what rounding keeps from it now (Kahan, Comm. ACM 8, 40, 1965).
    ///
    /// In fixed point `left` counts in the last place of a product, exactly; in `f64` it stays 0: there a
    /// step has digits enough.
    fn step(self, a: Self, b: Self, left: &mut Self) -> Self;
    /// A component of a displacement, cut off at ±[`Scalar::REACH_LIMIT`].
    fn near(self) -> Self;

    /// The number nearest to `value`: ties to even in floats, away from zero in fixed point, where
    /// it saturates and NaN is 0.
    ///
    /// Of a constant it is a constant: no arithmetic is left for the run, nor any of `f64` where a
    /// fixed-point number is made of a variable.
    fn from_f64(value: f64) -> Self;
    /// The number nearest to `value`, as [`Scalar::from_f64`].
    fn from_f32(value: f32) -> Self;
    /// The number nearest to `n`, as [`Scalar::from_f64`].
    fn from_i32(n: i32) -> Self;
    /// The number with that bit pattern, of which only the lowest [`Scalar::BYTES`] count: the
    /// inverse of [`Scalar::bits`].
    fn from_bits(bits: u64) -> Self;
    /// The value as `f64`, for reports; never used by the solver.
    fn to_f64(self) -> f64;
    /// The nearest `f32`, for bounds.
    fn to_f32(self) -> f32;
    /// The bit pattern, zero-extended.
    fn bits(self) -> u64;
    /// Half of it.
    fn half(self) -> Self;
    /// Neither infinite, nor not-a-number, nor marked as overflowed.
    fn is_finite(self) -> bool;
    /// `⌊self / cell⌋` as a cell index; 0 where that is negative or undefined.
    fn cells(self, cell: Self) -> u32;
    /// `n` as a scalar, saturating.
    fn count(n: u32) -> Self;

    /// `|self|`.
    #[inline(always)]
    fn abs(self) -> Self {
        Number::max(self, -self)
    }
    /// The smaller of two; a name for `reduce` where `Ord::min` is near.
    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        Number::min(self, other)
    }
    /// The larger of two.
    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        Number::max(self, other)
    }
    /// `selfⁿ`: by repeated multiplication for `n` up to 16, beyond by repeated squaring, so that no
    /// exponent takes more than 64 products.
    #[inline(always)]
    fn powi(self, n: usize) -> Self {
        let mut power = Self::ONE;
        if n <= 16 {
            for _ in 0..n {
                power = power * self;
            }
            return power;
        }
        let mut bit = usize::BITS - n.leading_zeros();
        while bit > 0 {
            bit -= 1;
            power = power * power;
            if n >> bit & 1 == 1 {
                power = power * self;
            }
        }
        power
    }
}
