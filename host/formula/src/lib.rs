//! Formulas: functions of place, time and unknowns, read from text.
//!
//! A formula is read once into a list of operations without repeats, then evaluated for many
//! points at a time. All elementary functions are those of `libm`: a formula has the same bits on
//! every platform. Derivatives are made from the operations, never asked from the user.
//!
//! ```
//! use motes_formula::Scope;
//!
//! let mut scope = Scope::new(["x", "t"]);
//! scope.define("k", "2*pi")?;
//! scope.define("wave(s)", "sin(k*s)")?;
//! let formula = scope.formula("1 + 0.2*wave(x - t)")?;
//! assert_eq!(formula.at(&[0.25, 0.0]), 1.2);
//! // d/dx = 0.2 k cos(k (x - t))
//! let slope = formula.derivative(0);
//! assert!((slope.at(&[0.5, 0.5]) - 0.4 * std::f64::consts::PI).abs() < 1e-15);
//! # Ok::<(), motes_formula::FormulaError>(())
//! ```
//!
//! What cannot be read is refused with its place in the text and the cure:
//!
//! ```
//! use motes_formula::Scope;
//!
//! let error = Scope::new(["x"]).formula("1 + 2x").unwrap_err();
//! assert_eq!(error.to_string(), "there is no sign between `2` and `x`");
//! assert_eq!((error.span.clone(), error.help()), (5..6, "write 2*x".to_owned()));
//! ```
//!
//! # Modules
//!
//! | files | hold |
//! |---|---|
//! | `token` | text to numbers, names and signs |
//! | `parser` | signs and names to operations, by precedence |
//! | `scope` | the names that a formula may use: variables, definitions |
//! | `graph` | operations, each once, simplified where that is exact |
//! | `algebra` | formulas made of formulas |
//! | `derivative` | the derivative of a list of operations |
//! | `function` | elementary functions: names and values |
//! | `elementary` | values of those that neither Rust nor `libm` has |
//! | `formula` | a finished formula: evaluation |
//! | `rust` | a finished formula as Rust source |
//! | `error` | what is wrong, where, and the cure |

mod algebra;
mod derivative;
mod elementary;
mod error;
mod formula;
mod function;
mod graph;
mod parser;
mod rust;
mod scope;
#[cfg(test)]
mod tests;
mod token;

pub use error::{FormulaError, FormulaFault};
pub use formula::Formula;
pub use rust::ELEMENTARY;
pub use scope::{Scope, is_name};
