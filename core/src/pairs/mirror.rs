//! Partners behind walls. They come after all real and periodic ones: wall by wall in a
//! fixed order, each wall in ascending sorted order.

use super::law::{Fields, Law};
use super::run::run_terms;
use super::visit::mirror_runs;
use crate::neighbours::{Cells, Site};
use crate::scalar::Scalar;

/// Adds the terms of the mirror images to the sums of a receiver at `site` in `cell`.
pub(super) fn mirror_terms<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    site: &Site<S, D>,
    cell: &[u32; D],
    node: &W::Node,
    sums: &mut <W::Sums as Fields<S>>::Of<S>,
) {
    mirror_runs(cells, cell, |run| {
        run_terms::<S, D, W, true>(law, cells, nodes, site, node, run, sums);
    });
}
