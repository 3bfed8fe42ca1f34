//! Clouds of strengths in the memory of a server.

use motes_core::equation::linear::{Particle, Register, Start, State};
use motes_core::neighbours::{CellBuffers, Grid, Site, cell_bound};
use motes_core::scalar::Scalar;

use super::solver::{CloudView, row};

/// What every solver needs: the state, the search for neighbours, the registers of a step.
pub(in crate::families) struct CloudArrays<S: Scalar, const D: usize, const P: usize> {
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
pub(in crate::families) struct Registers<S: Scalar, const D: usize, const P: usize> {
    pub start: Vec<Start<S, D, P>>,
    pub last: Vec<Register<S, D, P>>,
    pub sum: Vec<Register<S, D, P>>,
    /// The geometry of the cells, while the particles have not moved.
    pub grid: Option<Grid<S, D>>,
    /// The time of the rates that were made last.
    pub time: S,
}

impl<S: Scalar, const D: usize, const P: usize> CloudArrays<S, D, P> {
    /// Bytes that one particle takes, with a typical neighbour list.
    pub const BYTES: usize = size_of::<[S; D]>()
        + size_of::<S>() * (2 + P)
        + size_of::<S::Wide>() * P
        + size_of::<Site<S, D>>()
        + size_of::<u32>() * (6 + 16)
        + size_of::<Start<S, D, P>>()
        + size_of::<Register<S, D, P>>() * 2;

    /// How many particles there are.
    pub fn len(&self) -> usize {
        self.weight.len()
    }

    /// A cloud of these particles; ids are places.
    pub fn new(particles: impl IntoIterator<Item = Particle<S, D, P>>) -> Self {
        let particles = particles.into_iter();
        let most = particles.size_hint().0;
        let (mut position, mut weight) = (Vec::with_capacity(most), Vec::with_capacity(most));
        let mut value = Vec::with_capacity(most);
        // What they come from is gone before the workspace is there.
        particles.for_each(|particle| {
            position.push(particle.position);
            weight.push(particle.weight);
            value.push(particle.value);
        });
        let n = weight.len();
        let nothing = [S::product(S::ZERO, S::ZERO); P];
        let start = Start {
            position: [S::ZERO; D],
            weight: S::ZERO,
            strength: nothing,
        };
        Self {
            position,
            weight,
            value,
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

    /// What there is to see.
    pub fn view(&self) -> CloudView<'_, S> {
        CloudView {
            dimension: D,
            components: P,
            position: self.position.as_flattened(),
            weight: &self.weight,
            value: self.value.as_flattened(),
            strength: self.strength.as_flattened(),
            neighbours: &self.neighbours,
        }
    }

    /// Some points in the dimension of the cloud; the particles' without any.
    pub fn points(&self, points: Option<&[[S; 3]]>) -> Vec<[S; D]> {
        let Some(points) = points else {
            return self.position.clone();
        };
        points.iter().map(|x| row(x)).collect()
    }

    /// The state, and what is worked in.
    pub fn parts(&mut self) -> Parts<'_, S, D, P> {
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

pub(in crate::families) type Parts<'a, S, const D: usize, const P: usize> = (
    State<'a, S, D, P>,
    CellBuffers<'a, S, D>,
    &'a mut Registers<S, D, P>,
);
