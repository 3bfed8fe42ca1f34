//! A gas in growing arrays: the same solver as on a device, in the memory of a server.

use motes_core::equation::gas::density::{DensityNode, DensitySums};
use motes_core::equation::gas::motion::{GasNode, GasSums};
use motes_core::equation::gas::{Gas, Particle, Workspace};
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
    density: Vec<S>,
    force: Vec<[S; D]>,
    power: Vec<S>,
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
}

impl<S: Scalar, const D: usize> GasArrays<S, D> {
    /// Bytes that one particle takes, state, workspace and a typical neighbour list.
    pub const BYTES_PER_PARTICLE: usize = size_of::<[S; D]>() * 3
        + size_of::<S>() * 8
        + size_of::<Site<S, D>>()
        + size_of::<u32>() * (6 + 16)
        + size_of::<DensityNode<S, D>>()
        + size_of::<Settled<DensityNode<S, D>, DensitySums<S, D>>>()
        + size_of::<GasNode<S, D>>()
        + size_of::<Settled<GasNode<S, D>, GasSums<S, D>>>();

    /// A cloud of these particles; ids are their places.
    pub fn new(particles: impl IntoIterator<Item = Particle<S, D>>) -> Self {
        let particles: Vec<_> = particles.into_iter().collect();
        let n = particles.len();
        Self {
            position: particles.iter().map(|p| p.position).collect(),
            velocity: particles.iter().map(|p| p.velocity).collect(),
            energy: particles.iter().map(|p| p.energy).collect(),
            mass: particles.iter().map(|p| p.mass).collect(),
            epsilon: particles.iter().map(|p| p.epsilon).collect(),
            density: vec![S::ZERO; n],
            force: vec![[S::ZERO; D]; n],
            power: vec![S::ZERO; n],
            divergence: vec![S::ZERO; n],
            signal: vec![S::ZERO; n],
            neighbours: vec![S::ZERO; n],
            sites: vec![Site::EMPTY; n],
            order: vec![0; n],
            cell_of: vec![0; n],
            starts: vec![0; cell_bound(n as u32) as usize + 1],
            density_nodes: vec![DensityNode::ZERO; n],
            densities: vec![Settled::new(DensityNode::ZERO, DensitySums::ZERO); n],
            gas_nodes: vec![GasNode::ZERO; n],
            rates: vec![Settled::new(GasNode::ZERO, GasSums::ZERO); n],
        }
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (Gas<'_, S, D>, Workspace<'_, S, D>) {
        let gas = Gas {
            position: &mut self.position,
            velocity: &mut self.velocity,
            energy: &mut self.energy,
            mass: &self.mass,
            epsilon: &mut self.epsilon,
            density: &mut self.density,
            force: &mut self.force,
            power: &mut self.power,
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
        };
        (gas, work)
    }
}
