//! A cloud of strengths in fixed memory: its state, what a step remembers of it, and its cells.

use heapless::Vec;

use super::state::{Particle, State};
use super::storage::Start;
use crate::error::{Container, Error};
use crate::neighbours::{CellBuffers, Site};
use crate::scalar::Scalar;

/// At most `N` particles of `P` components on at most `C - 1` cells.
pub(crate) struct CloudStorage<
    S: Scalar,
    const D: usize,
    const P: usize,
    const N: usize,
    const C: usize,
> {
    position: Vec<[S; D], N>,
    weight: Vec<S, N>,
    value: Vec<[S; P], N>,
    strength: Vec<[S::Wide; P], N>,
    start: Vec<Start<S, D, P>, N>,
    neighbours: [S; N],
    sites: [Site<S, D>; N],
    order: [u32; N],
    cell_of: [u32; N],
    starts: [u32; C],
}

/// A cloud as a solver takes it: state, cells, and what it was at the start of a step.
pub(crate) type CloudParts<'a, S, const D: usize, const P: usize> = (
    State<'a, S, D, P>,
    CellBuffers<'a, S, D>,
    &'a mut [Start<S, D, P>],
);

impl<S: Scalar, const D: usize, const P: usize, const N: usize, const C: usize>
    CloudStorage<S, D, P, N, C>
{
    /// An empty cloud.
    pub const fn new() -> Self {
        Self {
            position: Vec::new(),
            weight: Vec::new(),
            value: Vec::new(),
            strength: Vec::new(),
            start: Vec::new(),
            neighbours: [S::ZERO; N],
            sites: [Site::EMPTY; N],
            order: [0; N],
            cell_of: [0; N],
            starts: [0; C],
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

    /// As a solver takes it.
    pub fn parts(&mut self) -> CloudParts<'_, S, D, P> {
        let n = self.weight.len();
        let state = State {
            position: &mut self.position,
            weight: &mut self.weight,
            strength: &mut self.strength,
            value: &mut self.value,
            neighbours: self.neighbours.get_mut(..n).unwrap_or(&mut []),
        };
        let cells = CellBuffers {
            sites: &mut self.sites,
            order: &mut self.order,
            cell_of: &mut self.cell_of,
            starts: &mut self.starts,
        };
        (state, cells, &mut self.start)
    }
}
