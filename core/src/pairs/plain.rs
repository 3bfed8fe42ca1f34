//! The plain loop: for each particle its partners in order. It defines the bits.

use super::law::{Fields, Law, Settled};
use super::mirror::mirror_terms;
use super::run::run_terms;
use crate::neighbours::Cells;
use crate::scalar::Scalar;

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
