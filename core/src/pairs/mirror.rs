//! Partners behind walls. They come after all real and periodic ones: wall by wall in a
//! fixed order, each wall in ascending sorted order.

use super::law::{Fields, Law};
use super::run::run_terms;
use crate::neighbours::{Cells, Run, Site};
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
        run_terms(law, cells, nodes, site, node, run, sums);
    });
}

/// The runs of mirror images that can hold partners of a receiver in `cell`.
///
/// Walls are counted in base 3, the first direction slowest: 0 no wall, 1 the lower, 2 the
/// upper one; images across two or three walls at an edge or corner are among them.
#[inline(always)]
pub(super) fn mirror_runs<S: Scalar, const D: usize>(
    cells: &Cells<'_, S, D>,
    cell: &[u32; D],
    mut visit: impl FnMut(&Run<D>),
) {
    if !cells.grid().near_wall(cell) {
        return;
    }
    for combination in 1..3u32.pow(D as u32) {
        let mut mirror = [0; D];
        let mut rest = combination;
        for wall in mirror.iter_mut().rev() {
            (*wall, rest) = ((rest % 3) as u8, rest / 3);
        }
        for run in &cells.mirror_runs(cell, &mirror) {
            visit(run);
        }
    }
}
