//! The memory that a step of a linear system works in.

use crate::cloud::{Register, Start};
use crate::neighbours::{CellBuffers, Grid};
use crate::pairs::{Fields, Settled};
use crate::scalar::Scalar;

use super::law::{SystemNode, SystemSums};

/// Memory that a step works in. All but `starts` of the cells hold as many as there are
/// particles.
pub struct LinearWorkspace<'a, S: Scalar, M: Fields<S>, const D: usize, const P: usize> {
    /// For the search for partners.
    pub cells: CellBuffers<'a, S, D>,
    /// The geometry of the cells, while the particles have not moved.
    pub grid: &'a mut Option<Grid<S, D>>,
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
