//! The memory that a step of a convection-diffusion problem works in.

use super::ledger::Ledger;
use super::mixed::{FluxSums, MixedNode};
use super::node::{DiffusionNode, DiffusionSums};
use crate::cloud::{Register, Start};
use crate::neighbours::{CellBuffers, Grid};
use crate::pairs::Settled;
use crate::scalar::Scalar;

/// Memory that a step works in. All but `starts` of the cells hold as many as there are
/// particles; the last two are empty for the direct form, and `sum` for
/// [`advance_split`](super::DiffusionDynamics::advance_split).
pub struct DiffusionWorkspace<'a, S: Scalar, const D: usize, const P: usize> {
    /// For the search for partners.
    pub cells: CellBuffers<'a, S, D>,
    /// The geometry of the cells, while the particles have not moved.
    pub grid: &'a mut Option<Grid<S, D>>,
    /// Nodes, in sorted order.
    pub nodes: &'a mut [DiffusionNode<S, D, P>],
    /// Sums over pairs of the direct form, in sorted order.
    pub sums: &'a mut [Settled<DiffusionNode<S, D, P>, DiffusionSums<S, P>>],
    /// The state at the start of a step.
    pub start: &'a mut [Start<S, D, P>],
    /// The rates that were made last.
    pub last: &'a mut [Register<S, D, P>],
    /// The time at which they were made: of a stage, which need not be the end of a step.
    pub time: &'a mut S,
    /// [`DiffusionDynamics::radius`](super::DiffusionDynamics::radius) of these rates, where it has been
    /// read and not made of them.
    pub radius: &'a mut Option<S>,
    /// What has come in so far.
    pub ledger: &'a mut Ledger<S, D, P>,
    /// The weighted sum of the rates of a step by a Runge-Kutta method.
    pub sum: &'a mut [Register<S, D, P>],
    /// For the stabilised method: rates of the first stage, and the increments of the two before.
    pub stages: &'a mut [[[S; P]; 3]],
    /// Sums of the first pass of the mixed form.
    pub fluxes: &'a mut [Settled<DiffusionNode<S, D, P>, FluxSums<S, D, P>>],
    /// Nodes and sums of its second pass.
    pub mixed: MixedWorkspace<'a, S, D, P>,
}

/// Memory of the second pass of the mixed form.
pub struct MixedWorkspace<'a, S: Scalar, const D: usize, const P: usize> {
    /// Nodes, in sorted order.
    pub nodes: &'a mut [MixedNode<S, D, P>],
    /// Sums, in sorted order.
    pub sums: &'a mut [Settled<MixedNode<S, D, P>, DiffusionSums<S, P>>],
}
