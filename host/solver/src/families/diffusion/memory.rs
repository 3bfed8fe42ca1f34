//! A convection-diffusion problem in the memory of a server.

use motes_core::equation::diffusion::{
    DiffusionNode, DiffusionSums, DiffusionWorkspace, FluxSums, Ledger, MixedNode, MixedWorkspace,
};
use motes_core::equation::linear::{Particle, State};
use motes_core::pairs::{Fields, Settled};
use motes_core::scalar::Scalar;

use crate::families::strengths::CloudArrays;

/// The state of a convection-diffusion problem and the workspace of its solver.
pub(in crate::families) struct DiffusionArrays<S: Scalar, const D: usize, const P: usize> {
    pub cloud: CloudArrays<S, D, P>,
    pub ledger: Ledger<S, D, P>,
    radius: Option<S>,
    nodes: Vec<DiffusionNode<S, D, P>>,
    sums: Vec<Settled<DiffusionNode<S, D, P>, DiffusionSums<S, P>>>,
    stages: Vec<[[S; P]; 3]>,
    fluxes: Vec<Settled<DiffusionNode<S, D, P>, FluxSums<S, D, P>>>,
    mixed_nodes: Vec<MixedNode<S, D, P>>,
    mixed_sums: Vec<Settled<MixedNode<S, D, P>, DiffusionSums<S, P>>>,
}

impl<S: Scalar, const D: usize, const P: usize> DiffusionArrays<S, D, P> {
    /// Bytes that one particle takes, state, workspace of both forms and a typical neighbour list.
    pub const BYTES: usize = CloudArrays::<S, D, P>::BYTES
        + size_of::<DiffusionNode<S, D, P>>() * 3
        + size_of::<DiffusionSums<S, P>>() * 2
        + size_of::<[[S; P]; 3]>()
        + size_of::<FluxSums<S, D, P>>()
        + size_of::<MixedNode<S, D, P>>() * 2;

    /// A cloud of these particles, with memory for both forms where `is_mixed`.
    pub fn new(particles: impl IntoIterator<Item = Particle<S, D, P>>, is_mixed: bool) -> Self {
        let cloud = CloudArrays::new(particles);
        let n = cloud.len();
        let both = if is_mixed { n } else { 0 };
        Self {
            cloud,
            ledger: Ledger::new(),
            radius: None,
            nodes: vec![DiffusionNode::ZERO; n],
            sums: vec![Settled::new(DiffusionNode::ZERO, DiffusionSums::ZERO); n],
            stages: vec![[[S::ZERO; P]; 3]; n],
            fluxes: vec![Settled::new(DiffusionNode::ZERO, FluxSums::ZERO); both],
            mixed_nodes: vec![MixedNode::ZERO; both],
            mixed_sums: vec![Settled::new(MixedNode::ZERO, DiffusionSums::ZERO); both],
        }
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (State<'_, S, D, P>, DiffusionWorkspace<'_, S, D, P>) {
        let (state, cells, registers) = self.cloud.parts();
        let work = DiffusionWorkspace {
            cells,
            grid: &mut registers.grid,
            nodes: &mut self.nodes,
            sums: &mut self.sums,
            start: &mut registers.start,
            last: &mut registers.last,
            time: &mut registers.time,
            radius: &mut self.radius,
            ledger: &mut self.ledger,
            sum: &mut registers.sum,
            stages: &mut self.stages,
            fluxes: &mut self.fluxes,
            mixed: MixedWorkspace {
                nodes: &mut self.mixed_nodes,
                sums: &mut self.mixed_sums,
            },
        };
        (state, work)
    }
}
