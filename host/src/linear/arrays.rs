//! A linear system in the memory of a server.

use motes_core::equation::linear::{
    LinearWorkspace, Particle, Register, Start, State, SystemNode, SystemSums,
};
use motes_core::neighbours::{CellBuffers, Site, cell_bound};
use motes_core::pairs::{Fields, Settled};
use motes_core::scalar::Scalar;

/// The state of a linear system and the workspace of its solver.
pub(super) struct LinearArrays<S: Scalar, M: Fields<S>, const D: usize, const P: usize> {
    position: Vec<[S; D]>,
    weight: Vec<S>,
    value: Vec<[S; P]>,
    strength: Vec<[S::Wide; P]>,
    neighbours: Vec<S>,
    sites: Vec<Site<S, D>>,
    order: Vec<u32>,
    cell_of: Vec<u32>,
    starts: Vec<u32>,
    nodes: Vec<SystemNode<S, M, D, P>>,
    sums: Vec<Settled<SystemNode<S, M, D, P>, SystemSums<S, P>>>,
    start: Vec<Start<S, D, P>>,
    last: Vec<Register<S, D, P>>,
    sum: Vec<Register<S, D, P>>,
}

impl<S: Scalar, M: Fields<S>, const D: usize, const P: usize> LinearArrays<S, M, D, P> {
    /// Bytes that one particle takes, state, workspace and a typical neighbour list.
    pub fn bytes_per_particle() -> usize {
        size_of::<[S; D]>()
            + size_of::<S>() * (2 + P)
            + size_of::<S::Wide>() * P
            + size_of::<Site<S, D>>()
            + size_of::<u32>() * (6 + 16)
            + size_of::<SystemNode<S, M, D, P>>() * 2
            + size_of::<SystemSums<S, P>>()
            + size_of::<Start<S, D, P>>()
            + size_of::<Register<S, D, P>>() * 2
    }

    /// A cloud of these particles; ids are places.
    pub fn new(particles: impl IntoIterator<Item = Particle<S, D, P>>) -> Self {
        let particles: Vec<_> = particles.into_iter().collect();
        let n = particles.len();
        let nothing = [S::product(S::ZERO, S::ZERO); P];
        let start = Start {
            position: [S::ZERO; D],
            weight: S::ZERO,
            strength: nothing,
        };
        let sum = Settled::new(SystemNode::ZERO, SystemSums::ZERO);
        Self {
            position: particles.iter().map(|p| p.position).collect(),
            weight: particles.iter().map(|p| p.weight).collect(),
            value: particles.iter().map(|p| p.value).collect(),
            strength: vec![nothing; n],
            neighbours: vec![S::ZERO; n],
            sites: vec![Site::EMPTY; n],
            order: vec![0; n],
            cell_of: vec![0; n],
            starts: vec![0; cell_bound(n as u32) as usize + 1],
            nodes: vec![SystemNode::ZERO; n],
            sums: vec![sum; n],
            start: vec![start; n],
            last: vec![Register::ZERO; n],
            sum: vec![Register::ZERO; n],
        }
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (State<'_, S, D, P>, LinearWorkspace<'_, S, M, D, P>) {
        let state = State {
            position: &mut self.position,
            weight: &mut self.weight,
            strength: &mut self.strength,
            value: &mut self.value,
            neighbours: &mut self.neighbours,
        };
        let work = LinearWorkspace {
            cells: CellBuffers {
                sites: &mut self.sites,
                order: &mut self.order,
                cell_of: &mut self.cell_of,
                starts: &mut self.starts,
            },
            grid: None,
            nodes: &mut self.nodes,
            sums: &mut self.sums,
            start: &mut self.start,
            last: &mut self.last,
            sum: &mut self.sum,
        };
        (state, work)
    }
}
