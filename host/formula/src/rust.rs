//! A finished formula as Rust source, for a device that has no reader of formulas.

use std::fmt::Write;

use crate::formula::Formula;
use crate::function::{BinaryFunction, Function};
use crate::graph::{Node, Operation};

/// The source of the module `elementary` that the expressions of [`Formula::rust`] use where they
/// need it, without a heap or the standard library; it needs the crate `libm`.
pub const ELEMENTARY: &str = include_str!("elementary.rs");

/// An expression longer than this is given a name.
const LONG: usize = 72;

/// How tightly the parts of an expression hold together, as Rust reads them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Whole,
}

/// The source of an operation.
#[derive(Clone, Debug)]
struct Expression {
    text: String,
    binding: Binding,
}

impl Expression {
    fn whole(text: String) -> Self {
        let binding = Binding::Whole;
        Self { text, binding }
    }

    fn number(value: f64) -> Self {
        match value {
            _ if value.is_nan() => Self::whole("f64::NAN".to_owned()),
            f64::INFINITY => Self::whole("f64::INFINITY".to_owned()),
            f64::NEG_INFINITY => Self::whole("f64::NEG_INFINITY".to_owned()),
            std::f64::consts::PI => Self::whole("core::f64::consts::PI".to_owned()),
            std::f64::consts::TAU => Self::whole("core::f64::consts::TAU".to_owned()),
            _ if value < 0.0 => Self::number(-value).negative(),
            _ => Self {
                // The digits read back to the same bits.
                text: format!("{value:?}"),
                binding: match value.is_sign_negative() {
                    true => Binding::Sign,
                    false => Binding::Whole,
                },
            },
        }
    }

    fn negative(&self) -> Self {
        Self {
            text: format!("-{}", self.within(Binding::Whole)),
            binding: Binding::Sign,
        }
    }

    /// In parentheses where it holds together less tightly than that.
    fn within(&self, least: Binding) -> String {
        match self.binding < least {
            true => format!("({})", self.text),
            false => self.text.clone(),
        }
    }

    fn call(function: Function, a: &Self) -> Self {
        let name = match function {
            Function::Abs => "libm::fabs",
            Function::Acos => "libm::acos",
            Function::Asin => "libm::asin",
            Function::Atan => "libm::atan",
            Function::Cbrt => "libm::cbrt",
            Function::Ceil => "libm::ceil",
            Function::Cos => "libm::cos",
            Function::Cosh => "libm::cosh",
            Function::Erf => "libm::erf",
            Function::Exp => "libm::exp",
            Function::Floor => "libm::floor",
            Function::Log => "libm::log",
            Function::Log10 => "libm::log10",
            Function::Sign => "elementary::sign",
            Function::Sin => "libm::sin",
            Function::Sinh => "libm::sinh",
            Function::Sqrt => "libm::sqrt",
            Function::Tan => "libm::tan",
            Function::Tanh => "libm::tanh",
        };
        Self::whole(format!("{name}({})", a.text))
    }

    fn pair(binary: BinaryFunction, a: &Self, b: &Self) -> Self {
        let called = |name: &str| Self::whole(format!("{name}({}, {})", a.text, b.text));
        // Sums and products are of the left: what stands on the right must hold more tightly.
        let signed = |sign: &str, binding: Binding, right: Binding| Self {
            text: format!("{} {sign} {}", a.within(binding), b.within(right)),
            binding,
        };
        let compared = |sign: &str| {
            let sides = (a.within(Binding::Sum), b.within(Binding::Sum));
            Self::whole(format!("elementary::truth({} {sign} {})", sides.0, sides.1))
        };
        match binary {
            BinaryFunction::Add => signed("+", Binding::Sum, Binding::Product),
            BinaryFunction::Subtract => signed("-", Binding::Sum, Binding::Product),
            BinaryFunction::Multiply if a.text == "-1.0" => b.negative(),
            BinaryFunction::Multiply if b.text == "-1.0" => a.negative(),
            BinaryFunction::Multiply => signed("*", Binding::Product, Binding::Whole),
            BinaryFunction::Divide => signed("/", Binding::Product, Binding::Whole),
            BinaryFunction::Power => called("elementary::power"),
            BinaryFunction::Remainder => called("elementary::remainder"),
            BinaryFunction::Minimum => called("elementary::minimum"),
            BinaryFunction::Maximum => called("elementary::maximum"),
            BinaryFunction::Atan2 => called("libm::atan2"),
            BinaryFunction::Less => compared("<"),
            BinaryFunction::LessOrEqual => compared("<="),
            BinaryFunction::Equal => compared("=="),
        }
    }
}

impl Formula {
    /// The formula as a Rust expression of type `f64`, a block where it takes more than a line. It has
    /// the bits of [`Formula::at`]: the same operations on the same operands, of which the order is
    /// free. A variable is written by its name; one without is 0.
    ///
    /// It needs the crate `libm` and, where the text has `elementary::`, a module of that name with
    /// [`ELEMENTARY`] in it. `indent`: blanks in front of each line but the first.
    ///
    /// ```
    /// let formula = motes_formula::Scope::new(["x", "t"]).formula("2*(x - t)^2")?;
    /// let source = formula.rust(&["x", "now"], 0);
    /// assert_eq!(source, "2.0 * elementary::power(x - now, 2.0)");
    /// # Ok::<(), motes_formula::FormulaError>(())
    /// ```
    pub fn rust(&self, variables: &[&str], indent: usize) -> String {
        let operations = self.operations();
        let uses = uses(operations);
        let margin = " ".repeat(indent + 4);
        let mut named = String::new();
        let mut names = 0;
        let mut expressions: Vec<Expression> = Vec::new();
        for (place, operation) in operations.iter().enumerate() {
            let of = |node: Node| &expressions[node];
            let expression = match *operation {
                Operation::Number(value) => Expression::number(value),
                Operation::Variable(of) => match variables.get(of) {
                    Some(name) => Expression::whole((*name).to_owned()),
                    None => Expression::number(0.0),
                },
                Operation::Call(function, a) => Expression::call(function, of(a)),
                Operation::Pair(binary, a, b) => Expression::pair(binary, of(a), of(b)),
                Operation::Choice(condition, a, b) => {
                    let parts = [condition, a, b].map(|part| of(part).text.as_str());
                    Expression::whole(format!("elementary::choice({})", parts.join(", ")))
                }
            };
            let is_value = matches!(operation, Operation::Number(_) | Operation::Variable(_));
            let is_last = place + 1 == operations.len();
            let is_named = !is_value && (uses[place] > 1 || expression.text.len() > LONG);
            expressions.push(match is_named && !is_last {
                true => {
                    let _ = writeln!(named, "{margin}let v{names} = {};", expression.text);
                    names += 1;
                    Expression::whole(format!("v{}", names - 1))
                }
                false => expression,
            });
        }
        let last = expressions.pop().map_or_else(String::new, |last| last.text);
        match named.is_empty() {
            true => last,
            false => format!("{{\n{named}{margin}{last}\n{}}}", " ".repeat(indent)),
        }
    }
}

/// How often each operation is used by others.
fn uses(operations: &[Operation]) -> Vec<usize> {
    let mut uses = vec![0; operations.len()];
    for operation in operations {
        match *operation {
            Operation::Number(_) | Operation::Variable(_) => {}
            Operation::Call(_, a) => uses[a] += 1,
            Operation::Pair(_, a, b) => {
                uses[a] += 1;
                uses[b] += 1;
            }
            Operation::Choice(condition, a, b) => {
                uses[condition] += 1;
                uses[a] += 1;
                uses[b] += 1;
            }
        }
    }
    uses
}
