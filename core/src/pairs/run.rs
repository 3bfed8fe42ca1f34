//! The terms of one run on one receiver.

use super::law::{Fields, Law, Separation};
use crate::domain::{Offset, Wall};
use crate::neighbours::{Cells, Run, Site, code};
use crate::numbered::numbered;
use crate::scalar::{Number, Scalar};

/// Adds the terms of one run to the sums of a receiver at `site`; `MIRRORED`: a run behind walls.
#[inline(always)]
pub(super) fn run_terms<S: Scalar, const D: usize, W: Law<S, D>, const MIRRORED: bool>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    site: &Site<S, D>,
    node: &W::Node,
    run: &Run<D>,
    sums: &mut <W::Sums as Fields<S>>::Of<S>,
) {
    let range = run.start as usize..run.end as usize;
    let (Some(partners), Some(shown)) = (cells.sites().get(range.clone()), nodes.get(range)) else {
        return;
    };
    let offsets = cells.grid().offsets(run.image);
    let k = node.splat::<S>();
    let mut discarded = W::Sums::ZERO.splat::<S>();
    for (partner, shown) in partners.iter().zip(shown) {
        let mut r = [S::ZERO; D];
        for i in 0..D {
            r[i] = offsets[i].displacement(site.position[i], partner.position[i]);
        }
        let distance_squared = S::length_squared(&r);
        if distance_squared < Number::max(site.reach_squared, partner.reach_squared) {
            let l = image_of(law, shown, &run.image.0, &offsets).splat::<S>();
            let apart = Separation::of(law, [&k, &l], r, distance_squared);
            match MIRRORED {
                true => law.pair_behind([&k, &l], &run.image, &apart, sums, &mut discarded),
                false => law.pair(&k, &l, &apart, sums, &mut discarded),
            }
        }
    }
}

/// The node of `l` as its image shows it.
#[inline(always)]
fn image_of<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    node: &W::Node,
    image: &[u8; D],
    offsets: &[Offset<S>; D],
) -> W::Node {
    let mut node = *node;
    for (axis, (&seen, offset)) in numbered(image.iter().zip(offsets)) {
        if let Offset::Wall(position) = *offset {
            let wall = Wall {
                axis,
                end: usize::from(seen == code::UPPER_WALL),
                position,
            };
            node = law.reflected(&node, &wall);
        }
    }
    node
}
