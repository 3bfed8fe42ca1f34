//! The memory that a step of a gas works in.

use crate::neighbours::{CellBuffers, Grid};
use crate::pairs::{Fields, Settled};
use crate::scalar::Scalar;

use super::density::{DensityNode, DensitySums};
use super::gradient::{GradientNode, GradientSums};
use super::node::{GasNode, GasSums};
use super::terms::NodeOf;

/// The node and the sums of each particle of a gas with these terms, in sorted order.
pub type RatesOf<S, T, const D: usize> = [Settled<NodeOf<S, T, D>, GasSums<S, D>>];

/// Memory that a step works in. Nothing in it is read by the next step; what the last one left says what
/// acts on walls ([`WallForces`](super::WallForces)). `X` is what the terms beyond the
/// paper's equations show: [`Terms::Shown`](super::Terms::Shown).
pub struct Workspace<'a, S: Scalar, X: Fields<S>, const D: usize> {
    /// For the search for partners.
    pub cells: CellBuffers<'a, S, D>,
    /// The geometry of the cells that the last rates were made in.
    pub grid: &'a mut Option<Grid<S, D>>,
    /// Nodes of the density sum, in sorted order.
    pub density_nodes: &'a mut [DensityNode<S, D>],
    /// Its results.
    pub densities: &'a mut [Settled<DensityNode<S, D>, DensitySums<S, D>>],
    /// Nodes of the motion, in sorted order.
    pub nodes: &'a mut [GasNode<S, X, D>],
    /// Its results.
    pub rates: &'a mut [Settled<GasNode<S, X, D>, GasSums<S, D>>],
    /// For gradients.
    pub gradients: GradientBuffers<'a, S, D>,
}

/// Memory for the sums of [`super::gradient`]; empty where no gradients are needed.
pub struct GradientBuffers<'a, S: Scalar, const D: usize> {
    /// Nodes, in sorted order.
    pub nodes: &'a mut [GradientNode<S, D>],
    /// Results.
    pub sums: &'a mut [Settled<GradientNode<S, D>, GradientSums<S, D>>],
}
