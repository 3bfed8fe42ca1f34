//! The memory of a linear system: what a step works in, and all of it in one piece for a device.

use heapless::Vec;

use crate::error::{Container, Error};
use crate::neighbours::{CellBuffers, Grid, Site};
use crate::pairs::{Fields, Settled};
use crate::scalar::Scalar;

use super::law::{SystemNode, SystemSums};
use super::state::{Particle, State};

/// Rates of a particle, or a sum of them: `dx/dt`, `dw/dt`, `ε dq/dt`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Register<S, const D: usize, const P: usize> {
    /// Of the position: `a`.
    pub position: [S; D],
    /// Of the weight: `w div a`.
    pub weight: S,
    /// Of the strength, times ε.
    pub strength: [S; P],
}

impl<S: Scalar, const D: usize, const P: usize> Register<S, D, P> {
    /// No rates.
    pub const ZERO: Self = Self {
        position: [S::ZERO; D],
        weight: S::ZERO,
        strength: [S::ZERO; P],
    };

    /// Adds `n` times other rates, by repeated sums: exact in fixed point.
    pub(crate) fn add(&mut self, n: u32, rates: &Self) {
        for _ in 0..n {
            for (sum, &rate) in self.position.iter_mut().zip(&rates.position) {
                *sum += rate;
            }
            self.weight += rates.weight;
            for (sum, &rate) in self.strength.iter_mut().zip(&rates.strength) {
                *sum += rate;
            }
        }
    }
}

/// What a particle was at the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<S: Scalar, const D: usize, const P: usize> {
    /// Its position.
    pub position: [S; D],
    /// Its weight.
    pub weight: S,
    /// Its strength.
    pub strength: [S::Wide; P],
}

/// Memory that a step works in. All but `starts` of the cells hold as many as there are
/// particles.
pub struct LinearWorkspace<'a, S: Scalar, M: Fields<S>, const D: usize, const P: usize> {
    /// For the search for partners.
    pub cells: CellBuffers<'a, S, D>,
    /// The geometry of the cells, while the particles have not moved.
    pub grid: Option<Grid<S, D>>,
    /// Nodes, in sorted order.
    pub nodes: &'a mut [SystemNode<S, M, D, P>],
    /// Sums over pairs, in sorted order.
    pub sums: &'a mut [Settled<SystemNode<S, M, D, P>, SystemSums<S, P>>],
    /// The state at the start of a step.
    pub start: &'a mut [Start<S, D, P>],
    /// The rates that were made last.
    pub last: &'a mut [Register<S, D, P>],
    /// The weighted sum of the rates of a step.
    pub sum: &'a mut [Register<S, D, P>],
}

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
    position: Vec<[S; D], N>,
    weight: Vec<S, N>,
    value: Vec<[S; P], N>,
    strength: Vec<[S::Wide; P], N>,
    neighbours: [S; N],
    sites: [Site<S, D>; N],
    order: [u32; N],
    cell_of: [u32; N],
    starts: [u32; C],
    nodes: [SystemNode<S, M, D, P>; N],
    sums: [Settled<SystemNode<S, M, D, P>, SystemSums<S, P>>; N],
    start: Vec<Start<S, D, P>, N>,
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
            position: Vec::new(),
            weight: Vec::new(),
            value: Vec::new(),
            strength: Vec::new(),
            neighbours: [S::ZERO; N],
            sites: [Site::EMPTY; N],
            order: [0; N],
            cell_of: [0; N],
            starts: [0; C],
            nodes: [SystemNode::ZERO; N],
            sums: [Settled::new(SystemNode::ZERO, SystemSums::ZERO); N],
            start: Vec::new(),
            last: [Register::ZERO; N],
            sum: [Register::ZERO; N],
        }
    }

    /// Adds a particle; its id is the number of particles before it. Error: no room.
    pub fn push(&mut self, particle: Particle<S, D, P>) -> Result<(), Error> {
        let full = Error::Capacity {
            container: Container::Particles,
            needed: self.weight.len() as u32 + 1,
            capacity: N as u32,
        };
        let strength = particle.value.map(|u| S::product(particle.weight, u));
        let start = Start {
            position: particle.position,
            weight: particle.weight,
            strength,
        };
        self.position.push(particle.position).map_err(|_| full)?;
        self.weight.push(particle.weight).map_err(|_| full)?;
        self.value.push(particle.value).map_err(|_| full)?;
        self.strength.push(strength).map_err(|_| full)?;
        self.start.push(start).map_err(|_| full)
    }

    /// Removes all particles.
    pub fn clear(&mut self) {
        self.position.clear();
        self.weight.clear();
        self.value.clear();
        self.strength.clear();
        self.start.clear();
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (State<'_, S, D, P>, LinearWorkspace<'_, S, M, D, P>) {
        let n = self.weight.len();
        let state = State {
            position: &mut self.position,
            weight: &mut self.weight,
            strength: &mut self.strength,
            value: &mut self.value,
            neighbours: self.neighbours.get_mut(..n).unwrap_or(&mut []),
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
