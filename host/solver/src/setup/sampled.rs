//! Particles of equal mass, as dense as a profile.
//!
//! The Knothe-Rosenblatt map (Rosenblatt, Ann. Math. Stat. 23 (1952) 470) of a lattice of
//! the unit cube: x such that the mass below it has the lattice point's first coordinate for
//! its part of the whole; then y likewise along the line at that x, then z. In one dimension
//! each particle stands at the median of its own mass.

use super::SetupError;
use super::block::{Block, room, spacing};
use crate::exact::flow::FlowState;

/// Points of equal mass, about as many as asked for (in one dimension exactly), and the mass
/// of one.
pub(super) fn points(
    block: &Block,
    particles: usize,
    state: &dyn Fn([f64; 3]) -> FlowState,
) -> Result<(Vec<[f64; 3]>, f64), SetupError> {
    let edge = spacing(block.volume() / particles as f64, block.dimension);
    let counts = [0, 1, 2].map(|i| match (block.dimension, i) {
        (1, 0) => particles,
        (dimension, i) if i < dimension => block.fitted(i, edge),
        _ => 1,
    });
    let mut sampler = Sampler {
        block,
        state,
        counts,
        points: room(counts, particles as f64)?,
    };
    let mass = sampler.marginal([0.0; 3], 0);
    sampler.place([0.0; 3], 0);
    let points = sampler.points;
    let mass = mass / points.len() as f64;
    Ok((points, mass))
}

/// Cells of the quadrature along each direction. The densities between two nodes are a
/// straight line: errors are of second order in 1/cells.
const CELLS: [usize; 3] = [16_384, 1024, 64];

struct Sampler<'a> {
    block: &'a Block,
    state: &'a dyn Fn([f64; 3]) -> FlowState,
    counts: [usize; 3],
    points: Vec<[f64; 3]>,
}

impl Sampler<'_> {
    /// The density integrated over the directions from `axis` on, at `point` in the others.
    fn marginal(&self, point: [f64; 3], axis: usize) -> f64 {
        if axis == self.block.dimension {
            return (self.state)(point).density;
        }
        let nodes = self.nodes(point, axis);
        let width = self.block.length(axis) / (nodes.len() - 1) as f64;
        nodes
            .windows(2)
            .map(|ends| 0.5 * (ends[0] + ends[1]))
            .sum::<f64>()
            * width
    }

    /// The marginal densities at the nodes along `axis`.
    fn nodes(&self, mut point: [f64; 3], axis: usize) -> Vec<f64> {
        let cells = CELLS[self.block.dimension - 1];
        let node = |i: usize| {
            point[axis] = self.block.at(axis, i as f64, cells);
            self.marginal(point, axis + 1)
        };
        (0..=cells).map(node).collect()
    }

    /// Places the points of all lines from `axis` on, at `point` in the other directions.
    fn place(&mut self, mut point: [f64; 3], axis: usize) {
        if axis == self.block.dimension {
            self.points.push(point);
            return;
        }
        let nodes = self.nodes(point, axis);
        for place in medians(&nodes, self.counts[axis]) {
            point[axis] = self.block.at(axis, place, nodes.len() - 1);
            self.place(point, axis + 1);
        }
    }
}

/// The places, in cells, below which lie `(k + 1/2)/count` of the integral of the function
/// that joins the nodes by straight lines, `k` from 0 to `count - 1`.
fn medians(nodes: &[f64], count: usize) -> Vec<f64> {
    let cell = |i: usize| 0.5 * (nodes[i] + nodes[i + 1]);
    let total: f64 = (0..nodes.len() - 1).map(cell).sum();
    let (mut i, mut below) = (0, 0.0);
    let median = |k: usize| {
        let wanted = (k as f64 + 0.5) / count as f64 * total;
        while i + 2 < nodes.len() && below + cell(i) < wanted {
            below += cell(i);
            i += 1;
        }
        // nodes[i] t + (nodes[i+1] - nodes[i]) t^2/2 = rest, in the form without cancellation.
        let (rest, rise) = (wanted - below, nodes[i + 1] - nodes[i]);
        let root = (nodes[i] * nodes[i] + 2.0 * rise * rest).max(0.0).sqrt();
        i as f64 + (2.0 * rest / (nodes[i] + root)).clamp(0.0, 1.0)
    };
    (0..count).map(median).collect()
}
