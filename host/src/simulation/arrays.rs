//! A gas in growing arrays: the same solver as on a device, in the memory of a server.

use motes_core::equation::gas::density::{DensityNode, DensitySums};
use motes_core::equation::gas::exchange::{ExchangeNode, ExchangeSums};
use motes_core::equation::gas::gradient::{GradientNode, GradientSums};
use motes_core::equation::gas::motion::{GasNode, GasSums};
use motes_core::equation::gas::{ExchangeWorkspace, Gas, Options, Particle, Workspace};
use motes_core::neighbours::{CellBuffers, Site, cell_bound};
use motes_core::pairs::{Fields, Settled};
use motes_core::scalar::Scalar;

/// The state of a gas and the workspace of its solver.
pub struct GasArrays<S: Scalar, const D: usize> {
    position: Vec<[S; D]>,
    velocity: Vec<[S; D]>,
    energy: Vec<S>,
    mass: Vec<S>,
    epsilon: Vec<S>,
    material: Vec<u8>,
    density: Vec<S>,
    force: Vec<[S; D]>,
    power: Vec<S>,
    power_slope: Vec<S>,
    viscosity_factor: Vec<S>,
    divergence: Vec<S>,
    signal: Vec<S>,
    neighbours: Vec<S>,
    sites: Vec<Site<S, D>>,
    order: Vec<u32>,
    cell_of: Vec<u32>,
    starts: Vec<u32>,
    density_nodes: Vec<DensityNode<S, D>>,
    densities: Vec<Settled<DensityNode<S, D>, DensitySums<S, D>>>,
    gas_nodes: Vec<GasNode<S, D>>,
    rates: Vec<Settled<GasNode<S, D>, GasSums<S, D>>>,
    exchange: ExchangeArrays<S, D>,
}

/// What the solver works in where its options ask for more than the paper's equations.
struct ExchangeArrays<S: Scalar, const D: usize> {
    gradient_nodes: Vec<GradientNode<S, D>>,
    gradients: Vec<Settled<GradientNode<S, D>, GradientSums<S, D>>>,
    nodes: Vec<ExchangeNode<S, D>>,
    rates: Vec<Settled<ExchangeNode<S, D>, ExchangeSums<S, D>>>,
}

impl<S: Scalar, const D: usize> GasArrays<S, D> {
    /// Bytes that one particle takes, state, workspace and a typical neighbour list.
    pub fn bytes_per_particle(options: &Options<S, D>) -> usize {
        let exchange = size_of::<ExchangeNode<S, D>>()
            + size_of::<Settled<ExchangeNode<S, D>, ExchangeSums<S, D>>>();
        let gradients = size_of::<GradientNode<S, D>>()
            + size_of::<Settled<GradientNode<S, D>, GradientSums<S, D>>>();
        size_of::<[S; D]>() * 3
            + size_of::<S>() * 10
            + size_of::<Site<S, D>>()
            + size_of::<u32>() * (6 + 16)
            + size_of::<DensityNode<S, D>>()
            + size_of::<Settled<DensityNode<S, D>, DensitySums<S, D>>>()
            + size_of::<GasNode<S, D>>()
            + size_of::<Settled<GasNode<S, D>, GasSums<S, D>>>()
            + exchange * usize::from(options.need_exchange())
            + gradients * usize::from(options.need_gradients())
    }

    /// A cloud of these particles, with memory for what the options need; ids are places.
    pub fn new(
        particles: impl IntoIterator<Item = Particle<S, D>>,
        options: &Options<S, D>,
    ) -> Self {
        let particles: Vec<_> = particles.into_iter().collect();
        let n = particles.len();
        let only_if = |needed: bool| if needed { n } else { 0 };
        let exchanged = only_if(options.need_exchange());
        let graded = only_if(options.need_gradients());
        let moved = only_if(!options.need_exchange());
        Self {
            position: particles.iter().map(|p| p.position).collect(),
            velocity: particles.iter().map(|p| p.velocity).collect(),
            energy: particles.iter().map(|p| p.energy).collect(),
            mass: particles.iter().map(|p| p.mass).collect(),
            epsilon: particles.iter().map(|p| p.epsilon).collect(),
            material: particles.iter().map(|p| p.material).collect(),
            density: vec![S::ZERO; n],
            force: vec![[S::ZERO; D]; n],
            power: vec![S::ZERO; n],
            power_slope: vec![S::ZERO; n],
            viscosity_factor: vec![S::ZERO; n],
            divergence: vec![S::ZERO; n],
            signal: vec![S::ZERO; n],
            neighbours: vec![S::ZERO; n],
            sites: vec![Site::EMPTY; n],
            order: vec![0; n],
            cell_of: vec![0; n],
            starts: vec![0; cell_bound(n as u32) as usize + 1],
            density_nodes: vec![DensityNode::ZERO; n],
            densities: vec![Settled::new(DensityNode::ZERO, DensitySums::ZERO); n],
            gas_nodes: vec![GasNode::ZERO; moved],
            rates: vec![Settled::new(GasNode::ZERO, GasSums::ZERO); moved],
            exchange: ExchangeArrays {
                gradient_nodes: vec![GradientNode::ZERO; graded],
                gradients: vec![Settled::new(GradientNode::ZERO, GradientSums::ZERO); graded],
                nodes: vec![ExchangeNode::ZERO; exchanged],
                rates: vec![Settled::new(ExchangeNode::ZERO, ExchangeSums::ZERO); exchanged],
            },
        }
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (Gas<'_, S, D>, Workspace<'_, S, D>) {
        let gas = Gas {
            position: &mut self.position,
            velocity: &mut self.velocity,
            energy: &mut self.energy,
            mass: &self.mass,
            material: &self.material,
            epsilon: &mut self.epsilon,
            density: &mut self.density,
            force: &mut self.force,
            power: &mut self.power,
            power_slope: &mut self.power_slope,
            viscosity_factor: &mut self.viscosity_factor,
            divergence: &mut self.divergence,
            signal: &mut self.signal,
            neighbours: &mut self.neighbours,
        };
        let work = Workspace {
            cells: CellBuffers {
                sites: &mut self.sites,
                order: &mut self.order,
                cell_of: &mut self.cell_of,
                starts: &mut self.starts,
            },
            density_nodes: &mut self.density_nodes,
            densities: &mut self.densities,
            gas_nodes: &mut self.gas_nodes,
            rates: &mut self.rates,
            exchange: ExchangeWorkspace {
                gradient_nodes: &mut self.exchange.gradient_nodes,
                gradients: &mut self.exchange.gradients,
                nodes: &mut self.exchange.nodes,
                rates: &mut self.exchange.rates,
            },
        };
        (gas, work)
    }
}
