//! Why a solution does not exist, and the check of the numbers of a problem.

use thiserror::Error;

/// What is wrong with a problem.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum SolutionError {
    /// A number is out of range.
    #[error("{quantity} must be {need}, not {value}")]
    OutOfRange {
        /// Which number.
        quantity: &'static str,
        /// What it is.
        value: f64,
        /// What it should be.
        need: &'static str,
    },
    /// A list is too short or too long.
    #[error("{quantity} must have {need} numbers, not {length}")]
    Length {
        /// Which list.
        quantity: &'static str,
        /// How long it is.
        length: usize,
        /// How long it should be.
        need: usize,
    },
    /// Two things of which each is solved without the other.
    #[error("{one} together with {other} has no closed form here: leave one of them out")]
    Together {
        /// The one.
        one: &'static str,
        /// The other.
        other: &'static str,
    },
}

/// A number of a problem: its name, its value, what it should be, and whether it is.
pub(in crate::exact) type Number = (&'static str, f64, &'static str, bool);

/// An error that names the first number that is not finite or not as it should be.
pub(in crate::exact) fn check(numbers: &[Number]) -> Result<(), SolutionError> {
    for &(quantity, value, need, holds) in numbers {
        if !value.is_finite() || !holds {
            return Err(SolutionError::OutOfRange {
                quantity,
                value,
                need,
            });
        }
    }
    Ok(())
}

/// An error if a list has not the length it should have.
pub(in crate::exact) fn check_length(
    quantity: &'static str,
    length: usize,
    need: usize,
) -> Result<(), SolutionError> {
    if length == need {
        return Ok(());
    }
    Err(SolutionError::Length {
        quantity,
        length,
        need,
    })
}

/// Any number.
pub(in crate::exact) fn finite(quantity: &'static str, value: f64) -> Number {
    (quantity, value, "finite", true)
}

/// Above 0.
pub(in crate::exact) fn positive(quantity: &'static str, value: f64) -> Number {
    (quantity, value, "> 0", value > 0.0)
}

/// 0 or above.
pub(in crate::exact) fn not_negative(quantity: &'static str, value: f64) -> Number {
    (quantity, value, ">= 0", value >= 0.0)
}

/// A dimension of space up to `most`.
pub(in crate::exact) fn dimension_up_to(dimension: usize, most: usize) -> Number {
    let need = if most == 3 { "1, 2 or 3" } else { "1 or 2" };
    let holds = (1..=most).contains(&dimension);
    ("dimension", dimension as f64, need, holds)
}
