//! The half loop: every pair once, its term to both particles.
//!
//! `k` ascending, `l >= k` ascending: each particle receives the terms of smaller partners
//! while those are `k`, then its own, then those of larger ones: the order of the plain
//! loop. Images across periodic sides join in at the place that the sorted order gives them.

use super::law::{Fields, Law, Separation, Settled};
use super::mirror::mirror_terms;
use super::plain::receive;
use crate::neighbours::{Cells, Run};
use crate::numbered::numbered;
use crate::scalar::{Number, Scalar};

/// Evaluates `law` for the whole cloud.
#[inline(never)]
pub fn half<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    settled: &mut [Settled<W::Node, W::Sums>],
) {
    for (settled, node) in settled.iter_mut().zip(nodes) {
        *settled = Settled::new(*node, W::Sums::ZERO);
    }
    for place in 0..nodes.len() {
        let cell = cells.cell(place);
        for run in &cells.runs(&cell, cell.last().copied().unwrap_or(0)) {
            run_pairs(law, cells, nodes, place, run, settled);
        }
    }
    for (place, settled) in numbered(settled) {
        let mut sums = settled.sums.splat::<S>();
        let cell = cells.cell(place);
        if let Some(site) = cells.sites().get(place) {
            mirror_terms(law, cells, nodes, site, &cell, &settled.node, &mut sums);
        }
        settled.sums = W::Sums::lane::<S>(&sums, 0);
        if !law.close(&mut settled.node, &settled.sums) {
            receive(law, cells, nodes, place, settled);
        }
    }
}

/// Adds the terms of the pairs of `place` with the later ones of a run to both sides.
#[inline(always)]
fn run_pairs<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    place: usize,
    run: &Run<D>,
    settled: &mut [Settled<W::Node, W::Sums>],
) {
    // A run that crosses a periodic side is met again from its other end: there l < k.
    let range = (run.start as usize).max(place)..run.end as usize;
    let itself = range.start == place;
    let (Some(site), Some(node)) = (cells.sites().get(place), nodes.get(place)) else {
        return;
    };
    let (Some(partners), Some(shown), Some(mine)) = (
        cells.sites().get(range.clone()),
        nodes.get(range.clone()),
        settled.get(place).map(|settled| settled.sums),
    ) else {
        return;
    };
    let offsets = cells.grid().offsets(run.image);
    let k = node.splat::<S>();
    let mut to_k = mine.splat::<S>();
    let receivers = settled.get_mut(range).unwrap_or(&mut []);
    for (i, ((partner, shown), receiver)) in numbered(partners.iter().zip(shown).zip(receivers)) {
        let mut r = [S::ZERO; D];
        for i in 0..D {
            r[i] = offsets[i].displacement(site.position[i], partner.position[i]);
        }
        let distance_squared = S::length_squared(&r);
        if distance_squared < Number::max(site.reach_squared, partner.reach_squared) {
            let l = shown.splat::<S>();
            let mut to_l = receiver.sums.splat::<S>();
            let apart = Separation::of(law, [&k, &l], r, distance_squared);
            law.pair(&k, &l, &apart, &mut to_k, &mut to_l);
            // A particle's term on itself counts once, and goes to k.
            if !(itself && i == 0) {
                receiver.sums = W::Sums::lane::<S>(&to_l, 0);
            }
        }
    }
    if let Some(settled) = settled.get_mut(place) {
        settled.sums = W::Sums::lane::<S>(&to_k, 0);
    }
}
