//! Scalars from other numbers and from bits.

use std::fmt::Debug;

use fixed::types::extra::{U16, U19, U32, U55};
use proptest::prelude::*;

use crate::scalar::{Checked, Micro, Q32, Q64, Scalar};

type Q12_19 = Q32<U19>;
type Q15_16 = Q32<U16>;
type Q31_32 = Q64<U32>;

/// Each takes a test with one scalar.
macro_rules! for_every_scalar {
    ($test:ident($($argument:expr),*)) => {
        $test::<f32>($($argument),*)?;
        $test::<f64>($($argument),*)?;
        $test::<Micro>($($argument),*)?;
        $test::<Q15_16>($($argument),*)?;
        $test::<Q12_19>($($argument),*)?;
        $test::<Q31_32>($($argument),*)?;
        $test::<Q64<U55>>($($argument),*)?;
        $test::<Checked<Q12_19>>($($argument),*)?;
        $test::<Checked<f32>>($($argument),*)?;
    };
}

fn bits_return<S: Scalar>(bits: u64) -> Result<(), TestCaseError> {
    let unused = 64 - 8 * S::BYTES;
    prop_assert_eq!(S::from_bits(bits).bits(), bits << unused >> unused);
    Ok(())
}

fn all_ways_agree<S: Scalar>(value: f32, n: i32) -> Result<(), TestCaseError> {
    prop_assert_eq!(S::from_f32(value).bits(), S::from_f64(value.into()).bits());
    prop_assert_eq!(S::from_i32(n).bits(), S::from_f64(n.into()).bits());
    let count = n.unsigned_abs() >> 1;
    prop_assert_eq!(S::from_i32(count as i32).bits(), S::count(count).bits());
    Ok(())
}

/// Any `f64`, and as many near 1 as far from it.
fn any_number() -> impl Strategy<Value = f64> {
    let bits = any::<u64>().prop_map(f64::from_bits);
    let near = (any::<i64>(), 0..80).prop_map(|(n, k)| n as f64 / (1u128 << k) as f64);
    // Halves of the last place: the ties.
    let ties = any::<i32>().prop_map(|n| f64::from(n) / f64::from(1u32 << 20));
    prop_oneof![bits, near, ties]
}

proptest! {
    #[test]
    fn a_scalar_is_what_its_bits_say(bits: u64) {
        for_every_scalar!(bits_return(bits));
    }

    #[test]
    fn the_same_number_gives_the_same_bits_however_it_is_written(bits: u32, n: i32) {
        // NaN has many patterns, of which casts may give any.
        let value = f32::from_bits(bits);
        let value = if value.is_nan() { 0.0 } else { value };
        for_every_scalar!(all_ways_agree(value, n));
        for_every_scalar!(all_ways_agree(n as f32 / 65536.0, n >> 16));
    }

    #[test]
    fn fixed_point_takes_the_nearest_number_half_away_from_zero(value in any_number()) {
        // Powers of 2 are exact, `as` saturates, `round` has ties away from zero.
        let scaled = |fraction: u32| libm::round(value * (1u128 << fraction) as f64);
        prop_assert_eq!(Q15_16::from_f64(value).to_bits(), scaled(16) as i32);
        prop_assert_eq!(Q12_19::from_f64(value).to_bits(), scaled(19) as i32);
        prop_assert_eq!(Q31_32::from_f64(value).to_bits(), scaled(32) as i64);
        prop_assert_eq!(Q64::<U55>::from_f64(value).to_bits(), scaled(55) as i64);
    }

    #[test]
    fn a_number_of_a_format_survives_f64(bits: i32) {
        prop_assert_eq!(Q12_19::from_f64(Q12_19::from_bits(bits).to_f64()).to_bits(), bits);
        let wide = i64::from(bits) << 20;
        prop_assert_eq!(Q31_32::from_f64(Q31_32::from_bits(wide).to_f64()).to_bits(), wide);
    }
}

#[test]
fn what_is_beyond_the_range_becomes_its_end() {
    for far in [f32::INFINITY, f32::MAX, 4096.0, 4_095.999_9] {
        assert_eq!(Q12_19::from_f32(far).to_bits(), i32::MAX, "{far}");
        assert_eq!(Q12_19::from_f64(far.into()).to_bits(), i32::MAX, "{far}");
    }
    for far in [f32::NEG_INFINITY, f32::MIN, -4096.0] {
        assert_eq!(Q12_19::from_f32(far).to_bits(), i32::MIN, "{far}");
    }
    assert_eq!(Q12_19::from_i32(4096).to_bits(), i32::MAX);
    assert_eq!(Q12_19::from_i32(-4097).to_bits(), i32::MIN);
    assert_eq!(Q31_32::from_i32(i32::MIN).to_bits(), i64::MIN);
    assert_eq!(Q31_32::from_f64(1e300).to_bits(), i64::MAX);
}

#[test]
fn next_to_half_of_the_last_place_is_nothing() {
    // A sum with 1/2 in f64 would round up to 1 here, and off by 1 below.
    let half = 0.5f64.next_down();
    assert_eq!(Q64::<U32>::from_f64(half / 4_294_967_296.0).to_bits(), 0);
    let odd = (1i64 << 52) + 1;
    let number = odd as f64 / 4_294_967_296.0;
    assert_eq!(Q31_32::from_f64(number).to_bits(), odd);
}

#[test]
fn zeros_keep_their_sign_in_floats_and_have_none_in_fixed_point() {
    fn zero<S: Scalar + Debug>(bits: u64) {
        assert_eq!(S::from_f64(-0.0).bits(), bits);
        assert_eq!(S::from_f32(-0.0).bits(), bits);
        assert_eq!(S::from_i32(0).bits(), 0);
        assert_eq!(S::from_bits(0), S::ZERO);
    }
    zero::<f32>(1 << 31);
    zero::<f64>(1 << 63);
    zero::<Micro>(1 << 31);
    zero::<Q12_19>(0);
    zero::<Q31_32>(0);
    zero::<Checked<Q12_19>>(0);
}

#[test]
fn what_is_not_a_number_is_not_finite_or_nothing() {
    assert!(f32::from_f64(f64::NAN).is_nan());
    assert!(<f64 as Scalar>::from_f32(f32::NAN).is_nan());
    assert!(!Scalar::is_finite(Micro::from_f32(f32::NAN)));
    assert_eq!(Q12_19::from_f64(-f64::NAN), Q12_19::ZERO);
    assert_eq!(Q31_32::from_f32(f32::NAN), Q31_32::ZERO);
}

#[test]
fn a_checked_scalar_is_marked_where_it_does_not_hold_the_number() {
    type Marked = Checked<Q12_19>;
    assert!(Marked::from_f32(5e3).overflowed);
    assert!(Marked::from_i32(-5000).overflowed);
    assert!(Marked::from_f64(f64::NAN).overflowed);
    assert!(!Marked::from_f32(4e3).overflowed);
    assert!(!Marked::from_i32(-4000).overflowed);
    assert!(!Marked::from_bits(Marked::from_i32(5000).bits()).overflowed);
}
