//! Fixed point against exact rational arithmetic; lanes against scalars.

mod conversions;

use fixed::types::extra::{U8, U19, U31};
use proptest::prelude::*;

use super::*;

type Q12_19 = Q32<U19>;
type Q31_32 = Q64<fixed::types::extra::U32>;

/// `product / 2^F` rounded half away from zero, in arithmetic that cannot overflow.
fn rounded(product: i128, fraction: u32) -> i128 {
    let half = 1i128 << (fraction - 1);
    ((product.abs() + half) >> fraction) * product.signum()
}

proptest! {
    #[test]
    fn products_round_half_away_from_zero(a in -(1i32 << 24)..1 << 24, b in -(1i32 << 24)..1 << 24) {
        let product = Q12_19::from_bits(a) * Q12_19::from_bits(b);
        prop_assert_eq!(i128::from(product.to_bits()), rounded(i128::from(a) * i128::from(b), 19));
        let (a, b) = (i64::from(a) << 10, i64::from(b) << 10);
        let product = Q31_32::from_bits(a) * Q31_32::from_bits(b);
        prop_assert_eq!(i128::from(product.to_bits()), rounded(i128::from(a) * i128::from(b), 32));
    }

    #[test]
    fn a_change_of_sign_is_exact_in_every_operation(a: i32, b: i32) {
        let (x, y) = (Q12_19::from_bits(a), Q12_19::from_bits(b));
        prop_assert_eq!((-x) * y, -(x * y));
        prop_assert_eq!(x * (-y), -(x * y));
        prop_assert_eq!((-x) / y, -(x / y));
        prop_assert_eq!((-x).half(), -(x.half()));
        prop_assert_eq!(Q12_19::dot(&[-x, -y], &[y, y]), -Q12_19::dot(&[x, y], &[y, y]));
    }

    #[test]
    fn quotients_round_to_nearest_and_saturate(a: i32, b: i32) {
        prop_assume!(b != 0);
        let quotient = i128::from((Q12_19::from_bits(a) / Q12_19::from_bits(b)).to_bits());
        let (num, den) = ((i128::from(a) << 19).abs(), i128::from(b).abs());
        let sign = if (a < 0) == (b < 0) { 1 } else { -1 };
        let expected = ((2 * num + den) / (2 * den)).min(i128::from(i32::MAX)) * sign;
        // den/2 is floored for odd denominators: no tie exists there, so nothing is lost.
        prop_assert_eq!(quotient, expected);
    }

    #[test]
    fn roots_are_the_integer_roots(a in 0..i32::MAX) {
        let root = i128::from(Q12_19::from_bits(a).sqrt().to_bits());
        let square = i128::from(a) << 19;
        prop_assert!(root * root <= square && (root + 1) * (root + 1) > square);
    }

    #[test]
    fn a_dot_product_is_rounded_once(a in any::<[i16; 3]>(), b in any::<[i16; 3]>()) {
        let vector = |v: [i16; 3]| v.map(|x| Q32::<U8>::from_bits(i32::from(x)));
        let exact: i128 = (0..3).map(|i| i128::from(a[i]) * i128::from(b[i])).sum();
        let dot = Q32::<U8>::dot(&vector(a), &vector(b));
        prop_assert_eq!(i128::from(dot.to_bits()), rounded(exact, 8));
    }

    #[test]
    fn squared_lengths_never_wrap(a in any::<[i32; 3]>()) {
        let length = Q12_19::length_squared(&a.map(Q12_19::from_bits));
        let limit = i128::from(Q12_19::REACH_LIMIT.to_bits());
        let near = a.iter().all(|&x| i128::from(x).abs() <= limit);
        let exact: i128 = a.iter().map(|&x| i128::from(x) * i128::from(x)).sum();
        prop_assert!(length >= Q12_19::ZERO);
        if near {
            prop_assert_eq!(i128::from(length.to_bits()), rounded(exact, 19));
        } else {
            prop_assert!(i128::from(length.to_bits()) >= rounded(limit * limit, 19));
        }
    }

    #[test]
    fn lanes_do_what_their_scalar_does(a in any::<[f32; 5]>(), b in any::<[f32; 5]>()) {
        let (x, y) = (Lanes(a), Lanes(b));
        type Operation = fn(f32, f32) -> f32;
        let pairs: [(Lanes<f32, 5>, Operation); 7] = [
            (x + y, |a, b| a + b), (x - y, |a, b| a - b), (x * y, |a, b| a * b),
            (x / y, |a, b| a / b), (x.min(y), Number::min), (x.max(y), Number::max),
            (x.below(y), Number::below),
        ];
        for (lanes, scalar) in pairs {
            for i in 0..5 {
                prop_assert_eq!(lanes.lane(i).to_bits(), scalar(a[i], b[i]).to_bits());
            }
        }
    }

    #[test]
    fn a_checked_scalar_has_the_same_bits_and_marks_overflow(a: i32, b: i32) {
        let (x, y) = (Q12_19::from_bits(a), Q12_19::from_bits(b));
        let (p, q) = (Checked::new(x), Checked::new(y));
        let marks = |value: f64| value.abs() >= 4096.0;
        for (checked, plain, exact) in [
            (p + q, x + y, x.to_f64() + y.to_f64()),
            (p - q, x - y, x.to_f64() - y.to_f64()),
            (p * q, x * y, x.to_f64() * y.to_f64()),
        ] {
            prop_assert_eq!(checked.value, plain);
            // Within one rounding of the limit either answer is right.
            if (exact.abs() - 4096.0).abs() > 1e-5 {
                prop_assert_eq!(checked.overflowed, marks(exact), "{} of {:?}", exact, plain);
            }
        }
        let poisoned = (p * q) - (p * q);
        prop_assert_eq!(poisoned.overflowed, (p * q).overflowed);
    }
}

#[test]
fn constants_are_the_nearest_numbers() {
    assert_eq!(Q12_19::from_f64(1.0 / 3.0).to_bits(), 174_763);
    assert_eq!(Q12_19::from_f64(-1.0 / 3.0).to_bits(), -174_763);
    assert_eq!(Q12_19::from_f64(1e9).to_bits(), i32::MAX);
    assert_eq!(Q64::<U31>::from_f64(0.5).to_bits(), 1 << 30);
    assert_eq!(Q12_19::ONE.to_f64(), 1.0);
    assert_eq!(f32::from_f64(0.1), 0.1f32);
}

#[test]
fn a_division_by_nothing_saturates() {
    let big = Q12_19::from_bits(i32::MAX);
    assert_eq!(Q12_19::ONE / Q12_19::ZERO, big);
    assert_eq!(-Q12_19::ONE / Q12_19::ZERO, -big);
    assert_eq!(Q12_19::ZERO / Q12_19::ZERO, Q12_19::ZERO);
}

#[test]
fn cell_indices_are_floors_and_never_negative() {
    assert_eq!(Scalar::cells(7.9f32, 2.0), 3);
    assert_eq!(Scalar::cells(-1.0f64, 2.0), 0);
    assert_eq!(Scalar::cells(f32::NAN, 2.0), 0);
    assert_eq!(Q12_19::from_f64(7.9).cells(Q12_19::from_f64(2.0)), 3);
    assert_eq!(Q12_19::from_f64(-7.9).cells(Q12_19::from_f64(2.0)), 0);
    assert_eq!(Q12_19::ONE.cells(Q12_19::ZERO), 0);
}

/// Why the product is our own: the crate's rounds down, ours cancels.
#[test]
fn the_crates_own_product_would_not_conserve() {
    let (a, b) = (
        fixed::FixedI32::<U19>::from_bits(3),
        fixed::FixedI32::<U19>::from_bits(5),
    );
    assert_ne!((-a) * b, -(a * b));
}

#[test]
fn the_approximate_root_is_within_six_per_cent() {
    let mut worst = 0.0f64;
    for i in 1..10_000 {
        let x = 1e-3 * i as f32;
        worst = worst.max((Micro(x).sqrt().to_f64() / f64::from(x).sqrt() - 1.0).abs());
    }
    // Two-sided: if it became exact it would no longer be the approximate scalar.
    assert!((0.01..0.07).contains(&worst), "{worst}");
    assert_eq!(Micro(0.0).sqrt().0, 0.0);
}

#[test]
fn sines_are_those_of_the_library_to_the_rounding_of_the_format() {
    fn worst<S: Scalar>() -> f64 {
        let errors = (-400..=400).map(|i| {
            let turns = f64::from(i) * 0.003_717;
            let x = S::from_f64(turns);
            let angle = core::f64::consts::TAU * x.to_f64();
            let sine = sine_of_turns(x).to_f64() - libm::sin(angle);
            let cosine = cosine_of_turns(x).to_f64() - libm::cos(angle);
            sine.abs().max(cosine.abs())
        });
        errors.fold(0.0, f64::max)
    }
    assert!(worst::<f64>() < 4e-15, "{}", worst::<f64>());
    assert!(worst::<f32>() < 1e-6, "{}", worst::<f32>());
    // Ten roundings of 2^-20.
    assert!(worst::<Q32<U19>>() < 1e-5, "{}", worst::<Q32<U19>>());
    assert!(worst::<Q31_32>() < 2e-9, "{}", worst::<Q31_32>());
    for quarter in 0..8 {
        let exact = [0.0, 1.0, 0.0, -1.0][quarter % 4];
        assert_eq!(sine_of_turns(0.25 * quarter as f64), exact);
    }
}
