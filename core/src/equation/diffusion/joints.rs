//! Where layers meet: what a pair conducts that sees a joint between its particles.
//!
//! The law of all pairs knows the two ends of a way. Between layers the conductance is that of the
//! way, resistances in a row, so that a layer thinner than the spacing counts as much as it resists: with
//! it the steady profile through layers is exact on a lattice, whatever they are. Few pairs see a
//! joint; they are visited once more, and the others keep their loop.

use super::conductor::in_series;
use super::direct::Direct;
use super::dynamics::DiffusionDynamics;
use super::mean::Mean;
use super::node::{DiffusionNode, DiffusionSums};
use super::problem::DiffusionProblem;
use crate::cloud::VelocityField;
use crate::cutoff::CutOff;
use crate::domain::Axis;
use crate::neighbours::{Cells, Image, code};
use crate::pairs::{Partner, Settled, each_image, each_partner};
use crate::scalar::Scalar;

impl<S, C, B, A, const D: usize, const P: usize> DiffusionDynamics<S, C, B, A, D, P>
where
    S: Scalar,
    C: CutOff,
    B: DiffusionProblem<S, D, P>,
    A: VelocityField<S, D>,
{
    /// `b` of the way from a particle to its partner, each by itself on the way to a side through which
    /// they see each other; `None` where `b` is smooth.
    pub(super) fn way(
        &self,
        [k, l]: [&DiffusionNode<S, D, P>; 2],
        image: &Image<D>,
        time: S,
    ) -> Option<[S; P]> {
        let (axis, seen) = (self.domain.axes.first()?, *image.0.first()?);
        let (x_k, x_l) = (*k.position.first()?, *l.position.first()?);
        let [end_k, end_l] = match seen {
            code::DIRECT => return self.problem.between([x_k, x_l], time),
            code::LOW => [axis.upper, axis.lower],
            code::HIGH => [axis.lower, axis.upper],
            code::LOWER_WALL => [axis.lower; 2],
            _ => [axis.upper; 2],
        };
        let from_k = self.problem.between([x_k, end_k], time)?;
        let from_l = self.problem.between([x_l, end_l], time)?;
        let (to_k, to_l) = ((x_k - end_k).abs(), (x_l - end_l).abs());
        let mut way = from_k;
        for (b, other) in way.iter_mut().zip(from_l) {
            *b = in_series([(*b, to_k), (other, to_l)]);
        }
        Some(way)
    }

    /// `b` of the way from a particle to a wall at that position across direction `axis`.
    pub(super) fn way_out(
        &self,
        node: &DiffusionNode<S, D, P>,
        (axis, wall): (usize, S),
        time: S,
    ) -> [S; P] {
        let along_x = self.mean == Mean::Harmonic && axis == 0;
        let x = node.position.first().filter(|_| along_x);
        let way = x.and_then(|&x| self.problem.between([x, wall], time));
        way.unwrap_or(node.diffusivity)
    }

    /// Twice `b` between a particle and its partner.
    pub(super) fn twice(
        &self,
        pair: [&DiffusionNode<S, D, P>; 2],
        image: &Image<D>,
        time: S,
    ) -> [S; P] {
        let way = match self.mean {
            Mean::Harmonic => self.way(pair, image, time),
            Mean::Arithmetic => None,
        };
        if let Some(way) = way {
            return way.map(|b| b + b);
        }
        let mut twice = pair[0].diffusivity;
        for (b, &other) in twice.iter_mut().zip(&pair[1].diffusivity) {
            *b = self.mean.twice(*b, other);
        }
        twice
    }

    /// Adds what pairs across joints conduct beside what the law of all pairs takes them to.
    #[inline(never)]
    pub(super) fn join(
        &self,
        law: &Direct<S, C, D, P>,
        cells: &Cells<'_, S, D>,
        nodes: &[DiffusionNode<S, D, P>],
        settled: &mut [Settled<DiffusionNode<S, D, P>, DiffusionSums<S, P>>],
        time: S,
    ) {
        if self.mean != Mean::Harmonic {
            return;
        }
        for (place, settled) in (0..nodes.len()).zip(settled) {
            if !self.is_near_joint(&settled.node, time) {
                continue;
            }
            let k = settled.node;
            let mut add = |partner: &Partner<S, D>| {
                let Some(l) = nodes.get(partner.place) else {
                    return;
                };
                let Some(way) = self.way([&k, l], &partner.image, time) else {
                    return;
                };
                let bracket = law.bracket(&partner.apart(law, law.scale));
                let factor = (k.weight * l.weight) * bracket;
                let (mut most, mut taken) = (S::ZERO, S::ZERO);
                for j in 0..P {
                    let (b, mean) = (
                        way[j] + way[j],
                        self.mean.twice(k.diffusivity[j], l.diffusivity[j]),
                    );
                    let difference = l.value[j] - k.value[j];
                    settled.sums.rate[j] += factor * ((b - mean) * difference);
                    (most, taken) = (most.greater(b), taken.greater(mean));
                }
                let size = law.size(bracket);
                settled.sums.radius += l.weight * (size * most) - l.weight * (size * taken);
            };
            each_partner(cells, place, &mut add);
            each_image(cells, place, &mut add);
        }
    }

    /// Whether a joint may lie on the way to a partner.
    fn is_near_joint(&self, node: &DiffusionNode<S, D, P>, time: S) -> bool {
        let (Some(&x), Some(axis)) = (node.position.first(), self.domain.axes.first()) else {
            return false;
        };
        let reach = self.reach();
        let Some(around) = self.problem.between([x - reach, x + reach], time) else {
            return false;
        };
        let near_end = |axis: &Axis<S>| x - axis.lower < reach || axis.upper - x < reach;
        // The two ends of a period may meet in a joint.
        around != node.diffusivity || axis.is_periodic() && near_end(axis)
    }
}
