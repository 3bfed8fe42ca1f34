//! All the memory of a linear system in one piece, for a device.

use crate::cloud::{CloudParts, CloudStorage, Particle, Register, State};
use crate::equation::{Dynamics, Parts, Storage};
use crate::error::Error;
use crate::pairs::{Fields, Settled};
use crate::scalar::Scalar;

use super::law::{SystemNode, SystemSums};
use super::storage::LinearWorkspace;

/// A linear system of at most `N` particles on at most `C - 1` cells, with its workspace, in one
/// piece of memory without a heap.
///
/// `C` must exceed [`cell_bound`](crate::neighbours::cell_bound)`(N)`; a `static` one costs no
/// stack.
pub struct LinearStorage<
    S: Scalar,
    M: Fields<S>,
    const D: usize,
    const P: usize,
    const N: usize,
    const C: usize,
> {
    cloud: CloudStorage<S, D, P, N, C>,
    nodes: [SystemNode<S, M, D, P>; N],
    sums: [Settled<SystemNode<S, M, D, P>, SystemSums<S, P>>; N],
    last: [Register<S, D, P>; N],
    sum: [Register<S, D, P>; N],
}

impl<S: Scalar, M: Fields<S>, const D: usize, const P: usize, const N: usize, const C: usize>
    Default for LinearStorage<S, M, D, P, N, C>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, M: Fields<S>, const D: usize, const P: usize, const N: usize, const C: usize>
    LinearStorage<S, M, D, P, N, C>
{
    /// An empty cloud.
    pub const fn new() -> Self {
        Self {
            cloud: CloudStorage::new(),
            nodes: [SystemNode::ZERO; N],
            sums: [Settled::new(SystemNode::ZERO, SystemSums::ZERO); N],
            last: [Register::ZERO; N],
            sum: [Register::ZERO; N],
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

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (State<'_, S, D, P>, LinearWorkspace<'_, S, M, D, P>) {
        let CloudParts {
            state,
            cells,
            start,
            grid,
            ..
        } = self.cloud.parts();
        let work = LinearWorkspace {
            cells,
            grid,
            nodes: &mut self.nodes,
            sums: &mut self.sums,
            start,
            last: &mut self.last,
            sum: &mut self.sum,
        };
        (state, work)
    }
}

impl<S, M, Y, const D: usize, const P: usize, const N: usize, const C: usize> Storage<S, Y, D>
    for LinearStorage<S, M, D, P, N, C>
where
    S: Scalar,
    M: Fields<S>,
    Y: for<'a> Dynamics<
            S,
            D,
            State<'a> = State<'a, S, D, P>,
            Work<'a> = LinearWorkspace<'a, S, M, D, P>,
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
    }
    fn restore(&mut self) {
        self.cloud.restore();
    }
}
