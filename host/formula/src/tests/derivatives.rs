//! Derivatives: against differences.

use crate::Scope;

#[test]
fn derivatives_are_the_limits_of_differences() {
    let mut scope = Scope::new(["x", "y"]);
    scope.define("r", "sqrt(x*x + y*y)").unwrap();
    // The central difference has an error of h² f‴/6 and one of rounding, 1e-16/h: 1e-10 of each.
    let h = 1e-5;
    for text in [
        "x*y - x/y + 3",
        "x^3*y^2",
        "x^y",
        "2^x",
        "x^2.5",
        "1/(1 + x^2)",
        "sin(x*y)*cos(x - y)",
        "tan(x)*tanh(y)",
        "asin(x/3) + acos(x/4) + atan(x*y)",
        "atan2(y, x)",
        "sinh(x) + cosh(x*y)",
        "exp(-x^2)*log(y) + log10(x)",
        "cbrt(x*y) + sqrt(x + y)",
        "erf(x*y)",
        "abs(x - 2*y)*x",
        "min(x^2, y)*max(x, y^3)",
        "if(x < y, x^2, y^2*x)",
        "(x*y % 1)*x",
        "floor(3*x)*x + ceil(y)*y + sign(x - y)*x",
        "exp(-r^2)*(r < 2)",
    ] {
        let formula = scope.formula(text).unwrap();
        for point in [[0.7, 1.3], [1.1, 0.4], [0.35, 0.9]] {
            for variable in 0..2 {
                let beside = |step: f64| {
                    let mut point = point;
                    point[variable] += step;
                    formula.at(&point)
                };
                let expected = (beside(h) - beside(-h)) / (2.0 * h);
                let found = formula.derivative(variable).at(&point);
                let error = (found - expected).abs();
                let bound = 2e-9 * (1.0 + expected.abs());
                assert!(
                    error < bound,
                    "d {text} / d {variable} at {point:?}: {found}, {expected}"
                );
            }
        }
    }
}

#[test]
fn a_distance_is_flat_at_its_centre() {
    let scope = Scope::new(["x", "y"]);
    let formula = scope.formula("sqrt(x*x + y*y)").unwrap();
    assert_eq!(formula.derivative(0).at(&[0.0, 0.0]), 0.0);
}

#[test]
fn the_derivative_of_a_constant_is_no_operation() {
    let scope = Scope::new(["x", "y"]);
    assert_eq!(
        scope.formula("3*y + 1").unwrap().derivative(0).value(),
        Some(0.0)
    );
    assert_eq!(
        scope.formula("3*x + y^2").unwrap().derivative(0).value(),
        Some(3.0)
    );
}
