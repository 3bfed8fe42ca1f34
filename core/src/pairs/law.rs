//! What an equation has to say.

use crate::cutoff::{CutOff, Needs, Parts, Peaks, Shape, Shapes};
use crate::domain::Wall;
use crate::error::{Error, Quantity};
use crate::neighbours::{Cells, Image};
use crate::numbered::numbered;
use crate::scalar::enclosure::worse;
use crate::scalar::{Enclosure, Number, Scalar};

use super::proof::{Ground, Largest, holds};
pub(super) use super::record::Fields;
use super::visit::{Partner, each_image, each_partner};

/// What lies between the particles of a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separation<N, const D: usize> {
    /// `r = x_k - x_l`.
    pub r: [N; D],
    /// `|r|²`.
    pub distance_squared: N,
    /// The cut-off: what [`Law::NEEDS`] asks for.
    pub zeta: Shapes<N>,
}

impl<S: Scalar, const D: usize> Separation<S, D> {
    /// Of two particles met one by one, `r` apart.
    #[inline(always)]
    pub fn of<W: Law<S, D>>(
        law: &W,
        [k, l]: [&<W::Node as Fields<S>>::Of<S>; 2],
        r: [S; D],
        distance_squared: S,
    ) -> Self {
        let scales = [law.scale::<S>(k), law.scale::<S>(l)];
        Self {
            r,
            distance_squared,
            zeta: law
                .cut_off()
                .shapes_of_pair::<D, _>(W::NEEDS, distance_squared, scales),
        }
    }

    /// The same as intervals of one value each.
    fn enclosed(&self) -> Separation<Enclosure<S>, D> {
        let of = Enclosure::splat;
        let shape = |shape: &Shape<S>| Shape {
            value: of(shape.value),
            gradient: of(shape.gradient),
            curvature: of(shape.curvature),
            within: of(shape.within),
        };
        Separation {
            r: self.r.map(of),
            distance_squared: of(self.distance_squared),
            zeta: Shapes {
                k: shape(&self.zeta.k),
                l: shape(&self.zeta.l),
                distance: of(self.zeta.distance),
            },
        }
    }
}

/// An equation: a sum over partners of a pair term.
///
/// It has no storage, no threads and no loop over neighbours. Everything is indexed as in
/// the paper: `k` receives, `l` is its partner, `r = x_k - x_l`.
pub trait Law<S: Scalar, const D: usize>: Sync {
    /// What a particle shows to its partners.
    type Node: Fields<S>;
    /// What it receives.
    type Sums: Fields<S>;
    /// The cut-off of its sums.
    type CutOff: CutOff;
    /// What it reads of the cut-off.
    const NEEDS: Needs;
    /// What its sums are, where a proof of them fails.
    const MAKES: Quantity = Quantity::Sum;

    /// The cut-off.
    fn cut_off(&self) -> Self::CutOff;

    /// A particle's part of the argument of the cut-off: see [`CutOff::scale`].
    fn scale<N: Number<Scalar = S>>(&self, node: &<Self::Node as Fields<S>>::Of<N>) -> N;

    /// Adds the term of the pair to both of its particles.
    ///
    /// What `l` receives here has the bits that it would receive as `k` of the pair seen from
    /// the other side: write terms that are equal or exactly opposite, and functions of one
    /// of the two for each its own. A pair out of reach must add exactly 0. With `r = 0` it
    /// is the term of a particle on itself.
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &<Self::Node as Fields<S>>::Of<N>,
        l: &<Self::Node as Fields<S>>::Of<N>,
        apart: &Separation<N, D>,
        to_k: &mut <Self::Sums as Fields<S>>::Of<N>,
        to_l: &mut <Self::Sums as Fields<S>>::Of<N>,
    );

    /// Adds the term of a pair whose `l` is the image of a particle in walls, as [`Law::reflected`] has it:
    /// that of [`Law::pair`], unless there is something that no mirror shows.
    #[inline(always)]
    fn pair_behind<N: Number<Scalar = S>>(
        &self,
        [k, l]: [&<Self::Node as Fields<S>>::Of<N>; 2],
        image: &Image<D>,
        apart: &Separation<N, D>,
        to_k: &mut <Self::Sums as Fields<S>>::Of<N>,
        to_l: &mut <Self::Sums as Fields<S>>::Of<N>,
    ) {
        let _ = image;
        self.pair(k, l, apart, to_k, to_l);
    }

    /// Looks at a particle's sums: `true` when they are final; `false` to have them made
    /// again with the node that it changed. A law that does so bounds its passes itself.
    fn close(&self, node: &mut Self::Node, sums: &Self::Sums) -> bool {
        let _ = (node, sums);
        true
    }

    /// Whether no sum or product of the law over these nodes, in sorted order, leaves the range of
    /// a format that wraps; asked in such formats alone.
    ///
    /// By intervals: as the law stands, [`Law::pair`] is evaluated over all values that the nodes
    /// and their images have. A law in which that bounds too much, as a speed that is a product
    /// over a distance, says its bounds itself.
    fn proof(&self, ground: &Ground<'_, '_, S, D>, nodes: &[Self::Node]) -> Result<(), Error>
    where
        Self: Sized,
    {
        by_intervals(self, ground, nodes)
    }

    /// The mirror image of a node in a wall; where the image is the engine knows.
    fn reflected(&self, node: &Self::Node, wall: &Wall<S>) -> Self::Node {
        let _ = wall;
        *node
    }
}

/// The node of a particle after the last pass, and its sums.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled<Node, Sums> {
    /// As [`Law::close`] left it.
    pub node: Node,
    /// The sums of the last pass.
    pub sums: Sums,
}

impl<Node, Sums> Settled<Node, Sums> {
    /// A result that has not been written yet.
    pub const fn new(node: Node, sums: Sums) -> Self {
        Self { node, sums }
    }
}

/// Evaluates a law once, over the intervals of all that its particles and their images show: every sum
/// and product on the way is in what comes out. Where that proves nothing, [`by_pairs`].
pub fn by_intervals<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    ground: &Ground<'_, '_, S, D>,
    nodes: &[W::Node],
) -> Result<(), Error> {
    let image = |node: &W::Node, wall: &Wall<S>| law.reflected(node, wall);
    by_intervals_of(law, ground, nodes, image).or_else(|_| by_pairs(law, ground, nodes, image))
}

/// The same where other images than those of the law stand behind the walls.
#[inline(never)]
pub fn by_intervals_of<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    ground: &Ground<'_, '_, S, D>,
    nodes: &[W::Node],
    image: impl Fn(&W::Node, &Wall<S>) -> W::Node,
) -> Result<(), Error> {
    let Some(first) = nodes.first() else {
        return Ok(());
    };
    let mut ends = first.splat::<Enclosure<S>>();
    for node in nodes {
        W::Node::set_lane::<Enclosure<S>>(&mut ends, 0, node);
    }
    add_images::<S, D, W>(image, ground.cells, nodes, &mut ends);
    // Compared as they are, and turned into f32 once.
    let [low, high] = [0, 1].map(|end| W::Node::lane::<Enclosure<S>>(&ends, end));
    let mut hull = low.splat::<Enclosure<S>>();
    W::Node::set_lane::<Enclosure<S>>(&mut hull, 1, &high);
    let apart = farthest((law.cut_off(), W::NEEDS), ground.reach);
    let worst = |k: &<W::Node as Fields<S>>::Of<Enclosure<S>>| {
        let mut sums = [W::Sums::ZERO.splat::<Enclosure<S>>(); 2];
        let [to_k, to_l] = &mut sums;
        pair_over(law, [k, &hull], &Image::SELF, &apart, [to_k, to_l]);
        let (mut worst, partners) = (0.0f32, ground.partners as f32);
        for of in &sums {
            W::Sums::ZERO.each::<Enclosure<S>>(of, &mut |sum| {
                let all = partners * worse(sum.low, sum.high);
                worst = worse(worst, worse(sum.worst, all));
            });
        }
        f64::from(worst)
    };
    holds::<S>(W::MAKES, 0, worst(&hull))
}

/// Looks at every pair by itself: what the bounds of all of them at once could not prove, and who it is
/// that leaves the range.
///
/// Every product and every partial sum, in the order of summation, as an interval that holds what the
/// format makes of it. Dear, so it is the last resort. `image` as for [`by_intervals_of`].
#[inline(never)]
pub fn by_pairs<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    ground: &Ground<'_, '_, S, D>,
    nodes: &[W::Node],
    image: impl Fn(&W::Node, &Wall<S>) -> W::Node,
) -> Result<(), Error> {
    let cells = ground.cells;
    let walls = cells.grid().walls();
    // What the partners count beyond their number: shares of walls.
    let excess = ground.partners / (cells.most_partners() as f64).max(1.0);
    let excess = if excess > 1.0 { excess } else { 1.0 };
    let mut largest = Largest::default();
    for (place, node) in numbered(nodes) {
        let k = node.splat::<Enclosure<S>>();
        let mut to_k = W::Sums::ZERO.splat::<Enclosure<S>>();
        let mut term = 0.0f32;
        let mut add = |partner: &Partner<S, D>| {
            let Some(shown) = nodes.get(partner.place) else {
                return;
            };
            let mut shown = *shown;
            for wall in partner.image.walls(&walls) {
                shown = image(&shown, &wall);
            }
            let ends = [&node.splat::<S>(), &shown.splat::<S>()];
            let apart = Separation::of(law, ends, partner.r, partner.distance_squared).enclosed();
            let l = shown.splat::<Enclosure<S>>();
            let mut to_l = W::Sums::ZERO.splat::<Enclosure<S>>();
            let to = [&mut to_k, &mut to_l];
            pair_over(law, [&k, &l], &partner.image, &apart, to);
            W::Sums::ZERO.each::<Enclosure<S>>(&to_l, &mut |sum| term = worse(term, sum.worst));
        };
        // Through a pointer: the visits of every law are compiled once.
        let add: &mut dyn FnMut(&Partner<S, D>) = &mut add;
        each_partner(cells, place, &mut *add);
        each_image(cells, place, &mut *add);
        W::Sums::ZERO.each::<Enclosure<S>>(&to_k, &mut |sum| term = worse(term, sum.worst));
        largest.see(place, excess * f64::from(term));
    }
    ground.holds(W::MAKES, largest)
}

/// [`Law::pair_behind`] over intervals: a function of its own, as it is long and no loop has to have it.
#[inline(never)]
fn pair_over<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    pair: [&<W::Node as Fields<S>>::Of<Enclosure<S>>; 2],
    image: &Image<D>,
    apart: &Separation<Enclosure<S>, D>,
    [to_k, to_l]: [&mut <W::Sums as Fields<S>>::Of<Enclosure<S>>; 2],
) {
    law.pair_behind(pair, image, apart, to_k, to_l);
}

/// Adds what is seen behind walls.
#[inline(never)]
fn add_images<S: Scalar, const D: usize, W: Law<S, D>>(
    reflected: impl Fn(&W::Node, &Wall<S>) -> W::Node,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    hull: &mut <W::Node as Fields<S>>::Of<Enclosure<S>>,
) {
    if !cells.grid().has_walls() {
        return;
    }
    let (walls, reach) = (cells.grid().walls(), cells.grid().farthest());
    for (node, site) in nodes.iter().zip(cells.sites()) {
        // Nobody sees an image that is farther than the particle is from its wall.
        let is_near = |(x, ends): (&S, &[Option<S>; 2])| {
            let mut ends = ends.iter().flatten();
            ends.any(|&wall| (*x - wall).abs() <= reach)
        };
        if !site.position.iter().zip(&walls).any(is_near) {
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
                W::Node::set_lane::<Enclosure<S>>(hull, 0, &image);
            }
        }
    }
}

/// All that may lie between the particles of a pair.
// The same for every law: compiled once.
#[inline(never)]
fn farthest<S: Scalar, C: CutOff, const D: usize>(
    (cut_off, needs): (C, Needs),
    reach: f64,
) -> Separation<Enclosure<S>, D> {
    let peaks = Peaks::of::<S, _, D>(cut_off, needs.parts == Parts::All);
    let shape = Shape {
        value: Enclosure::within(peaks.value),
        gradient: Enclosure::within(peaks.gradient),
        curvature: Enclosure::within(peaks.curvature),
        within: Enclosure::new(0.0, 1.0),
    };
    Separation {
        r: [Enclosure::within(reach); D],
        distance_squared: Enclosure::new(0.0, reach * reach),
        zeta: Shapes {
            k: shape,
            l: shape,
            distance: Enclosure::new(0.0, reach),
        },
    }
}
