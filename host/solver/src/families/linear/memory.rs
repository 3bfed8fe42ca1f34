//! A first-order system in the memory of a server.

use motes_core::equation::linear::{LinearWorkspace, Particle, State, SystemNode, SystemSums};
use motes_core::pairs::{Fields, Settled};
use motes_core::scalar::Scalar;

use crate::families::strengths::CloudArrays;

/// The state of a first-order system and the workspace of its solver.
pub(in crate::families) struct LinearArrays<S: Scalar, M: Fields<S>, const D: usize, const P: usize>
{
    pub cloud: CloudArrays<S, D, P>,
    nodes: Vec<SystemNode<S, M, D, P>>,
    sums: Vec<Settled<SystemNode<S, M, D, P>, SystemSums<S, P>>>,
}

impl<S: Scalar, M: Fields<S>, const D: usize, const P: usize> LinearArrays<S, M, D, P> {
    /// Bytes that one particle takes, state, workspace and a typical neighbour list.
    pub const BYTES: usize = CloudArrays::<S, D, P>::BYTES
        + size_of::<SystemNode<S, M, D, P>>() * 2
        + size_of::<SystemSums<S, P>>();

    /// A cloud of these particles; ids are places.
    pub fn new(particles: impl IntoIterator<Item = Particle<S, D, P>>) -> Self {
        let cloud = CloudArrays::new(particles);
        let n = cloud.len();
        let sum = Settled::new(SystemNode::ZERO, SystemSums::ZERO);
        Self {
            cloud,
            nodes: vec![SystemNode::ZERO; n],
            sums: vec![sum; n],
        }
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (State<'_, S, D, P>, LinearWorkspace<'_, S, M, D, P>) {
        let (state, cells, registers) = self.cloud.parts();
        let work = LinearWorkspace {
            cells,
            grid: &mut registers.grid,
            nodes: &mut self.nodes,
            sums: &mut self.sums,
            start: &mut registers.start,
            last: &mut registers.last,
            sum: &mut registers.sum,
        };
        (state, work)
    }
}
