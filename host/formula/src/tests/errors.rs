//! What is refused: the message, the place, the cure.

use crate::{FormulaError, Scope};

fn refused(text: &str) -> FormulaError {
    let mut scope = Scope::new(["x", "y"]);
    scope.define("k", "2").unwrap();
    scope.define("c(s, t)", "s + t").unwrap();
    match scope.formula(text) {
        Ok(formula) => panic!("{text} was read: {formula:?}"),
        Err(error) => error,
    }
}

#[test]
fn a_fault_is_told_with_its_place() {
    for (text, message, at) in [
        ("", "the formula is empty", ""),
        ("  ", "the formula is empty", "  "),
        ("2x", "there is no sign between `2` and `x`", "x"),
        ("2 x", "there is no sign between `2` and `x`", "x"),
        ("(x)(y)", "there is no sign between `)` and `(`", "("),
        ("x + ", "a value is missing at the end", ""),
        ("x + * y", "a value is missing before `*`", "*"),
        ("(x + y", "this parenthesis is not closed", "("),
        ("x + y)", "`)` stands where the formula could end", ")"),
        ("x, y", "`,` stands where the formula could end", ","),
        ("sin(x", "this parenthesis is not closed", "("),
        ("0 < x < 1", "comparisons cannot be chained", "<"),
        ("x = 1", "`=` is no part of a formula", "="),
        ("x & y", "`&` is no part of a formula", "&"),
        ("x ² 2", "`²` is no part of a formula", "²"),
        ("1.2.3", "`1.2.3` is no number", "1.2.3"),
        (
            "1e999",
            "`1e999` is beyond the largest number, 1.8e308",
            "1e999",
        ),
        ("foo", "there is no `foo` here", "foo"),
        ("foo(x)", "there is no `foo` here", "foo"),
        (
            "sin",
            "`sin` is a function: its arguments are missing",
            "sin",
        ),
        ("c + 1", "`c` is a function: its arguments are missing", "c"),
        ("x(y)", "`x` is no function", "x"),
        ("k(y)", "`k` is no function", "k"),
        ("pi(y)", "`pi` is no function", "pi"),
        ("sin(x, y)", "`sin` takes one argument, found 2", "sin"),
        ("sin()", "`sin` takes one argument, found 0", "sin"),
        ("min(x)", "`min` takes two arguments, found 1", "min"),
        (
            "atan2(x, y, 1)",
            "`atan2` takes two arguments, found 3",
            "atan2",
        ),
        (
            "if(x, y)",
            "`if` takes three arguments, if(condition, a, b), found 2",
            "if",
        ),
        ("c(x)", "`c` takes (s, t), found 1", "c"),
    ] {
        let error = refused(text);
        assert_eq!(error.to_string(), message, "{text}");
        assert_eq!(&text[error.span.clone()], at, "{text}");
        assert!(!error.help().is_empty());
    }
}

#[test]
fn what_is_too_deep_is_refused_and_not_a_stack_overflow() {
    for text in [
        "(".repeat(5000),
        "-".repeat(9000) + "x",
        "sin(".repeat(2000),
    ] {
        let error = refused(&text).to_string();
        assert!(error.ends_with("more than 200 levels"), "{error}");
    }
    let error = refused(&"x+".repeat(10_000)).to_string();
    assert!(error.ends_with("more than 10000 characters"), "{error}");
}

#[test]
fn a_fault_in_a_definition_names_it() {
    let mut scope = Scope::new(["x"]);
    scope.define("a", "b + 1").unwrap();
    scope.define("b", "2*(x").unwrap();
    let error = scope.formula("3*a").unwrap_err();
    assert_eq!((error.definition.as_deref(), error.span), (Some("b"), 2..3));
}

#[test]
fn a_definition_that_needs_itself_is_refused() {
    let mut scope = Scope::new(["x"]);
    scope.define("a", "b + 1").unwrap();
    scope.define("b", "2*a").unwrap();
    for error in [scope.formula("a").unwrap_err(), scope.check().unwrap_err()] {
        assert_eq!(error.to_string(), "the definition of `a` needs itself");
    }
}

#[test]
fn a_name_that_is_taken_is_refused() {
    let mut scope = Scope::new(["x"]);
    scope.define("k", "1").unwrap();
    for (head, reason) in [
        ("x", "it is a variable"),
        ("pi", "every formula has it already"),
        ("sin(s)", "every formula has it already"),
        ("if", "every formula has it already"),
        ("2k", "it is no name"),
        ("f(2)", "it is no name"),
        ("f()", "it is no name"),
        ("f(s", "its parenthesis is not closed"),
        ("f(f)", "an argument has its name"),
        ("k", "it is defined already"),
    ] {
        let error = scope.define(head, "1").unwrap_err();
        assert_eq!(
            error.to_string(),
            format!("`{head}` cannot be defined: {reason}")
        );
    }
}
