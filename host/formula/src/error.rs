//! What is wrong with a formula, where, and the cure.

use std::ops::Range;

use thiserror::Error;

/// Why a formula was refused; `Display` says what is wrong.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{fault}")]
pub struct FormulaError {
    /// What is wrong.
    pub fault: FormulaFault,
    /// Bytes of the text that it is about.
    pub span: Range<usize>,
    /// The definition whose text that is; `None`: the formula itself.
    pub definition: Option<String>,
}

impl FormulaError {
    pub(crate) fn new(fault: FormulaFault, span: Range<usize>) -> Self {
        Self {
            fault,
            span,
            definition: None,
        }
    }

    /// What to do about it.
    pub fn help(&self) -> String {
        self.fault.help()
    }
}

/// The kinds of faults.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are what the texts print
pub enum FormulaFault {
    /// Nothing but blanks.
    #[error("the formula is empty")]
    Empty,
    /// A character that no formula has.
    #[error("`{0}` is no part of a formula")]
    Character(char),
    /// Digits that are no number.
    #[error("`{0}` is no number")]
    Number(String),
    /// A number beyond the largest double.
    #[error("`{0}` is beyond the largest number, 1.8e308")]
    TooLarge(String),
    /// A value is missing at the end or before a sign.
    #[error("a value is missing {}", before(.0))]
    NoValue(Option<String>),
    /// Two values side by side.
    #[error("there is no sign between `{left}` and `{right}`")]
    NoSign { left: String, right: String },
    /// A parenthesis that is not closed.
    #[error("this parenthesis is not closed")]
    Open,
    /// A closing parenthesis without an opening one, or a comma outside of arguments.
    #[error("`{0}` stands where the formula could end")]
    Stray(String),
    /// `a < b < c`.
    #[error("comparisons cannot be chained")]
    Chained,
    /// A name that nothing has.
    #[error("there is no `{name}` here")]
    Unknown { name: String, known: Vec<String> },
    /// A function without arguments.
    #[error("`{0}` is a function: its arguments are missing")]
    NotCalled(String),
    /// Arguments of what is no function.
    #[error("`{0}` is no function")]
    NotFunction(String),
    /// Too many or too few arguments.
    #[error("`{name}` takes {needs}, found {found}")]
    Arguments {
        name: String,
        needs: String,
        found: usize,
    },
    /// A definition that needs itself.
    #[error("the definition of `{0}` needs itself")]
    Circular(String),
    /// A name that cannot be defined.
    #[error("`{name}` cannot be defined: {reason}")]
    BadName { name: String, reason: String },
    /// More than a formula may have.
    #[error("the formula is too long or too deep: more than {0}")]
    TooMuch(&'static str),
}

impl FormulaFault {
    /// What to do about it.
    pub fn help(&self) -> String {
        match self {
            Self::Empty => "give a number or a formula such as \"1 + 0.2*sin(5*x)\"".to_owned(),
            Self::Character('=') => "compare with ==; names are defined in [define]".to_owned(),
            Self::Character('&') => "write && for \"and\"".to_owned(),
            Self::Character('|') => "write || for \"or\", abs(x) for an absolute value".to_owned(),
            Self::Character(',') => "write 1.5, not 1,5; commas part arguments".to_owned(),
            Self::Character('[' | '{') => "use round parentheses".to_owned(),
            Self::Character(_) => {
                "use numbers, names, + - * / ^ ( ) , < <= > >= == != && || !".to_owned()
            }
            Self::Number(_) => "write numbers as 2, 0.5 or 1e-3".to_owned(),
            Self::TooLarge(_) => "give a smaller number".to_owned(),
            Self::NoValue(_) => "give a number, a name or a parenthesis there".to_owned(),
            Self::NoSign { left, right } => format!("write {left}*{right}"),
            Self::Open => "close it with `)`".to_owned(),
            Self::Stray(_) => "take it out, or open a parenthesis before it".to_owned(),
            Self::Chained => "write a < b && b < c".to_owned(),
            Self::Unknown { known, .. } => format!(
                "known here: {}; others are given in [define]",
                known.join(", ")
            ),
            Self::NotCalled(name) => format!("write {name}(...)"),
            Self::NotFunction(name) => format!("write {name}*(...) for a product"),
            Self::Arguments { .. } => {
                "arguments stand in parentheses, with commas between them".to_owned()
            }
            Self::Circular(_) => "define it by numbers and names that do not need it".to_owned(),
            Self::BadName { .. } => {
                "use letters, digits and _, a letter first: k, or c(s) for a function".to_owned()
            }
            Self::TooMuch(_) => "part it into definitions, or make it simpler".to_owned(),
        }
    }
}

fn before(sign: &Option<String>) -> String {
    match sign {
        Some(sign) => format!("before `{sign}`"),
        None => "at the end".to_owned(),
    }
}
