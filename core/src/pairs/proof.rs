//! Proofs that the sums over pairs stay in the range of a format that wraps.
//!
//! Before the sums of a law are made, the largest of what the particles show, the reach and the largest
//! number of partners bound every sum and product on the way: see [`Law::proof`](super::Law::proof).

use super::law::{Fields, Law, Separation};
use crate::cutoff::{Parts, Peaks, Shape, Shapes};
use crate::domain::Wall;
use crate::error::{Error, Quantity};
use crate::neighbours::Cells;
use crate::numbered::numbered;
use crate::scalar::{Interval, Scalar};

/// A bound, and the place in sorted order of the particle that it comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Largest {
    /// The bound; not below 0.
    pub bound: f64,
    /// Where.
    pub place: usize,
}

impl Largest {
    /// Takes another one in, if it is larger or no number.
    #[inline(always)]
    pub fn see(&mut self, place: usize, bound: f64) {
        if !(bound <= self.bound) {
            *self = Self { bound, place };
        }
    }

    /// The same times a factor.
    pub fn times(self, factor: f64) -> Self {
        Self {
            bound: self.bound * factor,
            ..self
        }
    }
}

/// Refuses a bound that the format does not hold; bounds are kept from rounding by one in a thousand.
pub fn holds<S: Scalar>(quantity: Quantity, particle: u32, bound: f64) -> Result<(), Error> {
    if !S::WRAPS || bound < 0.999 * S::LARGEST.to_f64() {
        return Ok(());
    }
    let (mut integer_bits, mut range) = (0, 0.999);
    while !(bound < range) && integer_bits < 127 {
        (integer_bits, range) = (integer_bits + 1, range + range);
    }
    Err(Error::Unproven {
        particle,
        quantity,
        integer_bits,
    })
}

/// A sorted cloud as a proof sees it.
pub struct Ground<'a, 'c, S, const D: usize> {
    /// The cloud.
    pub cells: &'a Cells<'c, S, D>,
    /// No particle has more partners.
    pub partners: f64,
    /// The largest distance of a pair.
    pub reach: f64,
}

impl<'a, 'c, S: Scalar, const D: usize> Ground<'a, 'c, S, D> {
    /// That of a cloud.
    pub fn of(cells: &'a Cells<'c, S, D>) -> Self {
        let squares = cells.sites().iter().map(|site| site.reach_squared);
        let squared = squares.reduce(Scalar::greater).unwrap_or(S::ZERO);
        Self {
            cells,
            partners: cells.most_partners() as f64,
            // A unit of the last place for the rounding of the square.
            reach: libm::sqrt(squared.to_f64()) + S::TINIEST.to_f64(),
        }
    }

    /// Refuses a bound that the format does not hold.
    pub fn holds(&self, quantity: Quantity, largest: Largest) -> Result<(), Error> {
        let id = self.cells.order().get(largest.place).copied();
        holds::<S>(quantity, id.unwrap_or(0), largest.bound)
    }
}

/// Evaluates a law once, over the intervals of all that its particles and their images show: every sum
/// and product on the way is in what comes out.
pub fn by_intervals<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    ground: &Ground<'_, '_, S, D>,
    nodes: &[W::Node],
) -> Result<(), Error> {
    by_intervals_of(law, ground, nodes, |node, wall| law.reflected(node, wall))
}

/// The same where other images than those of the law stand behind the walls.
pub fn by_intervals_of<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    ground: &Ground<'_, '_, S, D>,
    nodes: &[W::Node],
    image: impl Fn(&W::Node, &Wall<S>) -> W::Node,
) -> Result<(), Error> {
    let Some(first) = nodes.first() else {
        return Ok(());
    };
    let mut hull = first.splat::<Interval<S>>();
    for node in nodes {
        W::Node::set_lane::<Interval<S>>(&mut hull, 0, node);
    }
    add_images::<S, D, W>(image, ground.cells, nodes, &mut hull);
    let apart = farthest(law, ground.reach);
    let worst = |k: &<W::Node as Fields<S>>::Of<Interval<S>>| {
        let mut sums = [W::Sums::ZERO.splat::<Interval<S>>(); 2];
        let [to_k, to_l] = &mut sums;
        law.pair(k, &hull, &apart, to_k, to_l);
        let mut worst = 0.0f64;
        for of in &sums {
            W::Sums::ZERO.each::<Interval<S>>(of, &mut |sum| {
                let term = (-sum.low).max(sum.high);
                worst = worst.max(sum.worst).max(ground.partners * term);
            });
        }
        worst
    };
    let bound = worst(&hull);
    if holds::<S>(W::MAKES, 0, bound).is_ok() {
        return Ok(());
    }
    // Whose it is costs a look at each of them.
    let mut largest = Largest::default();
    for (place, node) in numbered(nodes) {
        largest.see(place, worst(&node.splat::<Interval<S>>()));
    }
    ground.holds(W::MAKES, Largest { bound, ..largest })
}

/// Adds what is seen behind walls.
fn add_images<S: Scalar, const D: usize, W: Law<S, D>>(
    reflected: impl Fn(&W::Node, &Wall<S>) -> W::Node,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    hull: &mut <W::Node as Fields<S>>::Of<Interval<S>>,
) {
    if !cells.grid().has_walls() {
        return;
    }
    let walls = cells.grid().walls();
    for (place, node) in numbered(nodes) {
        if !cells.grid().near_wall(&cells.cell(place)) {
            continue;
        }
        for combination in 1..3u32.saturating_pow(D as u32) {
            let (mut image, mut rest, mut is_there) = (*node, combination, true);
            for (axis, ends) in numbered(&walls) {
                let code = rest % 3;
                rest /= 3;
                let end = usize::from(code == 2);
                match (code, ends.get(end).copied().flatten()) {
                    (0, _) => {}
                    (_, None) => is_there = false,
                    (_, Some(position)) => {
                        let wall = Wall {
                            axis,
                            end,
                            position,
                        };
                        image = reflected(&image, &wall);
                    }
                }
            }
            if is_there {
                W::Node::set_lane::<Interval<S>>(hull, 0, &image);
            }
        }
    }
}

/// All that may lie between the particles of a pair.
fn farthest<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    reach: f64,
) -> Separation<Interval<S>, D> {
    let peaks = Peaks::of::<S, _, D>(law.cut_off(), W::NEEDS.parts == Parts::All);
    let shape = Shape {
        value: Interval::within(peaks.value),
        gradient: Interval::within(peaks.gradient),
        curvature: Interval::within(peaks.curvature),
        within: Interval::new(0.0, 1.0),
    };
    Separation {
        r: [Interval::within(reach); D],
        distance_squared: Interval::new(0.0, reach * reach),
        zeta: Shapes {
            k: shape,
            l: shape,
            distance: Interval::new(0.0, reach),
        },
    }
}
