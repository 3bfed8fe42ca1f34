//! A cloud of strengths in fixed memory: its state, what a step remembers of it, and its cells.

use heapless::Vec;

use super::registers::{Start, remember};
use super::state::{Particle, State};
use crate::error::{Container, Error};
use crate::neighbours::{CellBuffers, Grid, Site};
use crate::numbered::numbered;
use crate::scalar::Scalar;

/// At most `N` particles of `P` components on at most `C - 1` cells.
pub(crate) struct CloudStorage<
    S: Scalar,
    const D: usize,
    const P: usize,
    const N: usize,
    const C: usize,
> {
    arrays: Arrays<S, D, P, N>,
    start: Vec<Start<S, D, P>, N>,
    sites: [Site<S, D>; N],
    order: [u32; N],
    cell_of: [u32; N],
    starts: [u32; C],
    grid: Option<Grid<S, D>>,
    time: S,
}

/// The arrays of the state.
struct Arrays<S: Scalar, const D: usize, const P: usize, const N: usize> {
    position: Vec<[S; D], N>,
    weight: Vec<S, N>,
    value: Vec<[S; P], N>,
    strength: Vec<[S::Wide; P], N>,
    neighbours: [S; N],
}

impl<S: Scalar, const D: usize, const P: usize, const N: usize> Arrays<S, D, P, N> {
    fn state(&mut self) -> State<'_, S, D, P> {
        let n = self.weight.len();
        State {
            position: &mut self.position,
            weight: &mut self.weight,
            strength: &mut self.strength,
            value: &mut self.value,
            neighbours: self.neighbours.get_mut(..n).unwrap_or(&mut []),
        }
    }
}

/// A cloud as a solver takes it.
pub(crate) struct CloudParts<'a, S: Scalar, const D: usize, const P: usize> {
    /// The state.
    pub state: State<'a, S, D, P>,
    /// For the search for partners.
    pub cells: CellBuffers<'a, S, D>,
    /// What it was at the start of a step.
    pub start: &'a mut [Start<S, D, P>],
    /// The geometry of its cells, while it has not moved.
    pub grid: &'a mut Option<Grid<S, D>>,
    /// The time of the rates that were made last.
    pub time: &'a mut S,
}

/// Sets an entry, where there is one.
fn put<T>(array: &mut [T], id: usize, value: T) {
    if let Some(entry) = array.get_mut(id) {
        *entry = value;
    }
}

impl<S: Scalar, const D: usize, const P: usize, const N: usize, const C: usize>
    CloudStorage<S, D, P, N, C>
{
    /// An empty cloud.
    pub const fn new() -> Self {
        Self {
            arrays: Arrays {
                position: Vec::new(),
                weight: Vec::new(),
                value: Vec::new(),
                strength: Vec::new(),
                neighbours: [S::ZERO; N],
            },
            start: Vec::new(),
            sites: [Site::EMPTY; N],
            order: [0; N],
            cell_of: [0; N],
            starts: [0; C],
            grid: None,
            time: S::ZERO,
        }
    }

    /// Adds a particle; its id is the number of particles before it. Error: no room.
    pub fn push(&mut self, particle: Particle<S, D, P>) -> Result<(), Error> {
        let full = Error::Capacity {
            container: Container::Particles,
            needed: (self.arrays.weight.len() as u32).saturating_add(1),
            capacity: N as u32,
        };
        let strength = particle.value.map(|u| S::product(particle.weight, u));
        let start = Start {
            position: particle.position,
            weight: particle.weight,
            strength,
        };
        self.arrays
            .position
            .push(particle.position)
            .map_err(|_| full)?;
        self.arrays.weight.push(particle.weight).map_err(|_| full)?;
        self.arrays.value.push(particle.value).map_err(|_| full)?;
        self.arrays.strength.push(strength).map_err(|_| full)?;
        self.grid = None;
        self.start.push(start).map_err(|_| full)
    }

    /// Removes all particles.
    pub fn clear(&mut self) {
        self.arrays.position.clear();
        self.arrays.weight.clear();
        self.arrays.value.clear();
        self.arrays.strength.clear();
        self.start.clear();
        self.grid = None;
    }

    /// As a solver takes it.
    pub fn parts(&mut self) -> CloudParts<'_, S, D, P> {
        let cells = CellBuffers {
            sites: &mut self.sites,
            order: &mut self.order,
            cell_of: &mut self.cell_of,
            starts: &mut self.starts,
        };
        CloudParts {
            state: self.arrays.state(),
            cells,
            start: &mut self.start,
            grid: &mut self.grid,
            time: &mut self.time,
        }
    }

    /// Removes a particle; the last one gets its id. Does nothing beyond the end.
    pub fn swap_remove(&mut self, id: usize) {
        let Some(last) = self.arrays.weight.len().checked_sub(1) else {
            return;
        };
        if id > last {
            return;
        }
        take_last(&mut self.arrays.position, id);
        take_last(&mut self.arrays.weight, id);
        take_last(&mut self.arrays.value, id);
        take_last(&mut self.arrays.strength, id);
        take_last(&mut self.start, id);
        if let Some(&neighbours) = self.arrays.neighbours.get(last) {
            put(&mut self.arrays.neighbours, id, neighbours);
        }
        self.grid = None;
    }

    /// Remembers the state.
    pub fn keep(&mut self) {
        // There is room for as many as there are particles.
        let _ = remember(&self.arrays.state(), &mut self.start);
    }

    /// Goes back to the state that was remembered. No method writes to what it was at the start of a
    /// step; values are made of strengths and weights, as after every step.
    pub fn restore(&mut self) {
        let mut state = self.arrays.state();
        for (id, start) in numbered(&self.start) {
            let Some(row) = state.row(id) else { break };
            *row.position = start.position;
            *row.weight = start.weight;
            *row.strength = start.strength;
            row.revalue();
        }
        self.grid = None;
    }
}

/// Removes entry `id` of a list in which it is; the last one takes its place.
fn take_last<T, const N: usize>(list: &mut Vec<T, N>, id: usize) {
    if let Some(last) = list.pop() {
        put(list, id, last);
    }
}
