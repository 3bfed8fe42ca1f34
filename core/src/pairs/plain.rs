//! The plain loop: for each particle its partners in order. It defines the bits.

use super::law::{Fields, Law, Settled};
use super::mirror::mirror_terms;
use super::run::run_terms;
use crate::neighbours::{Cells, Site};
use crate::numbered::numbered;
use crate::scalar::Scalar;

/// Evaluates `law` for the receivers `first..first + settled.len()` of the sorted order.
pub fn plain<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    first: usize,
    settled: &mut [Settled<W::Node, W::Sums>],
) {
    for (settled, (place, node)) in settled.iter_mut().zip(numbered(nodes).skip(first)) {
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
    if let Some(site) = cells.sites().get(place) {
        receive_at(law, cells, nodes, site, settled);
    }
}

/// The same for a receiver anywhere: it need not be a particle.
pub fn receive_at<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    site: &Site<S, D>,
    settled: &mut Settled<W::Node, W::Sums>,
) {
    let cell = cells.grid().coordinates(&site.position);
    let runs = cells.runs(&cell, cell.last().copied().unwrap_or(0));
    loop {
        let mut sums = W::Sums::ZERO.splat::<S>();
        for run in &runs {
            run_terms::<S, D, W, false>(law, cells, nodes, site, &settled.node, run, &mut sums);
        }
        mirror_terms(law, cells, nodes, site, &cell, &settled.node, &mut sums);
        settled.sums = W::Sums::lane::<S>(&sums, 0);
        if law.close(&mut settled.node, &settled.sums) {
            return;
        }
    }
}
