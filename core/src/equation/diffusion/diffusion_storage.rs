//! All the memory of a convection-diffusion problem in one piece, for a device.

use super::ledger::Ledger;
use super::mixed::{FluxSums, MixedNode};
use super::node::{DiffusionNode, DiffusionSums};
use super::storage::{DiffusionWorkspace, MixedWorkspace};
use crate::cloud::{CloudParts, CloudStorage, Particle, Register, State};
use crate::equation::{Dynamics, Parts, Storage};
use crate::error::Error;
use crate::pairs::{Fields, Settled};
use crate::scalar::Scalar;

/// A problem of at most `N` particles on at most `C - 1` cells, with the workspace of the direct form
/// and the stabilised method, in one piece of memory without a heap.
///
/// `C` above [`cell_bound`](crate::neighbours::cell_bound)`(N)` is enough for any cloud; between two
/// ends one above the cells of [`Grid::fit`](crate::neighbours::Grid::fit) is. A `static` one costs no stack.
pub struct DirectStorage<S: Scalar, const D: usize, const P: usize, const N: usize, const C: usize>
{
    cloud: CloudStorage<S, D, P, N, C>,
    nodes: [DiffusionNode<S, D, P>; N],
    sums: [Settled<DiffusionNode<S, D, P>, DiffusionSums<S, P>>; N],
    last: [Register<S, D, P>; N],
    stages: [[[S; P]; 3]; N],
    radius: Option<S>,
    ledger: Ledger<S, D, P>,
}

impl<S: Scalar, const D: usize, const P: usize, const N: usize, const C: usize> Default
    for DirectStorage<S, D, P, N, C>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const D: usize, const P: usize, const N: usize, const C: usize>
    DirectStorage<S, D, P, N, C>
{
    /// An empty cloud.
    pub const fn new() -> Self {
        Self {
            cloud: CloudStorage::new(),
            nodes: [DiffusionNode::ZERO; N],
            sums: [Settled::new(DiffusionNode::ZERO, DiffusionSums::ZERO); N],
            last: [Register::ZERO; N],
            stages: [[[S::ZERO; P]; 3]; N],
            radius: None,
            ledger: Ledger::new(),
        }
    }

    /// Adds a particle; its id is the number of particles before it. Error: no room.
    pub fn push(&mut self, particle: Particle<S, D, P>) -> Result<(), Error> {
        self.cloud.push(particle)
    }

    /// Removes all particles.
    pub fn clear(&mut self) {
        self.cloud.clear();
    }

    /// The state and the workspace, as the solver takes them. With a Runge-Kutta method or the
    /// mixed form a step then fails: [`Error::Lengths`].
    pub fn parts(&mut self) -> (State<'_, S, D, P>, DiffusionWorkspace<'_, S, D, P>) {
        let CloudParts {
            state,
            cells,
            start,
            grid,
            time,
        } = self.cloud.parts();
        let work = DiffusionWorkspace {
            cells,
            grid,
            nodes: &mut self.nodes,
            sums: &mut self.sums,
            start,
            last: &mut self.last,
            time,
            radius: &mut self.radius,
            ledger: &mut self.ledger,
            sum: &mut [],
            stages: &mut self.stages,
            fluxes: &mut [],
            mixed: MixedWorkspace {
                nodes: &mut [],
                sums: &mut [],
            },
        };
        (state, work)
    }
}

/// A [`DirectStorage`] with the workspace of both forms and all methods.
pub struct DiffusionStorage<
    S: Scalar,
    const D: usize,
    const P: usize,
    const N: usize,
    const C: usize,
> {
    direct: DirectStorage<S, D, P, N, C>,
    sum: [Register<S, D, P>; N],
    fluxes: [Settled<DiffusionNode<S, D, P>, FluxSums<S, D, P>>; N],
    mixed_nodes: [MixedNode<S, D, P>; N],
    mixed_sums: [Settled<MixedNode<S, D, P>, DiffusionSums<S, P>>; N],
}

impl<S: Scalar, const D: usize, const P: usize, const N: usize, const C: usize> Default
    for DiffusionStorage<S, D, P, N, C>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const D: usize, const P: usize, const N: usize, const C: usize>
    DiffusionStorage<S, D, P, N, C>
{
    /// An empty cloud.
    pub const fn new() -> Self {
        Self {
            direct: DirectStorage::new(),
            sum: [Register::ZERO; N],
            fluxes: [Settled::new(DiffusionNode::ZERO, FluxSums::ZERO); N],
            mixed_nodes: [MixedNode::ZERO; N],
            mixed_sums: [Settled::new(MixedNode::ZERO, DiffusionSums::ZERO); N],
        }
    }

    /// Adds a particle; its id is the number of particles before it. Error: no room.
    pub fn push(&mut self, particle: Particle<S, D, P>) -> Result<(), Error> {
        self.direct.push(particle)
    }

    /// Removes all particles.
    pub fn clear(&mut self) {
        self.direct.clear();
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (State<'_, S, D, P>, DiffusionWorkspace<'_, S, D, P>) {
        let (state, work) = self.direct.parts();
        let work = DiffusionWorkspace {
            sum: &mut self.sum,
            fluxes: &mut self.fluxes,
            mixed: MixedWorkspace {
                nodes: &mut self.mixed_nodes,
                sums: &mut self.mixed_sums,
            },
            ..work
        };
        (state, work)
    }
}

impl<S, Y, const D: usize, const P: usize, const N: usize, const C: usize> Storage<S, Y, D>
    for DirectStorage<S, D, P, N, C>
where
    S: Scalar,
    Y: for<'a> Dynamics<
            S,
            D,
            State<'a> = State<'a, S, D, P>,
            Work<'a> = DiffusionWorkspace<'a, S, D, P>,
            Particle = Particle<S, D, P>,
        >,
{
    fn parts(&mut self) -> Parts<'_, S, Y, D> {
        let (state, work) = self.parts();
        Parts { state, work }
    }
    fn insert(&mut self, particle: Particle<S, D, P>) -> Result<(), Error> {
        self.push(particle)
    }
    fn swap_remove(&mut self, id: usize) {
        self.cloud.swap_remove(id);
    }
    fn keep(&mut self) {
        self.cloud.keep();
        self.ledger.start();
    }
    fn restore(&mut self) {
        self.cloud.restore();
        self.ledger.restore();
    }
}

impl<S, Y, const D: usize, const P: usize, const N: usize, const C: usize> Storage<S, Y, D>
    for DiffusionStorage<S, D, P, N, C>
where
    S: Scalar,
    Y: for<'a> Dynamics<
            S,
            D,
            State<'a> = State<'a, S, D, P>,
            Work<'a> = DiffusionWorkspace<'a, S, D, P>,
            Particle = Particle<S, D, P>,
        >,
{
    fn parts(&mut self) -> Parts<'_, S, Y, D> {
        let (state, work) = self.parts();
        Parts { state, work }
    }
    fn insert(&mut self, particle: Particle<S, D, P>) -> Result<(), Error> {
        self.push(particle)
    }
    fn swap_remove(&mut self, id: usize) {
        self.direct.cloud.swap_remove(id);
    }
    fn keep(&mut self) {
        self.direct.cloud.keep();
        self.direct.ledger.start();
    }
    fn restore(&mut self) {
        self.direct.cloud.restore();
        self.direct.ledger.restore();
    }
}
