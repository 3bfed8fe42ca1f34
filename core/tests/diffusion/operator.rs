//! The operator (4.5) alone.

use motes_core::cutoff::{CutOff, Named};
use motes_core::scalar::Scalar;

use crate::clouds::order;

/// The largest error of (4.5) on `u = x exp(-x²)`, b = 1, at 400 points of [-1, 1], on a lattice of
/// `n` points over [-2, 2]. Positions are moved by `shift` spacings.
fn operator_error<S: Scalar>(cut_off: Named, n: usize, ratio: f64, shift: f64) -> f64 {
    let errors = operator_errors::<S>(cut_off, n, ratio, shift);
    errors
        .iter()
        .fold(0.0, |worst, error| worst.max(error.abs()))
}

/// All of them.
fn operator_errors<S: Scalar>(cut_off: Named, n: usize, ratio: f64, shift: f64) -> Vec<f64> {
    let h = 4.0 / n as f64;
    let u = |x: f64| x * (-x * x).exp();
    let exact = |x: f64| (4.0 * x * x * x - 6.0 * x) * (-x * x).exp();
    let epsilon = S::from_f64(ratio);
    let height = S::from_f64(cut_off.normalisation::<1>()) / epsilon;
    let scale = cut_off.scale(S::ONE / epsilon);
    let nodes: Vec<(S, S)> = (0..n)
        .map(|k| {
            let x = k as f64 + 0.5 - 0.5 * n as f64;
            (S::from_f64(x + shift), S::from_f64(u(x * h)))
        })
        .collect();
    let error = |i: u32| {
        let x = -1.0 + 2.0 * f64::from(i) / 399.0;
        // The point as the format has it.
        let place = S::from_f64(x / h + shift);
        let x = (place.to_f64() - shift) * h;
        let here = S::from_f64(u(x));
        let mut sum = S::ZERO;
        for &(position, value) in &nodes {
            let r = place - position;
            let a = cut_off.argument(r * r) * scale;
            let bracket = -(height * cut_off.gradient::<1, S>(a));
            sum += bracket * ((value - here) + (value - here));
        }
        let operator = (sum / epsilon / epsilon).to_f64() / (h * h);
        operator - exact(x)
    };
    (0..400).map(error).collect()
}

#[test]
fn the_operator_has_the_order_of_its_cut_off() {
    for (cut_off, ratio, bound, expected) in [
        (Named::QuinticSpline, 2.0, 2.2e-3, 2.0),
        // Splines with knots on the lattice have no error of quadrature: the order is ε⁴ alone.
        (Named::QuinticSplineFour, 2.0, 2.4e-6, 4.0),
    ] {
        let errors = [125, 250, 500].map(|n| operator_error::<f64>(cut_off, n, ratio, 0.0));
        assert!(errors[1] <= bound, "{cut_off:?}: {errors:?}");
        for pair in errors.windows(2) {
            let order = order(pair[0], pair[1]);
            assert!(
                (order - expected).abs() < 0.2,
                "{cut_off:?}: {errors:?}, order {order}"
            );
        }
    }
}

/// In f32 nothing comes to the error of the formula but the rounding of `u` itself, `4 u max|u|/ε²`;
/// positions are differences, and a shift of all by 10^4 spacings changes nothing.
#[test]
fn single_precision_is_as_good_as_the_rounding_of_the_field() {
    for n in [125, 250, 500, 1000] {
        let truncation = operator_error::<f64>(Named::QuinticSpline, n, 2.0, 0.0);
        let epsilon = 2.0 * 4.0 / n as f64;
        let rounding = 4.0 * 2f64.powi(-24) * 0.43 / (epsilon * epsilon);
        for shift in [0.0, 1e4] {
            let error = operator_error::<f32>(Named::QuinticSpline, n, 2.0, shift);
            assert!(error <= truncation + rounding, "{n} {shift}: {error}");
        }
    }
}

/// What rounding leaves in f64: three widths of order 4 make order 8 (Richardson), and what is left
/// of the error is the rounding of `u` over ε² alone. One width has more of either.
#[test]
fn the_floor_of_double_precision_is_below_1e_11() {
    let floor = [1024, 2048, 4096].map(|n| {
        let [narrow, middle, wide] = [6.0, 12.0, 24.0]
            .map(|ratio| operator_errors::<f64>(Named::QuinticSplineFour, n, ratio, 0.0));
        let rows = narrow.iter().zip(&middle).zip(&wide);
        rows.fold(0.0f64, |worst, ((narrow, middle), wide)| {
            let fine = (16.0 * narrow - middle) / 15.0;
            let coarse = (16.0 * middle - wide) / 15.0;
            worst.max(((64.0 * fine - coarse) / 63.0).abs())
        })
    });
    println!("largest error at N = 1024, 2048, 4096: {floor:?}");
    assert!(floor[1] < 1e-11, "{floor:?}");
    // On both sides of it: the formula is off on the left, rounding on the right.
    assert!(
        floor[0] > floor[1] && floor[2] > floor[1],
        "no floor: {floor:?}"
    );
}
