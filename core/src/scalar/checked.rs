//! Fixed point that remembers overflow.

use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{Number, Scalar};

/// A scalar with the same bits as `S` and a mark that tells whether anything it was made
/// from has left the range of the format.
///
/// The mark spreads through every operation, as NaN does in floats, so the state after a
/// step names the particles and quantities that an overflow reached;
/// [`Scalar::is_finite`] is false for them. About five times slower than `S`: meant for
/// finding out which format a run needs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Checked<S> {
    /// The value that `S` alone would have.
    pub value: S,
    /// Whether an overflow went into it.
    pub overflowed: bool,
}

/// A sum of products of [`Checked`] scalars.
#[derive(Clone, Copy, Debug)]
pub struct CheckedWide<S: Scalar> {
    wide: S::Wide,
    /// What it would be without a limit of range.
    unlimited: f64,
    overflowed: bool,
}

impl<S: Scalar> Checked<S> {
    /// A value that has seen no overflow.
    #[inline(always)]
    pub const fn new(value: S) -> Self {
        Self {
            value,
            overflowed: false,
        }
    }

    /// The result of one operation beside what it would be without a limit of range.
    ///
    /// One per cent of the largest value is allowed between the two, or a hundred times
    /// the rounding of small ones: a wrap is off by the whole range.
    #[inline(always)]
    fn of(value: S, unlimited: f64, overflowed: bool) -> Self {
        let difference = value.to_f64() - unlimited;
        let range = S::count(u32::MAX).to_f64();
        let overflowed = overflowed || !(difference < 0.01 * range && -difference < 0.01 * range);
        Self { value, overflowed }
    }
}

impl<S: Scalar> PartialEq for Checked<S> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}
impl<S: Scalar> PartialOrd for Checked<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<S: Scalar> $trait for Checked<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self::of(
                    self.value.$method(other.value),
                    self.value.to_f64().$method(other.value.to_f64()),
                    self.overflowed || other.overflowed,
                )
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<S: Scalar> Neg for Checked<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::of(-self.value, -self.value.to_f64(), self.overflowed)
    }
}
impl<S: Scalar> AddAssign for Checked<S> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl<S: Scalar> SubAssign for Checked<S> {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<S: Scalar> Number for Checked<S> {
    type Scalar = Self;
    const LANES: usize = 1;

    fn splat(value: Self) -> Self {
        value
    }
    fn set_lane(&mut self, i: usize, value: Self) {
        if i == 0 {
            *self = value;
        }
    }
    fn lane(&self, _: usize) -> Self {
        *self
    }
    fn sqrt(self) -> Self {
        Self {
            value: self.value.sqrt(),
            ..self
        }
    }
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    fn below(self, bound: Self) -> Self {
        Self {
            value: self.value.below(bound.value),
            overflowed: self.overflowed | bound.overflowed,
        }
    }
    fn any_below(self, bound: Self) -> bool {
        self < bound
    }
    fn dot<const D: usize>(a: &[Self; D], b: &[Self; D]) -> Self {
        let (mut unlimited, mut overflowed) = (0.0, false);
        for (a, b) in a.iter().zip(b) {
            unlimited += a.value.to_f64() * b.value.to_f64();
            overflowed |= a.overflowed | b.overflowed;
        }
        Self::of(
            S::dot(&a.map(|a| a.value), &b.map(|b| b.value)),
            unlimited,
            overflowed,
        )
    }
    fn length_squared<const D: usize>(r: &[Self; D]) -> Self {
        Self {
            value: S::length_squared(&r.map(|r| r.value)),
            overflowed: r.iter().any(|r| r.overflowed),
        }
    }
}

impl<S: Scalar> Scalar for Checked<S> {
    const ZERO: Self = Self::new(S::ZERO);
    const ONE: Self = Self::new(S::ONE);
    const BYTES: usize = S::BYTES;
    const REACH_LIMIT: Self = Self::new(S::REACH_LIMIT);
    const CELL_LIMIT: u32 = S::CELL_LIMIT;
    const EXTRAPOLATION: Self = Self::new(S::EXTRAPOLATION);
    const TINIEST: Self = Self::new(S::TINIEST);
    const LARGEST: Self = Self::new(S::LARGEST);

    type Wide = CheckedWide<S>;
    fn product(a: Self, b: Self) -> CheckedWide<S> {
        CheckedWide {
            wide: S::product(a.value, b.value),
            unlimited: a.value.to_f64() * b.value.to_f64(),
            overflowed: a.overflowed | b.overflowed,
        }
    }
    fn wide_sum(a: CheckedWide<S>, b: CheckedWide<S>) -> CheckedWide<S> {
        CheckedWide {
            wide: S::wide_sum(a.wide, b.wide),
            unlimited: a.unlimited + b.unlimited,
            overflowed: a.overflowed | b.overflowed,
        }
    }
    fn rounded(wide: CheckedWide<S>) -> Self {
        Self::of(S::rounded(wide.wide), wide.unlimited, wide.overflowed)
    }
    fn saturated(wide: CheckedWide<S>) -> Self {
        Self::of(S::saturated(wide.wide), wide.unlimited, wide.overflowed)
    }
    fn scaled(a: Self, wide: CheckedWide<S>) -> CheckedWide<S> {
        CheckedWide {
            wide: S::scaled(a.value, wide.wide),
            unlimited: a.value.to_f64() * wide.unlimited,
            overflowed: a.overflowed | wide.overflowed,
        }
    }
    const HAS_EXACT_SUMS: bool = S::HAS_EXACT_SUMS;
    const NOTHING: CheckedWide<S> = CheckedWide {
        wide: S::NOTHING,
        unlimited: 0.0,
        overflowed: false,
    };
    fn wide_to_f64(wide: CheckedWide<S>) -> f64 {
        S::wide_to_f64(wide.wide)
    }
    fn wide_bits(wide: CheckedWide<S>) -> u128 {
        S::wide_bits(wide.wide)
    }
    /// Without a mark: the pattern holds none.
    fn from_wide_bits(bits: u128) -> CheckedWide<S> {
        let wide = S::from_wide_bits(bits);
        CheckedWide {
            wide,
            unlimited: S::wide_to_f64(wide),
            overflowed: false,
        }
    }
    fn step(self, a: Self, b: Self, left: &mut Self) -> Self {
        let unlimited = a.value.to_f64() * b.value.to_f64();
        let step = self.value.step(a.value, b.value, &mut left.value);
        Self::of(step, unlimited, a.overflowed | b.overflowed)
    }
    fn near(self) -> Self {
        Self {
            value: self.value.near(),
            ..self
        }
    }
    fn from_f64(value: f64) -> Self {
        Self::of(S::from_f64(value), value, false)
    }
    fn from_f32(value: f32) -> Self {
        Self::of(S::from_f32(value), f64::from(value), false)
    }
    fn from_i32(n: i32) -> Self {
        Self::of(S::from_i32(n), f64::from(n), false)
    }
    /// Without a mark: the pattern holds none.
    fn from_bits(bits: u64) -> Self {
        Self::new(S::from_bits(bits))
    }
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
    fn to_f32(self) -> f32 {
        self.value.to_f32()
    }
    fn bits(self) -> u64 {
        self.value.bits()
    }
    fn half(self) -> Self {
        Self {
            value: self.value.half(),
            ..self
        }
    }
    fn is_finite(self) -> bool {
        !self.overflowed && self.value.is_finite()
    }
    fn cells(self, cell: Self) -> u32 {
        self.value.cells(cell.value)
    }
    fn count(n: u32) -> Self {
        Self::new(S::count(n))
    }
}
