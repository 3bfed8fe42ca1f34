//! The plain loop: for each particle its partners in order. It defines the bits.

use super::law::{Fields, Law, Settled};
use super::mirror::{image_of, mirror_terms};
use crate::neighbours::{Cells, Run};
use crate::scalar::{Number, Scalar};

/// Evaluates `law` for the receivers `first..first + settled.len()` of the sorted order.
pub fn plain<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    first: usize,
    settled: &mut [Settled<W::Node, W::Sums>],
) {
    for (settled, (place, node)) in settled.iter_mut().zip(nodes.iter().enumerate().skip(first)) {
        settled.node = *node;
        receive(law, cells, nodes, place, settled);
    }
}

/// Evaluates `law` for one receiver, as often as it asks for.
pub(super) fn receive<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    place: usize,
    settled: &mut Settled<W::Node, W::Sums>,
) {
    let cell = cells.cell(place);
    let runs = cells.runs(&cell, cell.last().copied().unwrap_or(0));
    loop {
        let mut sums = W::Sums::ZERO.splat::<S>();
        for run in &runs {
            run_terms(law, cells, nodes, place, &settled.node, run, &mut sums);
        }
        mirror_terms(law, cells, nodes, place, &cell, &settled.node, &mut sums);
        settled.sums = W::Sums::lane::<S>(&sums, 0);
        if law.close(&mut settled.node, &settled.sums) {
            return;
        }
    }
}

/// Adds the terms of one run to the sums of the receiver at `place`.
#[inline(always)]
pub(super) fn run_terms<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    place: usize,
    node: &W::Node,
    run: &Run<D>,
    sums: &mut <W::Sums as Fields<S>>::Of<S>,
) {
    let range = run.start as usize..run.end as usize;
    let (Some(site), Some(partners), Some(shown)) = (
        cells.sites().get(place),
        cells.sites().get(range.clone()),
        nodes.get(range),
    ) else {
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
            let l = image_of(law, shown, &run.image.0).splat::<S>();
            law.pair(&k, &l, &r, distance_squared, sums, &mut discarded);
        }
    }
}
