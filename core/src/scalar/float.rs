//! `f32` and `f64`: IEEE 754 arithmetic, round to nearest, no fused operations.

use super::{Number, Scalar};

#[cfg(feature = "std")]
extern crate std;

macro_rules! float {
    ($float:ty, $unsigned:ty, $sqrt:path, $reach:expr, $cells:expr, $extrapolation:expr, $carries:expr) => {
        impl Number for $float {
            type Scalar = $float;
            const LANES: usize = 1;

            #[inline(always)]
            fn splat(value: $float) -> Self {
                value
            }
            #[inline(always)]
            fn set_lane(&mut self, i: usize, value: $float) {
                if i == 0 {
                    *self = value;
                }
            }
            #[inline(always)]
            fn lane(&self, _: usize) -> $float {
                *self
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                // The same bits either way; the library function keeps the x86 compiler
                // from vectorising, the standard library's is one instruction.
                #[cfg(feature = "std")]
                {
                    <$float>::sqrt(self)
                }
                #[cfg(not(feature = "std"))]
                {
                    $sqrt(self)
                }
            }
            // Comparisons, not `f32::min`: that one has to look for NaN in both arguments.
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
            #[inline(always)]
            fn below(self, bound: Self) -> Self {
                if self < bound { 1.0 } else { 0.0 }
            }
            #[inline(always)]
            fn any_below(self, bound: Self) -> bool {
                self < bound
            }
            #[inline(always)]
            fn dot<const D: usize>(a: &[Self; D], b: &[Self; D]) -> Self {
                if D == 0 {
                    return Self::ZERO;
                }
                let mut sum = Self::product(a[0], b[0]);
                for i in 1..D {
                    sum = Self::wide_sum(sum, Self::product(a[i], b[i]));
                }
                Self::rounded(sum)
            }
            #[inline(always)]
            fn length_squared<const D: usize>(r: &[Self; D]) -> Self {
                let near = r.map(Scalar::near);
                Self::dot(&near, &near)
            }
        }

        impl Scalar for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const BYTES: usize = size_of::<$float>();
            const REACH_LIMIT: Self = $reach;
            const CELL_LIMIT: u32 = $cells;
            const EXTRAPOLATION: Self = $extrapolation;
            const TINIEST: Self = <$float>::MIN_POSITIVE;
            const LARGEST: Self = <$float>::MAX;

            type Wide = Self;
            #[inline(always)]
            fn product(a: Self, b: Self) -> Self {
                a * b
            }
            #[inline(always)]
            fn wide_sum(a: Self, b: Self) -> Self {
                a + b
            }
            #[inline(always)]
            fn rounded(wide: Self) -> Self {
                wide
            }
            #[inline(always)]
            fn scaled(a: Self, wide: Self) -> Self {
                a * wide
            }
            const HAS_EXACT_SUMS: bool = false;
            const NOTHING: Self = 0.0;
            #[inline(always)]
            fn wide_to_f64(wide: Self) -> f64 {
                f64::from(wide)
            }
            #[inline(always)]
            fn wide_bits(wide: Self) -> u128 {
                u128::from(wide.to_bits())
            }
            #[inline(always)]
            fn from_wide_bits(bits: u128) -> Self {
                <Self as Scalar>::from_bits(bits as u64)
            }
            #[inline(always)]
            fn step(self, a: Self, b: Self, left: &mut Self) -> Self {
                if !$carries {
                    return a * b;
                }
                let step = a * b + *left;
                *left = step - ((self + step) - self);
                step
            }
            #[inline(always)]
            fn near(self) -> Self {
                // Squares of floats within any domain are far from overflow.
                self
            }
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $float
            }
            #[inline(always)]
            fn from_f32(value: f32) -> Self {
                <$float>::from(value)
            }
            #[inline(always)]
            fn from_i32(n: i32) -> Self {
                n as $float
            }
            #[inline(always)]
            fn from_bits(bits: u64) -> Self {
                <$float>::from_bits(bits as $unsigned)
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn to_f32(self) -> f32 {
                self as f32
            }
            #[inline(always)]
            fn bits(self) -> u64 {
                u64::from(self.to_bits())
            }
            #[inline(always)]
            fn half(self) -> Self {
                0.5 * self
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }
            #[inline(always)]
            fn cells(self, cell: Self) -> u32 {
                // The cast saturates: NaN and negative values give 0.
                (self / cell) as u32
            }
            #[inline(always)]
            fn count(n: u32) -> Self {
                n as $float
            }
        }
    };
}

// f32: an index below 2^16 is off by less than 2 * 2^-24 * 2^16 = 2^-7 of a cell.
float!(f32, u32, libm::sqrtf, 1e18, 1 << 16, 1.0 / 256.0, true);
float!(f64, u64, libm::sqrt, 1e150, 1 << 30, 1.0 / 16384.0, false);
