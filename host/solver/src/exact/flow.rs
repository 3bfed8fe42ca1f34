//! What all exact solutions are: flows of gas known everywhere.
//!
//! Units are the caller's, any consistent set. Elementary functions come from `libm`, so
//! that a flow has the same bits on every platform; the Riemann problem only at t = 0.

use thiserror::Error;

/// A gas at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlowState {
    /// Mass / length^dimension.
    pub density: f64,
    /// Length / time; components beyond the dimension are 0.
    pub velocity: [f64; 3],
    /// Density * velocity^2.
    pub pressure: f64,
    /// Internal energy per mass, velocity^2.
    pub energy: f64,
}

/// A flow of gas known everywhere at all times >= 0.
pub trait Flow: Send + Sync {
    /// The gas at a point and a time.
    fn at(&self, position: [f64; 3], time: f64) -> FlowState;
}

/// Why a flow does not exist.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum FlowError {
    /// A number of the problem is out of range.
    #[error("{quantity} = {value} is out of range: need {need}")]
    OutOfRange {
        /// Which number.
        quantity: &'static str,
        /// What it is.
        value: f64,
        /// What it should be.
        need: &'static str,
    },
    /// A numerical reference solution that takes too long.
    #[error(
        "the finite-volume reference takes some {steps:.1e} steps, more than {most:.1e}: a speed is out \
         of proportion to the domain and time.end"
    )]
    Endless {
        /// How many it would be.
        steps: f64,
        /// The most that are made.
        most: f64,
    },
    /// A density or pressure of a numerical reference solution is no longer positive.
    #[error("density or pressure is not positive at t = {time}: need more cells or milder data")]
    NotPositive {
        /// When.
        time: f64,
    },
}

impl FlowState {
    /// An ideal gas: `e = p / ((gamma - 1) rho)`.
    pub fn ideal(density: f64, velocity: [f64; 3], pressure: f64, gamma: f64) -> Self {
        let energy = pressure / ((gamma - 1.0) * density);
        Self {
            density,
            velocity,
            pressure,
            energy,
        }
    }
}

/// A number of a problem: its name, its value, what it should be, and whether it is.
pub(super) type Number = (&'static str, f64, &'static str, bool);

/// An error that names the first number that is not finite or not as it should be.
pub(super) fn check(numbers: &[Number]) -> Result<(), FlowError> {
    for &(quantity, value, need, holds) in numbers {
        if !value.is_finite() || !holds {
            return Err(FlowError::OutOfRange {
                quantity,
                value,
                need,
            });
        }
    }
    Ok(())
}

/// A dimension of space, 1 to 3.
pub(super) fn dimension_number(dimension: usize) -> Number {
    let holds = (1..=3).contains(&dimension);
    ("dimension", dimension as f64, "1, 2 or 3", holds)
}

/// A ratio of specific heats, > 1.
pub(super) fn gamma_number(gamma: f64) -> Number {
    ("gamma", gamma, "> 1", gamma > 1.0)
}

/// Distance from the origin in the first `dimension` components.
pub(super) fn radius(position: [f64; 3], dimension: usize) -> f64 {
    let squares = position.iter().take(dimension).map(|x| x * x);
    squares.sum::<f64>().sqrt()
}

/// The vector of length `length` (or its opposite, if negative) from the origin through
/// `position`; 0 at the origin.
pub(super) fn radial(position: [f64; 3], dimension: usize, length: f64) -> [f64; 3] {
    let r = radius(position, dimension);
    if r > 0.0 {
        std::array::from_fn(|i| {
            if i < dimension {
                length * (position[i] / r)
            } else {
                0.0
            }
        })
    } else {
        [0.0; 3]
    }
}
