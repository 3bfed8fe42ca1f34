//! Formulas as Rust source: the same bits. `printed.rs` is what is written of the formulas below, as the
//! compiler reads it. This makes it anew:
//!
//!     cargo test -p motes-formula --lib -- --ignored print

use std::fs::{read_to_string, write};

use super::printed::PRINTED;
use crate::{Formula, Scope};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/src/tests/printed.rs");

/// Formulas of x, y and t: every sign, every function, how tightly signs hold, what is used twice,
/// and what is longer than a line.
const TEXTS: [&str; 54] = [
    "x",
    "3",
    "-x",
    "-2*x - -y",
    "x + y - t",
    "x - (y + t)",
    "x - (y - t)",
    "x*y/t",
    "x/(y*t)",
    "x/(y/t)",
    "(x + y)*(x - t)",
    "-(x + y)*t",
    "(-x)^2 - x^2",
    "2^x^y",
    "x^-3 + y^7 + t^0.5 + x^y",
    "x % 1 + y % -3 + x % t",
    "x < y",
    "x <= y",
    "x > y",
    "x >= y",
    "x == y",
    "x != y",
    "x < y && y < t",
    "x < y || y < t",
    "!(x - y)",
    "if(x < y + t, x*t, y - 1)",
    "if(x, y, t)",
    "min(x, y, t)",
    "max(x, y, t)",
    "atan2(y, x)",
    "abs(x)",
    "acos(x)",
    "asin(x)",
    "atan(x)",
    "cbrt(x)",
    "ceil(x)",
    "cos(x)",
    "cosh(x)",
    "erf(x)",
    "exp(x)",
    "floor(x)",
    "log(x)",
    "log10(x)",
    "sign(x)",
    "sin(x)",
    "sinh(x)",
    "sqrt(x)",
    "tan(x)",
    "tanh(x)",
    "2*pi*x + pi*y + 1e300*t + 1e-300",
    "sin(x + y)^2 + cos(x + y)^2 - 1/(x + y)",
    "exp(-((x - 0.25)^2 + (y - 0.75)^2)/0.02)*cos(2*pi*(x - y - t)) + 0.1*tanh((x + y)/0.05)*exp(-t)",
    "wave(x - t) + wave(x + t)*wave(y)",
    "sin(y - 2*x)*sin(t - x)",
];

fn formulas() -> Vec<Formula> {
    let mut scope = Scope::new(["x", "y", "t"]);
    scope.define("k", "2*pi").unwrap();
    scope
        .define("wave(s)", "if(s < 0, 0, sin(k*s)/(1 + s^2))")
        .unwrap();
    let mut formulas: Vec<Formula> = TEXTS.map(|text| scope.formula(text).unwrap()).into();
    let steep = [49, 50, 51, 52, 53].map(|i: usize| formulas[i].derivative(0));
    formulas.extend(steep);
    formulas
}

fn source() -> String {
    let formulas = formulas();
    let mut text = format!(
        "//! Made by rust.rs, not by hand.

use crate::elementary;

/// The value of a formula at x, y and t.
type Value = fn([f64; 3]) -> f64;

/// What is written of each formula.
pub const PRINTED: [Value; {}] = [\n",
        formulas.len()
    );
    for formula in formulas {
        let variables = ["x", "y", "t"];
        let used = |i: usize| {
            if formula.depends_on(i) {
                variables[i]
            } else {
                "_"
            }
        };
        let pattern: Vec<&str> = (0..3).map(used).collect();
        let value = formula.rust(&variables, 4);
        text += &format!("    |[{}]| {value},\n", pattern.join(", "));
    }
    text + "];\n"
}

#[test]
#[ignore = "writes printed.rs"]
fn print() {
    write(FILE, source()).unwrap();
}

#[test]
fn a_formula_in_rust_has_the_bits_of_its_evaluation() {
    assert_eq!(read_to_string(FILE).unwrap(), source(), "print it anew");
    let numbers = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.3,
        -0.7,
        0.5,
        2.0,
        -3.0,
        17.25,
        64.0,
        65.0,
        1e-9,
        1e19,
        -1e305,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ];
    for (formula, printed) in formulas().iter().zip(PRINTED) {
        let mut differences = 0;
        for place in 0..numbers.len().pow(3) {
            let n = numbers.len();
            let point = [place % n, place / n % n, place / n / n].map(|i| numbers[i]);
            let (here, there) = (formula.at(&point), printed(point));
            let is_same = here.to_bits() == there.to_bits() || here.is_nan() && there.is_nan();
            assert!(is_same, "{formula} at {point:?}: {here}, in Rust {there}");
            differences += usize::from(here != formula.at(&numbers));
        }
        // What is the same everywhere would tell nothing.
        assert!(differences > 0 || formula.value().is_some(), "{formula}");
    }
}
