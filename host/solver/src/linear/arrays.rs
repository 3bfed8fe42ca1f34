//! Clouds of strengths in the memory of a server.

use motes_core::equation::diffusion::{
    DiffusionNode, DiffusionSums, DiffusionWorkspace, FluxSums, MixedNode, MixedWorkspace,
};
use motes_core::equation::linear::{
    LinearWorkspace, Particle, Register, Start, State, SystemNode, SystemSums,
};
use motes_core::neighbours::{CellBuffers, Grid, Site, cell_bound};
use motes_core::pairs::{Fields, Settled};
use motes_core::scalar::Scalar;

/// What every solver needs: the state, the search for neighbours, the registers of a step.
struct CloudArrays<S: Scalar, const D: usize, const P: usize> {
    position: Vec<[S; D]>,
    weight: Vec<S>,
    value: Vec<[S; P]>,
    strength: Vec<[S::Wide; P]>,
    neighbours: Vec<S>,
    sites: Vec<Site<S, D>>,
    order: Vec<u32>,
    cell_of: Vec<u32>,
    starts: Vec<u32>,
    registers: Registers<S, D, P>,
}

/// The registers of a step.
struct Registers<S: Scalar, const D: usize, const P: usize> {
    start: Vec<Start<S, D, P>>,
    last: Vec<Register<S, D, P>>,
    sum: Vec<Register<S, D, P>>,
    /// The geometry of the cells, while the particles have not moved.
    grid: Option<Grid<S, D>>,
    /// The time of the rates that were made last.
    time: S,
}

impl<S: Scalar, const D: usize, const P: usize> CloudArrays<S, D, P> {
    /// Bytes that one particle takes, with a typical neighbour list.
    fn bytes_per_particle() -> usize {
        size_of::<[S; D]>()
            + size_of::<S>() * (2 + P)
            + size_of::<S::Wide>() * P
            + size_of::<Site<S, D>>()
            + size_of::<u32>() * (6 + 16)
            + size_of::<Start<S, D, P>>()
            + size_of::<Register<S, D, P>>() * 2
    }

    fn new(particles: &[Particle<S, D, P>]) -> Self {
        let n = particles.len();
        let nothing = [S::product(S::ZERO, S::ZERO); P];
        let start = Start {
            position: [S::ZERO; D],
            weight: S::ZERO,
            strength: nothing,
        };
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
            registers: Registers {
                start: vec![start; n],
                last: vec![Register::ZERO; n],
                sum: vec![Register::ZERO; n],
                grid: None,
                time: S::ZERO,
            },
        }
    }

    fn parts(&mut self) -> Parts<'_, S, D, P> {
        let state = State {
            position: &mut self.position,
            weight: &mut self.weight,
            strength: &mut self.strength,
            value: &mut self.value,
            neighbours: &mut self.neighbours,
        };
        let cells = CellBuffers {
            sites: &mut self.sites,
            order: &mut self.order,
            cell_of: &mut self.cell_of,
            starts: &mut self.starts,
        };
        (state, cells, &mut self.registers)
    }
}

type Parts<'a, S, const D: usize, const P: usize> = (
    State<'a, S, D, P>,
    CellBuffers<'a, S, D>,
    &'a mut Registers<S, D, P>,
);

/// The state of a first-order system and the workspace of its solver.
pub(super) struct LinearArrays<S: Scalar, M: Fields<S>, const D: usize, const P: usize> {
    cloud: CloudArrays<S, D, P>,
    nodes: Vec<SystemNode<S, M, D, P>>,
    sums: Vec<Settled<SystemNode<S, M, D, P>, SystemSums<S, P>>>,
}

impl<S: Scalar, M: Fields<S>, const D: usize, const P: usize> LinearArrays<S, M, D, P> {
    /// Bytes that one particle takes, state, workspace and a typical neighbour list.
    pub fn bytes_per_particle() -> usize {
        CloudArrays::<S, D, P>::bytes_per_particle()
            + size_of::<SystemNode<S, M, D, P>>() * 2
            + size_of::<SystemSums<S, P>>()
    }

    /// A cloud of these particles; ids are places.
    pub fn new(particles: &[Particle<S, D, P>]) -> Self {
        let n = particles.len();
        let sum = Settled::new(SystemNode::ZERO, SystemSums::ZERO);
        Self {
            cloud: CloudArrays::new(particles),
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

/// The state of a convection-diffusion problem and the workspace of its solver.
pub(super) struct DiffusionArrays<S: Scalar, const D: usize, const P: usize> {
    cloud: CloudArrays<S, D, P>,
    nodes: Vec<DiffusionNode<S, D, P>>,
    sums: Vec<Settled<DiffusionNode<S, D, P>, DiffusionSums<S, P>>>,
    stages: Vec<[[S; P]; 3]>,
    fluxes: Vec<Settled<DiffusionNode<S, D, P>, FluxSums<S, D, P>>>,
    mixed_nodes: Vec<MixedNode<S, D, P>>,
    mixed_sums: Vec<Settled<MixedNode<S, D, P>, DiffusionSums<S, P>>>,
}

impl<S: Scalar, const D: usize, const P: usize> DiffusionArrays<S, D, P> {
    /// Bytes that one particle takes, state, workspace of both forms and a typical neighbour list.
    pub fn bytes_per_particle() -> usize {
        CloudArrays::<S, D, P>::bytes_per_particle()
            + size_of::<DiffusionNode<S, D, P>>() * 3
            + size_of::<DiffusionSums<S, P>>() * 2
            + size_of::<[[S; P]; 3]>()
            + size_of::<FluxSums<S, D, P>>()
            + size_of::<MixedNode<S, D, P>>() * 2
    }

    /// A cloud of these particles, with memory for both forms where `is_mixed`.
    pub fn new(particles: &[Particle<S, D, P>], is_mixed: bool) -> Self {
        let n = particles.len();
        let both = if is_mixed { n } else { 0 };
        Self {
            cloud: CloudArrays::new(particles),
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
