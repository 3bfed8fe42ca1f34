//! The properties that (2.5) and (1.22) ask of every cut-off, in every dimension and scalar.

use approx::assert_abs_diff_eq;

use super::*;
use crate::scalar::{Micro, Q32, Q64};
use fixed::types::extra::{U19, U31};

const ALL: [Named; 10] = [
    Named::CubicSpline,
    Named::QuinticSpline,
    Named::WendlandC2,
    Named::WendlandC4,
    Named::WendlandC6,
    Named::RootFree,
    Named::QuinticSplineFour,
    Named::SmoothTwo,
    Named::SmoothFour,
    Named::SmoothSix,
];

/// `ζ(x)` and `dζ/dq`, normalised, at distance `q`.
fn zeta<S: Scalar, const D: usize>(cut_off: Named, q: f64) -> (f64, f64) {
    let a = cut_off.argument(S::from_f64(q) * S::from_f64(q));
    let sigma = cut_off.normalisation::<D>();
    let value = cut_off.value::<D, S>(a).to_f64();
    let slope = cut_off.gradient::<D, S>(a).to_f64() * q;
    (sigma * value, sigma * slope)
}

/// `∫ |x|^power ζ dx` over R^D by the midpoint rule.
fn moment<S: Scalar, const D: usize>(cut_off: Named, power: i32) -> f64 {
    let area = [
        2.0,
        2.0 * core::f64::consts::PI,
        4.0 * core::f64::consts::PI,
    ][D - 1];
    let n = 4000;
    let dq = f64::from(cut_off.support()) / f64::from(n);
    let ring = |i| {
        let q = (f64::from(i) + 0.5) * dq;
        q.powi(power + D as i32 - 1) * zeta::<S, D>(cut_off, q).0
    };
    area * dq * (0..n).map(ring).sum::<f64>()
}

/// Checks one scalar; `rounding` is the error of one operation in it.
fn check<S: Scalar, const D: usize>(rounding: f64) {
    for cut_off in ALL {
        let name = cut_off.name();
        let s = f64::from(cut_off.support());
        // The largest intermediate over the value at 0: 3^5 of the quintic spline.
        let bound = 243.0 * 8.0 * rounding + 2e-6;
        assert_abs_diff_eq!(moment::<S, D>(cut_off, 0), 1.0, epsilon = bound);

        // C1 at the edge and beyond: exactly nothing.
        for q in [s, s + 0.25, 4.0] {
            assert_eq!(zeta::<S, D>(cut_off, q), (0.0, 0.0), "{name} at {q}");
        }
        let (value, slope) = zeta::<S, D>(cut_off, s - 1e-3);
        assert!(
            value.abs() < 1e-4 + bound && slope.abs() < 1e-2 + bound,
            "{name}: {value} {slope}"
        );

        for i in 1..100 {
            let q = s * (f64::from(i) + 0.37) / 100.0;
            let d = 1e-2 * s;
            let (at, slope) = zeta::<S, D>(cut_off, q);
            assert!(
                cut_off.order() > 2 || at >= -bound && slope <= bound,
                "{name} falls from a positive value"
            );
            // The gradient is the derivative of the value: integrate it over a small step.
            let step: f64 = (0..20)
                .map(|j| zeta::<S, D>(cut_off, q - d + 2.0 * d * (f64::from(j) + 0.5) / 20.0).1)
                .sum::<f64>()
                * d
                / 10.0;
            let rise = zeta::<S, D>(cut_off, q + d).0 - zeta::<S, D>(cut_off, q - d).0;
            assert_abs_diff_eq!(rise, step, epsilon = bound + 1e-5);
        }
    }
}

macro_rules! every_dimension {
    ($name:ident, $scalar:ty, $rounding:expr) => {
        #[test]
        fn $name() {
            check::<$scalar, 1>($rounding);
            check::<$scalar, 2>($rounding);
            check::<$scalar, 3>($rounding);
        }
    };
}
every_dimension!(
    unit_integral_smooth_edge_and_derivative_in_f64,
    f64,
    1.2e-16
);
every_dimension!(unit_integral_smooth_edge_and_derivative_in_f32, f32, 6e-8);
every_dimension!(
    unit_integral_smooth_edge_and_derivative_in_q12_19,
    Q32<U19>,
    1e-6
);
every_dimension!(
    unit_integral_smooth_edge_and_derivative_in_q32_31,
    Q64<U31>,
    2.4e-10
);

#[test]
fn approximate_roots_move_the_integral_by_no_more_than_their_error() {
    // micromath's root is off by up to 6 %, on either side; the D-th power of it moves the volume.
    for cut_off in ALL {
        let off = moment::<Micro, 2>(cut_off, 0) - 1.0;
        assert!(off.abs() < 2.0 * 0.06, "{}: {off}", cut_off.name());
    }
    assert_abs_diff_eq!(moment::<Micro, 2>(Named::RootFree, 0), 1.0, epsilon = 1e-4);
}

/// The moment of `x₁` to the power `degree`: the mean of `cos^degree` over the sphere makes it
/// from the radial one.
fn directed<S: Scalar, const D: usize>(cut_off: Named, degree: i32) -> f64 {
    let mean = |j: i32| f64::from(2 * j - 1) / f64::from(2 * (j - 1) + D as i32);
    moment::<S, D>(cut_off, degree) * (1..=degree / 2).map(mean).product::<f64>()
}

/// Even functions have no odd moments; of the even ones those below the order vanish, and the
/// one of the order does not. `bound`: the rounding of the format in the largest of them.
fn order_is_as_stated<S: Scalar, const D: usize>(bound: f64) {
    for cut_off in ALL {
        let order = cut_off.order() as i32;
        let name = cut_off.name();
        for degree in (2..order).step_by(2) {
            let moment = directed::<S, D>(cut_off, degree);
            assert!(moment.abs() < bound, "{name} in {D}D, {degree}: {moment}");
        }
        let moment = directed::<S, D>(cut_off, order).abs();
        assert!((0.05..2.0).contains(&moment), "{name} in {D}D: {moment}");
    }
}

macro_rules! order_in {
    ($name:ident, $scalar:ty, $bound:expr) => {
        #[test]
        fn $name() {
            order_is_as_stated::<$scalar, 1>($bound);
            order_is_as_stated::<$scalar, 2>($bound);
            order_is_as_stated::<$scalar, 3>($bound);
        }
    };
}
order_in!(moments_vanish_up_to_the_order_in_f64, f64, 2e-5);
order_in!(moments_vanish_up_to_the_order_in_f32, f32, 1e-4);
order_in!(moments_vanish_up_to_the_order_in_q12_19, Q32<U19>, 2e-2);
order_in!(moments_vanish_up_to_the_order_in_q32_31, Q64<U31>, 2e-5);

/// `h Σ |Δʲ z|/hʲ` over the support and some more, `n < 256` points `h` apart: converges to the
/// integral of the `j`-th derivative if there is one.
fn variation(cut_off: Named, order: u32, n: usize) -> f64 {
    let s = f64::from(cut_off.support());
    let h = 2.4 * s / n as f64;
    let mut row = [0.0; 256];
    for (i, z) in row.iter_mut().enumerate().take(n) {
        *z = zeta::<f64, 1>(cut_off, (i as f64 * h - 1.2 * s).abs()).0;
    }
    let mut end = n;
    for _ in 0..order {
        end -= 1;
        for i in 0..end {
            row[i] = (row[i + 1] - row[i]) / h;
        }
    }
    row[..end].iter().map(|x| x.abs()).sum::<f64>() * h
}

/// The derivative of order `smoothness` is integrable and has jumps: that of the order after next
/// grows with every refinement.
#[test]
fn the_smoothness_is_as_stated_in_one_dimension() {
    for cut_off in ALL {
        let (name, smooth) = (cut_off.name(), cut_off.smoothness::<1>());
        let growth = |order| variation(cut_off, order, 240) / variation(cut_off, order, 120);
        assert!(growth(smooth) < 1.3, "{name}: {}", growth(smooth));
        let rough = growth(smooth + 2);
        assert!(rough > 1.6, "{name} is smoother than it says: {rough}");
    }
}

/// ζ depends on |x|² alone, so ζ(-x) = ζ(x) to the bit, whatever the displacement.
#[test]
fn every_cut_off_is_even_to_the_bit() {
    fn bits<S: Scalar>(cut_off: Named, x: [f64; 3], sign: f64) -> [u64; 2] {
        let r = x.map(|x| S::from_f64(sign * x));
        let a = cut_off.argument(S::length_squared(&r));
        [
            cut_off.value::<3, S>(a).bits(),
            cut_off.gradient::<3, S>(a).bits(),
        ]
    }
    for cut_off in ALL {
        for i in 0..50 {
            let x = [0.021 * f64::from(i), -0.013 * f64::from(i), 0.4];
            assert_eq!(bits::<f32>(cut_off, x, 1.0), bits::<f32>(cut_off, x, -1.0));
            assert_eq!(bits::<f64>(cut_off, x, 1.0), bits::<f64>(cut_off, x, -1.0));
            assert_eq!(
                bits::<Q32<U19>>(cut_off, x, 1.0),
                bits::<Q32<U19>>(cut_off, x, -1.0)
            );
            assert_eq!(
                bits::<Q64<U31>>(cut_off, x, 1.0),
                bits::<Q64<U31>>(cut_off, x, -1.0)
            );
            assert_eq!(
                bits::<Micro>(cut_off, x, 1.0),
                bits::<Micro>(cut_off, x, -1.0)
            );
        }
    }
}

#[test]
fn the_curvature_is_the_derivative_of_the_slope() {
    fn check<const D: usize>(cut_off: Named) {
        let s = f64::from(cut_off.support());
        let slope = |q: f64| cut_off.gradient::<D, f64>(cut_off.argument(q * q)) * q;
        for i in 1..50 {
            let (q, d) = (s * (f64::from(i) + 0.21) / 50.0, 1e-5);
            let expected = (slope(q + d) - slope(q - d)) / (2.0 * d);
            let curvature = cut_off.curvature::<D, f64>(cut_off.argument(q * q));
            assert_abs_diff_eq!(curvature, expected, epsilon = 1e-5 * (1.0 + expected.abs()));
        }
    }
    for cut_off in ALL {
        check::<1>(cut_off);
        check::<2>(cut_off);
        check::<3>(cut_off);
    }
}

/// `2 ∫ ζ̄ dq = 1`, and on a line it is the cut-off itself.
#[test]
fn the_integral_across_a_direction_has_integral_one() {
    fn integral<const D: usize>(cut_off: Named) -> f64 {
        let width = f64::from(cut_off.support()) / 64.0;
        let places = (0..64).map(|i| width * (f64::from(i) + 0.5));
        2.0 * width * places.map(|q| across::<f64, _, D>(cut_off, q)).sum::<f64>()
    }
    for cut_off in ALL {
        for (integral, dimension) in [
            (integral::<1>(cut_off), 1),
            (integral::<2>(cut_off), 2),
            (integral::<3>(cut_off), 3),
        ] {
            assert!(
                (integral - 1.0).abs() < 1e-4,
                "{cut_off:?} in {dimension}D: {integral}"
            );
        }
        let at = across::<f64, _, 1>(cut_off, 0.7);
        assert_abs_diff_eq!(at, zeta::<f64, 1>(cut_off, 0.7).0, epsilon = 1e-15);
    }
}

#[test]
fn names_lead_back_to_their_cut_offs() {
    for name in Named::NAMES {
        assert_eq!(Named::from_name(name).map(Named::name), Some(*name));
    }
    assert_eq!(Named::from_name("gauss"), None);
}
