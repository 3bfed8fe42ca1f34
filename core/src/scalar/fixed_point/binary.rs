//! Floats taken apart: what fixed-point numbers are made from without float arithmetic.

/// `±significand * 2^exponent`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Binary {
    pub is_negative: bool,
    pub significand: u64,
    pub exponent: i32,
}

macro_rules! taken_apart {
    ($name:ident, $float:ty, $unsigned:ty) => {
        /// The same number; one out of every range for an infinite one, `None` for NaN.
        #[inline(always)]
        pub const fn $name(value: $float) -> Option<Self> {
            const FRACTION: u32 = <$float>::MANTISSA_DIGITS - 1;
            const LEAST: i32 = <$float>::MIN_EXP - <$float>::MANTISSA_DIGITS as i32;
            const HIDDEN: $unsigned = 1 << FRACTION;
            // In bits: a comparison of floats is a call where there is no unit for them.
            let size = value.to_bits() << 1 >> 1;
            if size > <$float>::INFINITY.to_bits() {
                return None;
            }
            let (fraction, power) = (size & (HIDDEN - 1), (size >> FRACTION) as i32);
            let (significand, exponent) = if power == 0 {
                (fraction, LEAST)
            } else {
                (fraction | HIDDEN, LEAST + (power - 1))
            };
            Some(Self {
                is_negative: value.to_bits() != size,
                significand: significand as u64,
                exponent,
            })
        }
    };
}

impl Binary {
    taken_apart!(of_f64, f64, u64);
    taken_apart!(of_f32, f32, u32);

    /// `significand * 2^(exponent + power)`, rounded half up; saturates.
    #[inline(always)]
    pub const fn times_two_to(self, power: u32) -> u64 {
        let shift = self.exponent.saturating_add_unsigned(power);
        let places = shift.unsigned_abs();
        if shift < 0 {
            // One place less, then the half that rounds.
            match self.significand.checked_shr(places - 1) {
                Some(twice) => (twice >> 1) + (twice & 1),
                None => 0,
            }
        } else if places < self.significand.leading_zeros() {
            self.significand.wrapping_shl(places)
        } else if self.significand == 0 {
            0
        } else {
            u64::MAX
        }
    }
}
