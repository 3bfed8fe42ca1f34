//! Elementary functions: names and values.

use crate::elementary;

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Function {
    Abs,
    Acos,
    Asin,
    Atan,
    Cbrt,
    Ceil,
    Cos,
    Cosh,
    Erf,
    Exp,
    Floor,
    Log,
    Log10,
    Sign,
    Sin,
    Sinh,
    Sqrt,
    Tan,
    Tanh,
}

/// The functions by name.
pub(crate) const FUNCTIONS: [(&str, Function); 19] = [
    ("abs", Function::Abs),
    ("acos", Function::Acos),
    ("asin", Function::Asin),
    ("atan", Function::Atan),
    ("cbrt", Function::Cbrt),
    ("ceil", Function::Ceil),
    ("cos", Function::Cos),
    ("cosh", Function::Cosh),
    ("erf", Function::Erf),
    ("exp", Function::Exp),
    ("floor", Function::Floor),
    ("log", Function::Log),
    ("log10", Function::Log10),
    ("sign", Function::Sign),
    ("sin", Function::Sin),
    ("sinh", Function::Sinh),
    ("sqrt", Function::Sqrt),
    ("tan", Function::Tan),
    ("tanh", Function::Tanh),
];

impl Function {
    /// Its value. `sqrt` is that of IEEE 754, all others are `libm`'s.
    pub fn of(self, a: f64) -> f64 {
        match self {
            Self::Abs => a.abs(),
            Self::Acos => libm::acos(a),
            Self::Asin => libm::asin(a),
            Self::Atan => libm::atan(a),
            Self::Cbrt => libm::cbrt(a),
            Self::Ceil => libm::ceil(a),
            Self::Cos => libm::cos(a),
            Self::Cosh => libm::cosh(a),
            Self::Erf => libm::erf(a),
            Self::Exp => libm::exp(a),
            Self::Floor => libm::floor(a),
            Self::Log => libm::log(a),
            Self::Log10 => libm::log10(a),
            Self::Sign => elementary::sign(a),
            Self::Sin => libm::sin(a),
            Self::Sinh => libm::sinh(a),
            Self::Sqrt => a.sqrt(),
            Self::Tan => libm::tan(a),
            Self::Tanh => libm::tanh(a),
        }
    }
}

/// A function of two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum BinaryFunction {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Remainder,
    Minimum,
    Maximum,
    Atan2,
    Less,
    LessOrEqual,
    Equal,
}

/// The functions of two numbers that are called by name.
pub(crate) const BINARY: [(&str, BinaryFunction); 3] = [
    ("atan2", BinaryFunction::Atan2),
    ("max", BinaryFunction::Maximum),
    ("min", BinaryFunction::Minimum),
];

impl BinaryFunction {
    /// Its value; of a comparison 1 where it holds, else 0.
    pub fn of(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            Self::Divide => a / b,
            Self::Power => elementary::power(a, b),
            Self::Remainder => elementary::remainder(a, b),
            Self::Minimum => elementary::minimum(a, b),
            Self::Maximum => elementary::maximum(a, b),
            Self::Atan2 => libm::atan2(a, b),
            Self::Less => elementary::truth(a < b),
            Self::LessOrEqual => elementary::truth(a <= b),
            Self::Equal => elementary::truth(a == b),
        }
    }
}
