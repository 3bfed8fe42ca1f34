//! Fixed point with symmetric rounding over [`fixed::FixedI32`] and [`fixed::FixedI64`].
//!
//! Differs from `fixed`'s own operators: its `*` rounds towards minus infinity, so
//! `(-a)*b != -(a*b)` and equal and opposite forces would not cancel. Here products and
//! quotients round to nearest, ties away from zero. Sums wrap, which keeps them
//! associative; [`super::Checked`] reports where they would. Quotients saturate, and
//! `x/0` is the largest value of the sign of `x`.

mod binary;

use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use fixed::types::extra::Unsigned;
use fixed::{FixedI32, FixedI64};

use super::{Number, Scalar};
use binary::Binary;

macro_rules! fixed_point {
    ($(#[$doc:meta])* $name:ident, $fixed:ident, $int:ty, $unsigned:ty, $wide:ty, $wide_unsigned:ty, $bits:literal) => {
        $(#[$doc])*
        ///
        /// Has at least 8 integer bits (sums over neighbours) and 8 fractional bits: another
        /// format does not compile.
        #[derive(Clone, Copy, Default)]
        #[repr(transparent)]
        pub struct $name<F: Unsigned>(pub $fixed<F>);

        impl<F: Unsigned> $name<F> {
            const FRACTION: u32 = {
                assert!(
                    F::U32 >= 8 && F::U32 + 8 < $bits,
                    "a format has at least 8 integer and 8 fractional bits"
                );
                F::U32
            };
            const HALF: $wide = (1 << Self::FRACTION) >> 1;
            // 3 r² < 2^(bits-1) in this format.
            const LIMIT: $int =
                (((1 as $wide_unsigned) << ($bits - 1 + Self::FRACTION)) / 3).isqrt() as $int - 1;

            /// The number with this bit pattern: `bits / 2^F`.
            #[inline(always)]
            pub const fn from_bits(bits: $int) -> Self {
                // Looked at here, a format without room for its sums makes no number at all.
                let _ = Self::FRACTION;
                Self($fixed::from_bits(bits))
            }
            /// The bit pattern: `self * 2^F`.
            #[inline(always)]
            pub const fn to_bits(self) -> $int {
                self.0.to_bits()
            }
            /// A binary number, rounded half away from zero; saturates.
            #[inline(always)]
            fn nearest(binary: Binary) -> Self {
                let size = binary.times_two_to(Self::FRACTION);
                Self::from_bits(match <$int>::try_from(size) {
                    Ok(size) if binary.is_negative => -size,
                    Ok(size) => size,
                    Err(_) if binary.is_negative => <$int>::MIN,
                    Err(_) => <$int>::MAX,
                })
            }
            /// A double-width product or sum of products, rounded half away from zero.
            #[inline(always)]
            fn round(product: $wide) -> Self {
                Self::from_bits(Self::whole(product) as $int)
            }
            /// The same in units of the last place, whether a scalar holds it or not.
            #[inline(always)]
            fn whole(product: $wide) -> $wide {
                // Adding -1 to negative products makes the floor of >> symmetric.
                let sign = product >> (2 * $bits - 1);
                let sum = product.wrapping_add(Self::HALF).wrapping_add(sign);
                sum >> Self::FRACTION
            }
        }

        impl<F: Unsigned> PartialEq for $name<F> {
            #[inline(always)]
            fn eq(&self, other: &Self) -> bool {
                self.to_bits() == other.to_bits()
            }
        }
        impl<F: Unsigned> Eq for $name<F> {}
        impl<F: Unsigned> PartialOrd for $name<F> {
            #[inline(always)]
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                Some(self.cmp(other))
            }
        }
        impl<F: Unsigned> Ord for $name<F> {
            #[inline(always)]
            fn cmp(&self, other: &Self) -> Ordering {
                self.to_bits().cmp(&other.to_bits())
            }
        }

        impl<F: Unsigned> core::fmt::Debug for $name<F> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                core::fmt::Debug::fmt(&self.0, f)
            }
        }

        impl<F: Unsigned> Add for $name<F> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self::from_bits(self.to_bits().wrapping_add(other.to_bits()))
            }
        }
        impl<F: Unsigned> Sub for $name<F> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self::from_bits(self.to_bits().wrapping_sub(other.to_bits()))
            }
        }
        impl<F: Unsigned> Neg for $name<F> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self::from_bits(self.to_bits().wrapping_neg())
            }
        }
        impl<F: Unsigned> Mul for $name<F> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                Self::round(self.to_bits() as $wide * other.to_bits() as $wide)
            }
        }
        impl<F: Unsigned> Div for $name<F> {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                let negative = (self.to_bits() < 0) != (other.to_bits() < 0);
                let below = other.to_bits().unsigned_abs();
                let above = (self.to_bits().unsigned_abs() as $wide_unsigned) << Self::FRACTION;
                let rounded_up = above + (below >> 1) as $wide_unsigned;
                let quotient = match rounded_up.checked_div(below as $wide_unsigned) {
                    Some(quotient) => quotient.min(<$int>::MAX as $wide_unsigned) as $int,
                    None if self.to_bits() == 0 => 0,
                    None => <$int>::MAX,
                };
                Self::from_bits(if negative { quotient.wrapping_neg() } else { quotient })
            }
        }
        impl<F: Unsigned> AddAssign for $name<F> {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }
        impl<F: Unsigned> SubAssign for $name<F> {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl<F: Unsigned + Copy + Send + Sync + 'static> Number for $name<F> {
            type Scalar = Self;
            const LANES: usize = 1;

            #[inline(always)]
            fn splat(value: Self) -> Self {
                value
            }
            #[inline(always)]
            fn set_lane(&mut self, i: usize, value: Self) {
                if i == 0 {
                    *self = value;
                }
            }
            #[inline(always)]
            fn lane(&self, _: usize) -> Self {
                *self
            }
            // Long, and made of steps that no loop shares.
            #[inline(never)]
            fn sqrt(self) -> Self {
                let positive = self.to_bits().max(0) as $wide_unsigned;
                Self::from_bits((positive << Self::FRACTION).isqrt() as $int)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self::from_bits(self.to_bits().min(other.to_bits()))
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                Self::from_bits(self.to_bits().max(other.to_bits()))
            }
            #[inline(always)]
            fn below(self, bound: Self) -> Self {
                if self < bound { Self::ONE } else { Self::ZERO }
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

        impl<F: Unsigned + Copy + Send + Sync + 'static> Scalar for $name<F> {
            const ZERO: Self = Self::from_bits(0);
            const ONE: Self = Self::from_bits(1 << Self::FRACTION);
            const BYTES: usize = size_of::<$int>();
            const REACH_LIMIT: Self = Self::from_bits(Self::LIMIT);
            const CELL_LIMIT: u32 = 1 << 30;
            const EXTRAPOLATION: Self = Self::from_bits(1 << (Self::FRACTION - Self::FRACTION / 2));
            const WRAPS: bool = true;
            const TINIEST: Self = Self::from_bits(1);
            const LARGEST: Self = Self::from_bits(<$int>::MAX);

            type Wide = $wide;
            #[inline(always)]
            fn product(a: Self, b: Self) -> $wide {
                a.to_bits() as $wide * b.to_bits() as $wide
            }
            #[inline(always)]
            fn wide_sum(a: $wide, b: $wide) -> $wide {
                a.wrapping_add(b)
            }
            #[inline(always)]
            fn rounded(wide: $wide) -> Self {
                Self::round(wide)
            }
            #[inline(always)]
            fn saturated(wide: $wide) -> Self {
                let most = <$int>::MAX as $wide;
                Self::from_bits(Self::whole(wide).clamp(-most, most) as $int)
            }
            #[inline(always)]
            fn scaled(a: Self, wide: $wide) -> $wide {
                (a.to_bits() as $wide).wrapping_mul(Self::whole(wide))
            }
            const HAS_EXACT_SUMS: bool = true;
            const NOTHING: $wide = 0;
            #[inline(always)]
            fn wide_to_f64(wide: $wide) -> f64 {
                let one = ((1 as $wide_unsigned) << Self::FRACTION) as f64;
                wide as f64 / one / one
            }
            #[inline(always)]
            fn wide_bits(wide: $wide) -> u128 {
                wide as $wide_unsigned as u128
            }
            #[inline(always)]
            fn from_wide_bits(bits: u128) -> $wide {
                bits as $wide_unsigned as $wide
            }
            #[inline(always)]
            fn step(self, a: Self, b: Self, left: &mut Self) -> Self {
                let wide = Self::product(a, b).wrapping_add(left.to_bits() as $wide);
                let whole = Self::whole(wide);
                // At most half a unit of the last place.
                *left = Self::from_bits(wide.wrapping_sub(whole << Self::FRACTION) as $int);
                Self::from_bits(whole as $int)
            }
            #[inline(always)]
            fn near(self) -> Self {
                Self::from_bits(self.to_bits().clamp(-Self::LIMIT, Self::LIMIT))
            }
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                match Binary::of_f64(value) {
                    Some(binary) => Self::nearest(binary),
                    None => Self::ZERO,
                }
            }
            #[inline(always)]
            fn from_f32(value: f32) -> Self {
                match Binary::of_f32(value) {
                    Some(binary) => Self::nearest(binary),
                    None => Self::ZERO,
                }
            }
            #[inline(always)]
            fn from_i32(n: i32) -> Self {
                Self::nearest(Binary {
                    is_negative: n < 0,
                    significand: n.unsigned_abs().into(),
                    exponent: 0,
                })
            }
            #[inline(always)]
            fn from_bits(bits: u64) -> Self {
                Self::from_bits(bits as $int)
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                self.to_bits() as f64 / ((1 as $wide_unsigned) << Self::FRACTION) as f64
            }
            #[inline(always)]
            fn to_f32(self) -> f32 {
                self.to_bits() as f32 / ((1 as $wide_unsigned) << Self::FRACTION) as f32
            }
            #[inline(always)]
            fn bits(self) -> u64 {
                self.to_bits() as $unsigned as u64
            }
            #[inline(always)]
            fn half(self) -> Self {
                Self::round(self.to_bits() as $wide * Self::HALF)
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                true
            }
            #[inline(always)]
            fn cells(self, cell: Self) -> u32 {
                let offset = self.to_bits().max(0) as $unsigned;
                let index = offset.checked_div(cell.to_bits().max(0) as $unsigned);
                u32::try_from(index.unwrap_or(0)).unwrap_or(u32::MAX)
            }
            #[inline(always)]
            fn count(n: u32) -> Self {
                let bits = (n as $wide) << Self::FRACTION;
                Self::from_bits(bits.min(<$int>::MAX as $wide) as $int)
            }
        }
    };
}

fixed_point!(
    /// A 32-bit fixed-point number with `F` fractional bits: Q(31-F).F.
    Q32, FixedI32, i32, u32, i64, u64, 32
);
fixed_point!(
    /// A 64-bit fixed-point number with `F` fractional bits: Q(63-F).F.
    Q64, FixedI64, i64, u64, i128, u128, 64
);

impl<F: Unsigned> From<FixedI32<F>> for Q32<F> {
    fn from(value: FixedI32<F>) -> Self {
        Self(value)
    }
}
impl<F: Unsigned> From<FixedI64<F>> for Q64<F> {
    fn from(value: FixedI64<F>) -> Self {
        Self(value)
    }
}
