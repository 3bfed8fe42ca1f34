//! The memory that a step of a linear system works in.

use crate::neighbours::{CellBuffers, Grid};
use crate::pairs::{Fields, Settled};
use crate::scalar::Scalar;

use super::law::{SystemNode, SystemSums};

/// Rates of a particle, or a sum of them: `dx/dt`, `dw/dt`, `ε dq/dt`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Register<S, const D: usize, const P: usize> {
    /// Of the position: `a`.
    pub position: [S; D],
    /// Of the weight: `w div a`.
    pub weight: S,
    /// Of the strength, times ε.
    pub strength: [S; P],
}

impl<S: Scalar, const D: usize, const P: usize> Register<S, D, P> {
    /// No rates.
    pub const ZERO: Self = Self {
        position: [S::ZERO; D],
        weight: S::ZERO,
        strength: [S::ZERO; P],
    };

    /// Adds `n` times other rates, by repeated sums: exact in fixed point.
    pub(crate) fn add(&mut self, n: u32, rates: &Self) {
        for _ in 0..n {
            for (sum, &rate) in self.position.iter_mut().zip(&rates.position) {
                *sum += rate;
            }
            self.weight += rates.weight;
            for (sum, &rate) in self.strength.iter_mut().zip(&rates.strength) {
                *sum += rate;
            }
        }
    }
}

/// What a particle was at the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<S: Scalar, const D: usize, const P: usize> {
    /// Its position.
    pub position: [S; D],
    /// Its weight.
    pub weight: S,
    /// Its strength.
    pub strength: [S::Wide; P],
}

/// Memory that a step works in. All but `starts` of the cells hold as many as there are
/// particles.
pub struct LinearWorkspace<'a, S: Scalar, M: Fields<S>, const D: usize, const P: usize> {
    /// For the search for partners.
    pub cells: CellBuffers<'a, S, D>,
    /// The geometry of the cells, while the particles have not moved.
    pub grid: Option<Grid<S, D>>,
    /// Nodes, in sorted order.
    pub nodes: &'a mut [SystemNode<S, M, D, P>],
    /// Sums over pairs, in sorted order.
    pub sums: &'a mut [Settled<SystemNode<S, M, D, P>, SystemSums<S, P>>],
    /// The state at the start of a step.
    pub start: &'a mut [Start<S, D, P>],
    /// The rates that were made last.
    pub last: &'a mut [Register<S, D, P>],
    /// The weighted sum of the rates of a step.
    pub sum: &'a mut [Register<S, D, P>],
}
