//! Values: against Rust's own arithmetic.

use std::f64::consts::PI;

use proptest::prelude::*;

use crate::{Formula, Scope};

/// The value of a formula of x and y at (0.5, -2).
fn value(text: &str) -> f64 {
    formula(text).at(&[0.5, -2.0])
}

fn formula(text: &str) -> Formula {
    let read = Scope::new(["x", "y"]).formula(text);
    read.unwrap_or_else(|error| panic!("{text}: {error}"))
}

#[test]
fn precedence_is_that_of_mathematics() {
    for (text, expected) in [
        ("1 + 2*3", 7.0),
        ("(1 + 2)*3", 9.0),
        ("-2^2", -4.0),
        ("(-2)^2", 4.0),
        ("2^-1", 0.5),
        ("2^3^2", 512.0),
        ("2**3", 8.0),
        ("6/2/3", 1.0),
        ("6 - 2 - 3", 1.0),
        ("-x^2*y", 0.5),
        ("1 - -x", 1.5),
        ("7 % 4", 3.0),
        ("-1 % 4", 3.0),
        ("1 < 2 && 2 < 1 || 1 == 1", 1.0),
        ("!(x > 0)", 0.0),
        ("x != 0.5", 0.0),
        ("1 + (x >= 0.5)", 2.0),
        ("1e3 + 1.5e-1 + .5 + 2.", 1002.65),
    ] {
        assert_eq!(value(text), expected, "{text}");
    }
}

#[test]
fn functions_are_those_of_their_names() {
    for (text, expected) in [
        ("abs(y)", 2.0),
        ("sqrt(x)", 0.5f64.sqrt()),
        ("min(x, y)", -2.0),
        ("max(x, y, 3)", 3.0),
        ("if(x < 1, 10, 20)", 10.0),
        ("if(x > 1, 10, 20)", 20.0),
        ("floor(y - 0.5)", -3.0),
        ("ceil(y + 0.5)", -1.0),
        ("sign(y)", -1.0),
        ("sign(0*y)", 0.0),
        ("sin(pi*x)", libm::sin(PI * 0.5)),
        ("cos(y)", libm::cos(-2.0)),
        ("tan(x)", libm::tan(0.5)),
        ("asin(x)", libm::asin(0.5)),
        ("acos(x)", libm::acos(0.5)),
        ("atan(y)", libm::atan(-2.0)),
        ("atan2(y, x)", libm::atan2(-2.0, 0.5)),
        ("sinh(x)", libm::sinh(0.5)),
        ("cosh(x)", libm::cosh(0.5)),
        ("tanh(x)", libm::tanh(0.5)),
        ("exp(y)", libm::exp(-2.0)),
        ("log(x)", libm::log(0.5)),
        ("log10(x)", libm::log10(0.5)),
        ("cbrt(y)", libm::cbrt(-2.0)),
        ("erf(x)", libm::erf(0.5)),
        ("x^2.5", libm::pow(0.5, 2.5)),
        ("y^3", -8.0),
    ] {
        assert_eq!(value(text), expected, "{text}");
    }
}

#[test]
fn definitions_may_use_each_other_in_any_order() {
    let mut scope = Scope::new(["x"]);
    for (head, text) in [
        ("c(s)", "layer(s, 1, height)"),
        ("layer(x, low, high)", "if(x < 0.5, low, high)"),
        ("height", "2*half + x"),
        ("half", "0.5"),
    ] {
        scope.define(head, text).unwrap();
    }
    scope.check().unwrap();
    let formula = scope.formula("c(x + 0.4)^2").unwrap();
    // Inside `layer` x is its argument; `height` sees the place.
    assert_eq!(formula.at(&[0.0]), 1.0);
    assert_eq!(formula.at(&[0.2]), 1.2 * 1.2);
}

#[test]
fn what_is_known_is_worked_out_while_reading() {
    assert_eq!(formula("2*pi/4 + 0*x").value(), Some(PI / 2.0));
    assert_eq!(formula("x").value(), None);
    assert!(formula("1 + y").depends_on(1) && !formula("1 + y").depends_on(0));
}

#[test]
fn a_repeated_part_is_worked_out_once() {
    let mut scope = Scope::new(["x"]);
    // Doubles thirty times: 2^30 operations if parts were not shared.
    scope.define("f0(s)", "s + sin(s)").unwrap();
    for i in 1..=30 {
        let head = format!("f{i}(s)");
        scope
            .define(&head, &format!("f{}(s) + f{}(s)", i - 1, i - 1))
            .unwrap();
    }
    let formula = scope.formula("f30(x)").unwrap();
    assert_eq!(
        formula.at(&[1.0]),
        (1.0 + libm::sin(1.0)) * f64::from(1 << 30)
    );
}

#[test]
fn a_nan_is_not_hidden() {
    assert!(value("min(sqrt(y), 1)").is_nan());
    assert!(value("max(sqrt(y), 1)").is_nan());
}

/// A random formula of x and y, with its value at a point.
fn random() -> impl Strategy<Value = (String, fn_of::Boxed)> {
    let leaf = prop_oneof![
        Just(("x".to_owned(), fn_of::boxed(|x, _| x))),
        Just(("y".to_owned(), fn_of::boxed(|_, y| y))),
        (1u32..100).prop_map(|n| {
            let value = f64::from(n) / 8.0;
            (value.to_string(), fn_of::boxed(move |_, _| value))
        }),
    ];
    leaf.prop_recursive(5, 40, 2, |inner| {
        (inner.clone(), inner, 0usize..7).prop_map(|((a_text, a), (b_text, b), kind)| match kind {
            0 => (
                format!("({a_text} + {b_text})"),
                fn_of::boxed(move |x, y| a(x, y) + b(x, y)),
            ),
            1 => (
                format!("({a_text} - {b_text})"),
                fn_of::boxed(move |x, y| a(x, y) - b(x, y)),
            ),
            2 => (
                format!("({a_text})*({b_text})"),
                fn_of::boxed(move |x, y| a(x, y) * b(x, y)),
            ),
            3 => (
                format!("(({a_text})/(1 + ({b_text})^2))"),
                fn_of::boxed(move |x, y| {
                    let b = b(x, y);
                    a(x, y) / (1.0 + b * b)
                }),
            ),
            4 => (
                format!("sin({a_text})"),
                fn_of::boxed(move |x, y| libm::sin(a(x, y))),
            ),
            5 => (
                format!("if({a_text} < {b_text}, {a_text}, 1)"),
                fn_of::boxed(move |x, y| {
                    let (a, b) = (a(x, y), b(x, y));
                    if a < b { a } else { 1.0 }
                }),
            ),
            _ => (
                format!("max({a_text}, {b_text})"),
                fn_of::boxed(move |x, y| {
                    let (a, b) = (a(x, y), b(x, y));
                    if a > b { a } else { b }
                }),
            ),
        })
    })
}

/// Functions of two numbers that can be cloned.
mod fn_of {
    use std::sync::Arc;

    #[derive(Clone)]
    pub struct Boxed(Arc<dyn Fn(f64, f64) -> f64>);

    pub fn boxed(of: impl Fn(f64, f64) -> f64 + 'static) -> Boxed {
        Boxed(Arc::new(of))
    }

    impl std::ops::Deref for Boxed {
        type Target = dyn Fn(f64, f64) -> f64;
        fn deref(&self) -> &Self::Target {
            &*self.0
        }
    }

    impl std::fmt::Debug for Boxed {
        fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
            formatter.write_str("a function")
        }
    }
}

proptest! {
    #[test]
    fn a_formula_has_the_value_of_what_it_says((text, of) in random(), x in -3.0f64..3.0, y in -3.0f64..3.0) {
        let (found, expected) = (formula(&text).at(&[x, y]), of(x, y));
        prop_assert!(found == expected, "{text} at ({x}, {y}): {found}, expected {expected}");
    }

    #[test]
    fn many_points_have_the_bits_of_one((text, _) in random(), xs in prop::collection::vec(-3.0f64..3.0, 1..200), y in -3.0f64..3.0) {
        let formula = formula(&text);
        let mut values = vec![0.0; xs.len()];
        formula.write(&[&xs, &[y]], &mut values);
        for (x, value) in xs.iter().zip(&values) {
            prop_assert_eq!(value.to_bits(), formula.at(&[*x, y]).to_bits(), "{} at {}", text, x);
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "[-+*/^()<>=&|!,.%a-z0-9 é]{0,60}") {
        let _ = Scope::new(["x", "y"]).formula(&text);
    }
}
