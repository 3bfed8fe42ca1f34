//! The approximate scalar: `f32` whose roots come from `micromath`.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{Number, Scalar};

/// `f32` with the fast approximate square root of `micromath` (off by up to 6 %): for
/// devices where an exact root costs too much, and to see what such a root does to a
/// solution. The arithmetic `+ - * /` is that of `f32`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Default)]
#[repr(transparent)]
pub struct Micro(pub f32);

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait for Micro {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Micro {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
impl AddAssign for Micro {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.0 += other.0;
    }
}
impl SubAssign for Micro {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        self.0 -= other.0;
    }
}

impl Number for Micro {
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
    #[inline(always)]
    fn sqrt(self) -> Self {
        // Named in full: with the trait imported, every `.sqrt()` here could change meaning.
        // Its root of 0 is a tiny positive number; ours is 0.
        if self.0 > 0.0 {
            Self(micromath::F32Ext::sqrt(self.0))
        } else {
            Self(0.0)
        }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(Number::min(self.0, other.0))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(Number::max(self.0, other.0))
    }
    #[inline(always)]
    fn below(self, bound: Self) -> Self {
        Self(Number::below(self.0, bound.0))
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

impl Scalar for Micro {
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
    const BYTES: usize = f32::BYTES;
    const REACH_LIMIT: Self = Self(f32::REACH_LIMIT);
    const CELL_LIMIT: u32 = f32::CELL_LIMIT;
    const EXTRAPOLATION: Self = Self(f32::EXTRAPOLATION);
    const TINIEST: Self = Self(f32::TINIEST);
    const LARGEST: Self = Self(f32::LARGEST);

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
    const NOTHING: Self = Self(0.0);
    #[inline(always)]
    fn wide_to_f64(wide: Self) -> f64 {
        wide.to_f64()
    }
    #[inline(always)]
    fn wide_bits(wide: Self) -> u128 {
        f32::wide_bits(wide.0)
    }
    #[inline(always)]
    fn from_wide_bits(bits: u128) -> Self {
        Self(f32::from_wide_bits(bits))
    }
    #[inline(always)]
    fn step(self, a: Self, b: Self, left: &mut Self) -> Self {
        Self(self.0.step(a.0, b.0, &mut left.0))
    }
    #[inline(always)]
    fn near(self) -> Self {
        self
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(f32::from_f64(value))
    }
    #[inline(always)]
    fn from_f32(value: f32) -> Self {
        Self(value)
    }
    #[inline(always)]
    fn from_i32(n: i32) -> Self {
        Self(f32::from_i32(n))
    }
    #[inline(always)]
    fn from_bits(bits: u64) -> Self {
        Self(<f32 as Scalar>::from_bits(bits))
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self.0)
    }
    #[inline(always)]
    fn to_f32(self) -> f32 {
        self.0
    }
    #[inline(always)]
    fn bits(self) -> u64 {
        Scalar::bits(self.0)
    }
    #[inline(always)]
    fn half(self) -> Self {
        Self(self.0.half())
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    #[inline(always)]
    fn cells(self, cell: Self) -> u32 {
        self.0.cells(cell.0)
    }
    #[inline(always)]
    fn count(n: u32) -> Self {
        Self(f32::count(n))
    }
}
