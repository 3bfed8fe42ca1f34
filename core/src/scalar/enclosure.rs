//! All the values that a number may have, and the largest that went into them: what a formula is
//! proven over to stay in the range of a format.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{Number, Scalar};

/// An interval of values of `S`, by interval arithmetic in `f64`.
///
/// A law written over [`Number`] is evaluated over intervals as it stands: `worst` bounds the
/// magnitude of every sum and product on the way. Quotients and roots saturate in `S`, and do here.
/// Each product and quotient is widened by a unit of the last place, for its rounding.
#[derive(Clone, Copy, Debug)]
pub struct Enclosure<S> {
    /// The least value.
    pub low: f64,
    /// The largest one.
    pub high: f64,
    /// The largest magnitude of anything that it was made from.
    pub worst: f64,
    ends: [S; 2],
}

/// The larger of two bounds; no number, or one out of every range, beats all others.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a >= b { a } else { b }
}

/// Whether an interval reaches as far below 0 as above, as most of what a proof sees do: half the work.
#[inline(always)]
fn is_even(low: f64, high: f64) -> bool {
    low.to_bits() == (-high).to_bits()
}

/// The larger of two magnitudes, by their bits: a device without `f64` has them sooner than values. No
/// number beats all others here too.
#[inline(always)]
pub(crate) fn worse(a: f64, b: f64) -> f64 {
    let [a, b] = [a, b].map(|x| x.abs().to_bits());
    f64::from_bits(if a >= b { a } else { b })
}

impl<S: Scalar> Enclosure<S> {
    /// From `low` to `high`.
    pub fn new(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            worst: worse(low, high),
            ends: [S::ZERO; 2],
        }
    }

    /// From `-size` to `size`.
    pub fn within(size: f64) -> Self {
        Self::new(-size, size)
    }

    fn of(low: f64, high: f64, from: [&Self; 2]) -> Self {
        let mut made = Self::new(low, high);
        for operand in from {
            made.worst = worse(made.worst, operand.worst);
        }
        made
    }

    /// The same, wider by a unit of the last place.
    fn rounded(low: f64, high: f64, from: [&Self; 2]) -> Self {
        let unit = S::TINIEST.to_f64();
        let above = high + unit;
        match is_even(low, high) {
            true => Self::of(-above, above, from),
            false => Self::of(low - unit, above, from),
        }
    }

    /// The range of sums.
    fn sums(&self, [low, high]: [f64; 2]) -> (f64, f64) {
        let sum = self.high + high;
        match is_even(self.low, self.high) && is_even(low, high) {
            true => (-sum, sum),
            false => (self.low + low, sum),
        }
    }

    /// The range of products.
    fn products(&self, other: &Self) -> (f64, f64) {
        if is_even(self.low, self.high) || is_even(other.low, other.high) {
            let product = worse(self.low, self.high) * worse(other.low, other.high);
            return (-product, product);
        }
        self.corners(other, |a, b| a * b)
    }

    fn corners(&self, other: &Self, operation: impl Fn(f64, f64) -> f64) -> (f64, f64) {
        let [a, b] = [self.low, self.high].map(|x| operation(x, other.low));
        let [c, d] = [self.low, self.high].map(|x| operation(x, other.high));
        let least = |x: f64, y: f64| -larger(-x, -y);
        (
            least(least(a, b), least(c, d)),
            larger(larger(a, b), larger(c, d)),
        )
    }
}

impl<S: Scalar> Add for Enclosure<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (low, high) = self.sums([other.low, other.high]);
        Self::of(low, high, [&self, &other])
    }
}
impl<S: Scalar> Sub for Enclosure<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let (low, high) = self.sums([-other.high, -other.low]);
        Self::of(low, high, [&self, &other])
    }
}
impl<S: Scalar> Neg for Enclosure<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::of(-self.high, -self.low, [&self, &self])
    }
}
impl<S: Scalar> Mul for Enclosure<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (low, high) = self.products(&other);
        Self::rounded(low, high, [&self, &other])
    }
}
impl<S: Scalar> Div for Enclosure<S> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let largest = S::LARGEST.to_f64();
        let (low, high) = match other.low > 0.0 || other.high < 0.0 {
            true => self.corners(&other, |a, b| a / b),
            false => (-largest, largest),
        };
        let bounded = |x: f64| x.max(-largest).min(largest);
        let mut made = Self::of(bounded(low), bounded(high), [&self, &other]);
        let unit = S::TINIEST.to_f64();
        (made.low, made.high) = (made.low - unit, made.high + unit);
        made
    }
}
impl<S: Scalar> AddAssign for Enclosure<S> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl<S: Scalar> SubAssign for Enclosure<S> {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<S: Scalar> Number for Enclosure<S> {
    type Scalar = S;
    const LANES: usize = 1;

    fn splat(value: S) -> Self {
        let x = value.to_f64();
        Self {
            ends: [value; 2],
            ..Self::new(x, x)
        }
    }
    /// Takes the value in: in lane 0 as a possible end, which [`Number::lane`] tells; in others as a
    /// value of the interval.
    #[inline(always)]
    fn set_lane(&mut self, i: usize, value: S) {
        self.ends[0] = self.ends[0].lesser(value);
        self.ends[1] = self.ends[1].greater(value);
        if i > 0 {
            let x = value.to_f64();
            self.low = -larger(-self.low, -x);
            self.high = larger(self.high, x);
            self.worst = worse(self.worst, worse(self.low, self.high));
        }
    }
    /// Lane 0 is the lower end, every other one the upper end, of what was taken in.
    #[inline(always)]
    fn lane(&self, i: usize) -> S {
        self.ends[usize::from(i > 0)]
    }
    fn sqrt(self) -> Self {
        let root = |x: f64| libm::sqrt(larger(x, 0.0));
        Self::rounded(root(self.low), root(self.high), [&self, &self])
    }
    fn min(self, other: Self) -> Self {
        let low = -larger(-self.low, -other.low);
        let high = -larger(-self.high, -other.high);
        Self::of(low, high, [&self, &other])
    }
    fn max(self, other: Self) -> Self {
        let low = larger(self.low, other.low);
        Self::of(low, larger(self.high, other.high), [&self, &other])
    }
    fn below(self, bound: Self) -> Self {
        Self::of(0.0, 1.0, [&self, &bound])
    }
    fn any_below(self, _: Self) -> bool {
        true
    }
    fn dot<const D: usize>(a: &[Self; D], b: &[Self; D]) -> Self {
        let mut sum = Self::new(0.0, 0.0);
        for (a, b) in a.iter().zip(b) {
            // The products are exact in double width: their sum alone has to fit.
            let (low, high) = a.products(b);
            let mut product = Self::new(low, high);
            product.worst = worse(a.worst, b.worst);
            sum += product;
        }
        Self::rounded(sum.low, sum.high, [&sum, &sum])
    }
    fn length_squared<const D: usize>(r: &[Self; D]) -> Self {
        let limit = S::REACH_LIMIT.to_f64();
        let near = r.map(|x| {
            let bounded = |x: f64| x.max(-limit).min(limit);
            Self::new(bounded(x.low), bounded(x.high))
        });
        Self::dot(&near, &near)
    }
}
