//! All the values that a number may have, and the largest that went into them: what a formula is
//! proven over to stay in the range of a format.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{Number, Scalar};

/// An interval of values of `S`, by interval arithmetic in `f32`.
///
/// A law written over [`Number`] is evaluated over intervals as it stands: `worst` bounds the
/// magnitude of every sum and product on the way. Quotients and roots saturate in `S`, and do here.
/// Each product and quotient is widened by a unit of the last place of `S`, for its rounding, and every
/// result by one part in four millions, for that of `f32`: a device has it in hardware, and a bound
/// needs no more digits. Its operations are functions of their own: a law over intervals is long enough
/// without them.
#[derive(Clone, Copy, Debug)]
pub struct Enclosure<S> {
    /// The least value.
    pub low: f32,
    /// The largest one.
    pub high: f32,
    /// The largest magnitude of anything that it was made from.
    pub worst: f32,
    ends: [S; 2],
}

/// Four roundings of `f32`.
const SLACK: f32 = 2.0 * f32::EPSILON;

/// Not below what was rounded to `x`.
#[inline(always)]
fn up(x: f32) -> f32 {
    x + x.abs() * SLACK
}

/// Not above what was rounded to `x`.
#[inline(always)]
fn down(x: f32) -> f32 {
    x - x.abs() * SLACK
}

/// The larger of two bounds; no number, or one out of every range, beats all others.
#[inline(always)]
fn larger(a: f32, b: f32) -> f32 {
    if a >= b { a } else { b }
}

/// Whether an interval reaches as far below 0 as above, as most of what a proof sees do: half the work.
#[inline(always)]
fn is_even(low: f32, high: f32) -> bool {
    low.to_bits() == (-high).to_bits()
}

/// The larger of two magnitudes, by their bits: a device without a unit for floats has them sooner than
/// values. No number beats all others here too.
#[inline(always)]
pub(crate) fn worse(a: f32, b: f32) -> f32 {
    let [a, b] = [a, b].map(|x| x.abs().to_bits());
    f32::from_bits(if a >= b { a } else { b })
}

impl<S: Scalar> Enclosure<S> {
    /// From `low` to `high`.
    pub fn new(low: f64, high: f64) -> Self {
        Self::between(down(low as f32), up(high as f32))
    }

    /// From `-size` to `size`.
    pub fn within(size: f64) -> Self {
        Self::new(-size, size)
    }

    fn between(low: f32, high: f32) -> Self {
        Self {
            low,
            high,
            worst: worse(low, high),
            ends: [S::ZERO; 2],
        }
    }

    fn of(low: f32, high: f32, from: [&Self; 2]) -> Self {
        let mut made = Self::between(low, high);
        for operand in from {
            made.worst = worse(made.worst, operand.worst);
        }
        made
    }

    /// The same, wider by a unit of the last place.
    fn rounded(low: f32, high: f32, from: [&Self; 2]) -> Self {
        let unit = S::TINIEST.to_f32();
        let above = up(high + unit);
        match is_even(low, high) {
            true => Self::of(-above, above, from),
            false => Self::of(down(low - unit), above, from),
        }
    }

    /// The range of sums.
    fn sums(&self, [low, high]: [f32; 2]) -> (f32, f32) {
        let sum = up(self.high + high);
        match is_even(self.low, self.high) && is_even(low, high) {
            true => (-sum, sum),
            false => (down(self.low + low), sum),
        }
    }

    /// The range of products.
    fn products(&self, other: &Self) -> (f32, f32) {
        if is_even(self.low, self.high) || is_even(other.low, other.high) {
            let product = up(worse(self.low, self.high) * worse(other.low, other.high));
            return (-product, product);
        }
        self.corners(other, |a, b| a * b)
    }

    fn corners(&self, other: &Self, operation: impl Fn(f32, f32) -> f32) -> (f32, f32) {
        let [a, b] = [self.low, self.high].map(|x| operation(x, other.low));
        let [c, d] = [self.low, self.high].map(|x| operation(x, other.high));
        let least = |x: f32, y: f32| -larger(-x, -y);
        (
            down(least(least(a, b), least(c, d))),
            up(larger(larger(a, b), larger(c, d))),
        )
    }
}

impl<S: Scalar> Add for Enclosure<S> {
    type Output = Self;
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let (low, high) = self.sums([other.low, other.high]);
        Self::of(low, high, [&self, &other])
    }
}
impl<S: Scalar> Sub for Enclosure<S> {
    type Output = Self;
    #[inline(never)]
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
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let (low, high) = self.products(&other);
        Self::rounded(low, high, [&self, &other])
    }
}
impl<S: Scalar> Div for Enclosure<S> {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let largest = S::LARGEST.to_f32();
        let (low, high) = match other.low > 0.0 || other.high < 0.0 {
            true => self.corners(&other, |a, b| a / b),
            false => (-largest, largest),
        };
        let bounded = |x: f32| x.max(-largest).min(largest);
        let mut made = Self::of(bounded(low), bounded(high), [&self, &other]);
        let unit = S::TINIEST.to_f32();
        (made.low, made.high) = (down(made.low - unit), up(made.high + unit));
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
        let x = value.to_f32();
        Self {
            ends: [value; 2],
            ..Self::between(down(x), up(x))
        }
    }
    /// Takes the value in: in lane 0 as a possible end, which [`Number::lane`] tells; in others as a
    /// value of the interval.
    #[inline(always)]
    fn set_lane(&mut self, i: usize, value: S) {
        self.ends[0] = self.ends[0].lesser(value);
        self.ends[1] = self.ends[1].greater(value);
        if i > 0 {
            let x = value.to_f32();
            self.low = -larger(-self.low, -down(x));
            self.high = larger(self.high, up(x));
            self.worst = worse(self.worst, worse(self.low, self.high));
        }
    }
    /// Lane 0 is the lower end, every other one the upper end, of what was taken in.
    #[inline(always)]
    fn lane(&self, i: usize) -> S {
        self.ends[usize::from(i > 0)]
    }
    #[inline(never)]
    fn sqrt(self) -> Self {
        let root = |x: f32| libm::sqrtf(larger(x, 0.0));
        Self::rounded(down(root(self.low)), up(root(self.high)), [&self, &self])
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
    #[inline(never)]
    fn dot<const D: usize>(a: &[Self; D], b: &[Self; D]) -> Self {
        let mut sum = Self::between(0.0, 0.0);
        for (a, b) in a.iter().zip(b) {
            // The products are exact in double width: their sum alone has to fit.
            let (low, high) = a.products(b);
            let mut product = Self::between(low, high);
            product.worst = worse(a.worst, b.worst);
            sum += product;
        }
        Self::rounded(sum.low, sum.high, [&sum, &sum])
    }
    #[inline(never)]
    fn length_squared<const D: usize>(r: &[Self; D]) -> Self {
        let limit = S::REACH_LIMIT.to_f32();
        let near = r.map(|x| {
            let bounded = |x: f32| x.max(-limit).min(limit);
            Self::between(bounded(x.low), bounded(x.high))
        });
        Self::dot(&near, &near)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Q64;
    use fixed::types::extra::U32;

    type Wide = Q64<U32>;

    /// What 64 bits hold and `f32` does not lies within, after every operation.
    #[test]
    fn what_f32_rounds_is_within() {
        fn check(exact: Wide, of: Enclosure<Wide>) {
            let exact = exact.to_f64();
            let (low, high) = (f64::from(of.low), f64::from(of.high));
            assert!(low <= exact && exact <= high, "{exact} in {low} to {high}");
            assert!(f64::from(of.worst) >= exact.abs());
        }
        let values = [
            33_554_433.3,
            -16_777_217.7,
            1.000_000_06,
            -0.333_333_3,
            1e-9,
        ];
        let values = values.map(Wide::from_f64);
        let of = |x: Wide| Enclosure::<Wide>::splat(x);
        for a in values {
            check(a, of(a));
            check(-a, -of(a));
            check(Number::sqrt(a.abs()), of(a.abs()).sqrt());
            for b in values {
                check(a + b, of(a) + of(b));
                check(a - b, of(a) - of(b));
                check(Number::max(a, b), of(a).max(of(b)));
                check(Number::min(a, b), of(a).min(of(b)));
                if a.to_f64().abs() * b.to_f64().abs() < 2e9 {
                    check(a * b, of(a) * of(b));
                    check(a / b, of(a) / of(b));
                    let (x, y) = ([a, b], [b, a]);
                    let dot = Enclosure::dot(&x.map(of), &y.map(of));
                    check(Number::dot(&x, &y), dot);
                }
            }
        }
    }
}
