//! Several receivers side by side.
//!
//! Plain loops over arrays: inside a function compiled for a wide instruction set they
//! become one instruction each. Lane `i` undergoes exactly the operations that the scalar
//! would, so the bits do not depend on the number of lanes.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{Number, Scalar};

/// `L` scalars that are worked on together.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Lanes<S, const L: usize>(pub [S; L]);

impl<S: Scalar, const L: usize> Lanes<S, L> {
    #[inline(always)]
    fn zip(self, other: Self, operation: impl Fn(S, S) -> S) -> Self {
        let mut result = self;
        for i in 0..L {
            result.0[i] = operation(self.0[i], other.0[i]);
        }
        result
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<S: Scalar, const L: usize> $trait for Lanes<S, L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let mut result = self;
                for i in 0..L {
                    result.0[i] = self.0[i].$method(other.0[i]);
                }
                result
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<S: Scalar, const L: usize> Neg for Lanes<S, L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.zip(self, |a, _| -a)
    }
}
impl<S: Scalar, const L: usize> AddAssign for Lanes<S, L> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl<S: Scalar, const L: usize> SubAssign for Lanes<S, L> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<S: Scalar, const L: usize> Number for Lanes<S, L> {
    type Scalar = S;
    const LANES: usize = L;

    #[inline(always)]
    fn splat(value: S) -> Self {
        Self([value; L])
    }
    #[inline(always)]
    fn set_lane(&mut self, i: usize, value: S) {
        if let Some(lane) = self.0.get_mut(i) {
            *lane = value;
        }
    }
    #[inline(always)]
    fn lane(&self, i: usize) -> S {
        self.0.get(i).or(self.0.last()).copied().unwrap_or(S::ZERO)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.zip(self, |a, _| a.sqrt())
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, Number::min)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, Number::max)
    }
    #[inline(always)]
    fn below(self, bound: Self) -> Self {
        self.zip(bound, Number::below)
    }
    #[inline(always)]
    fn any_below(self, bound: Self) -> bool {
        let mut any = false;
        for i in 0..L {
            any |= self.0[i] < bound.0[i];
        }
        any
    }
    #[inline(always)]
    fn dot<const D: usize>(a: &[Self; D], b: &[Self; D]) -> Self {
        if D == 0 {
            return Self::zero();
        }
        // Component by component, all lanes at once: the order that the compiler vectorises.
        let mut sum = [S::product(S::ZERO, S::ZERO); L];
        for i in 0..L {
            sum[i] = S::product(a[0].0[i], b[0].0[i]);
        }
        for j in 1..D {
            for i in 0..L {
                sum[i] = S::wide_sum(sum[i], S::product(a[j].0[i], b[j].0[i]));
            }
        }
        let mut result = Self::zero();
        for i in 0..L {
            result.0[i] = S::rounded(sum[i]);
        }
        result
    }
    #[inline(always)]
    fn length_squared<const D: usize>(r: &[Self; D]) -> Self {
        let mut near = *r;
        for component in &mut near {
            for i in 0..L {
                component.0[i] = component.0[i].near();
            }
        }
        Self::dot(&near, &near)
    }
}
