//! The memory that a step of a gas works in.

use crate::neighbours::CellBuffers;
use crate::pairs::{Fields, Settled};
use crate::scalar::Scalar;

use super::density::{DensityNode, DensitySums};
use super::exchange::{ExchangeNode, ExchangeSums};
use super::gradient::{GradientNode, GradientSums};
use super::motion::{GasNode, GasSums};

/// Memory that a step works in; nothing in it outlives the step.
pub struct Workspace<'a, S: Scalar, const D: usize> {
    /// For the search for partners.
    pub cells: CellBuffers<'a, S, D>,
    /// Nodes of the density sum, in sorted order.
    pub density_nodes: &'a mut [DensityNode<S, D>],
    /// Its results.
    pub densities: &'a mut [Settled<DensityNode<S, D>, DensitySums<S, D>>],
    /// Nodes of the motion, in sorted order.
    pub gas_nodes: &'a mut [GasNode<S, D>],
    /// Its results.
    pub rates: &'a mut [Settled<GasNode<S, D>, GasSums<S, D>>],
    /// For what goes beyond the paper's equations: [`Options`](super::Options). Empty with
    /// [`Plain`](super::Plain).
    pub exchange: ExchangeWorkspace<'a, S, D>,
}

/// Memory for the sums of [`super::exchange`] and [`super::gradient`].
pub struct ExchangeWorkspace<'a, S: Scalar, const D: usize> {
    /// Nodes of the velocity gradients, in sorted order.
    pub gradient_nodes: &'a mut [GradientNode<S, D>],
    /// Their results.
    pub gradients: &'a mut [Settled<GradientNode<S, D>, GradientSums<S, D>>],
    /// Nodes of the exchange, in sorted order.
    pub nodes: &'a mut [ExchangeNode<S, D>],
    /// Its results.
    pub rates: &'a mut [Settled<ExchangeNode<S, D>, ExchangeSums<S, D>>],
}

impl<S: Scalar, const D: usize> Default for ExchangeWorkspace<'_, S, D> {
    /// None.
    fn default() -> Self {
        Self {
            gradient_nodes: &mut [],
            gradients: &mut [],
            nodes: &mut [],
            rates: &mut [],
        }
    }
}

/// The memory of an [`ExchangeWorkspace`] for `N` particles, without a heap:
/// `work.exchange = storage.parts()`.
pub struct ExchangeStorage<S: Scalar, const D: usize, const N: usize> {
    gradient_nodes: [GradientNode<S, D>; N],
    gradients: [Settled<GradientNode<S, D>, GradientSums<S, D>>; N],
    nodes: [ExchangeNode<S, D>; N],
    rates: [Settled<ExchangeNode<S, D>, ExchangeSums<S, D>>; N],
}

impl<S: Scalar, const D: usize, const N: usize> Default for ExchangeStorage<S, D, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const D: usize, const N: usize> ExchangeStorage<S, D, N> {
    /// Memory with nothing in it.
    pub const fn new() -> Self {
        Self {
            gradient_nodes: [GradientNode::ZERO; N],
            gradients: [Settled::new(GradientNode::ZERO, GradientSums::ZERO); N],
            nodes: [ExchangeNode::ZERO; N],
            rates: [Settled::new(ExchangeNode::ZERO, ExchangeSums::ZERO); N],
        }
    }

    /// As the solver takes it.
    pub fn parts(&mut self) -> ExchangeWorkspace<'_, S, D> {
        ExchangeWorkspace {
            gradient_nodes: &mut self.gradient_nodes,
            gradients: &mut self.gradients,
            nodes: &mut self.nodes,
            rates: &mut self.rates,
        }
    }
}
