//! The inner loops of the lanes, and how a host compiles them for an instruction set.

use core::ops::Range;

use super::law::{Fields, Law, Separation};
use crate::cutoff::{BLOCK, CutOff, Needs, PairBlock, Widths};
use crate::domain::Offset;
use crate::neighbours::{Cells, Image, Runs};
use crate::scalar::{Lanes, Number, Scalar};

/// The inner loops, compiled for one instruction set.
pub trait Kernel {
    /// As [`find`].
    fn find<S: Scalar, const D: usize, const L: usize>(
        cells: &Cells<'_, S, D>,
        receivers: &Receivers<S, D, L>,
        runs: &Runs<D>,
        words: &mut [u32],
    ) -> usize;
    /// As [`CutOff::shapes`]: a function of its own, so that laws share it.
    fn shapes<S: Scalar, C: CutOff, const D: usize, const L: usize>(
        cut_off: C,
        needs: Needs,
        scale: &Lanes<S, L>,
        count: usize,
        pairs: &mut PairBlock<Lanes<S, L>>,
    );
    /// As [`sum`].
    fn sum<S: Scalar, const D: usize, const L: usize, W: Law<S, D>>(
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        block: &Operands<'_, S, D, L, W>,
        pairs: &mut PairBlock<Lanes<S, L>>,
        sums: &mut <W::Sums as Fields<S>>::Of<Lanes<S, L>>,
    );
}

/// The inner loops for the instruction set that the crate is compiled for.
pub struct Portable;

impl Kernel for Portable {
    fn find<S: Scalar, const D: usize, const L: usize>(
        cells: &Cells<'_, S, D>,
        receivers: &Receivers<S, D, L>,
        runs: &Runs<D>,
        words: &mut [u32],
    ) -> usize {
        find(cells, receivers, runs, words)
    }
    fn shapes<S: Scalar, C: CutOff, const D: usize, const L: usize>(
        cut_off: C,
        needs: Needs,
        scale: &Lanes<S, L>,
        count: usize,
        pairs: &mut PairBlock<Lanes<S, L>>,
    ) {
        cut_off.shapes::<D, _>(needs, *scale, count, pairs);
    }
    fn sum<S: Scalar, const D: usize, const L: usize, W: Law<S, D>>(
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        block: &Operands<'_, S, D, L, W>,
        pairs: &mut PairBlock<Lanes<S, L>>,
        sums: &mut <W::Sums as Fields<S>>::Of<Lanes<S, L>>,
    ) {
        sum::<Self, S, D, L, W>(law, cells, nodes, block, pairs, sums);
    }
}

/// What the sums of a block are made from.
pub struct Operands<'a, S: Scalar, const D: usize, const L: usize, W: Law<S, D>> {
    /// Where the receivers are.
    pub receivers: &'a Receivers<S, D, L>,
    /// What they show.
    pub k: &'a <W::Node as Fields<S>>::Of<Lanes<S, L>>,
    /// Their candidates: stretches of [`List`](super::List).
    pub candidates: &'a [u32],
}

/// Positions and reaches of the receivers of a block.
pub struct Receivers<S, const D: usize, const L: usize> {
    position: [Lanes<S, L>; D],
    reach_squared: Lanes<S, L>,
}

impl<S: Scalar, const D: usize, const L: usize> Receivers<S, D, L> {
    /// Those of a range of the sorted order, at most `L` of them.
    // The same for every law: compiled once.
    #[inline(never)]
    pub(super) fn of(cells: &Cells<'_, S, D>, range: Range<usize>) -> Self {
        let sites = cells.sites().get(range).unwrap_or(&[]);
        let mut receivers = Self {
            position: [Lanes::zero(); D],
            reach_squared: Lanes::splat(-S::ONE),
        };
        for (i, site) in sites.iter().enumerate() {
            for j in 0..D {
                receivers.position[j].set_lane(i, site.position[j]);
            }
            receivers.reach_squared.set_lane(i, site.reach_squared);
        }
        // Lanes without a receiver stand where the first one is: they ask for nothing more.
        for i in sites.len()..L {
            for j in 0..D {
                let first = receivers.position[j].lane(0);
                receivers.position[j].set_lane(i, first);
            }
        }
        receivers
    }
}

/// The displacement of every lane from one partner.
#[inline(always)]
fn displacement<S: Scalar, const D: usize, const L: usize>(
    position: &[Lanes<S, L>; D],
    partner: &[S; D],
    shift: &[S; D],
) -> [Lanes<S, L>; D] {
    let mut r = [Lanes::zero(); D];
    for i in 0..D {
        r[i] = Offset::Shift(shift[i]).displacement(position[i], Lanes::splat(partner[i]));
    }
    r
}

/// The shift of an image that is not mirrored.
#[inline(always)]
fn shift_of<S: Scalar, const D: usize>(cells: &Cells<'_, S, D>, image: Image<D>) -> [S; D] {
    cells.grid().offsets(image).map(|offset| match offset {
        Offset::Shift(shift) => shift,
        Offset::Wall(_) => S::ZERO,
    })
}

/// Fills `words` with one block of the stream of a [`List`](super::List): the candidates in `runs` that any
/// receiver needs. Returns how many words it took.
#[inline(always)]
pub fn find<S: Scalar, const D: usize, const L: usize>(
    cells: &Cells<'_, S, D>,
    receivers: &Receivers<S, D, L>,
    runs: &Runs<D>,
    words: &mut [u32],
) -> usize {
    let mut used = 1;
    let mut head: Option<(usize, u32)> = None;
    for run in runs {
        let image = run.image.packed();
        // Runs with the same image share one stretch.
        let (at, image) = match head {
            Some((at, before)) if before == image => (at, image),
            _ => {
                let at = used;
                used += 2;
                (at, image)
            }
        };
        head = Some((at, image));
        let shift = shift_of(cells, run.image);
        let sites = cells
            .sites()
            .get(run.start as usize..run.end as usize)
            .unwrap_or(&[]);
        for (place, site) in (run.start..).zip(sites) {
            let r = displacement(&receivers.position, &site.position, &shift);
            let distance_squared = Lanes::length_squared(&r);
            let reach = receivers
                .reach_squared
                .max(Lanes::splat(site.reach_squared));
            // Written always, kept if needed: no branch.
            if let Some(word) = words.get_mut(used) {
                *word = place;
            }
            used += usize::from(distance_squared.any_below(reach));
        }
        if let Some([code, count]) = words.get_mut(at..at + 2) {
            (*code, *count) = (image, (used - at - 2) as u32);
        }
    }
    if let Some(count) = words.first_mut() {
        *count = used as u32 - 1;
    }
    used
}

/// Adds the terms of the candidates of a block to its sums; `pairs` is room to work in.
///
/// Candidates are taken some at a time: first the distances of all of them, then their cut-off by
/// the kernel's [`Kernel::shapes`], then their terms. So the loop of a law is compiled once,
/// whatever the cut-off, and a cut-off once, whatever the law.
#[inline(always)]
pub fn sum<K: Kernel, S: Scalar, const D: usize, const L: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    block: &Operands<'_, S, D, L, W>,
    pairs: &mut PairBlock<Lanes<S, L>>,
    sums: &mut <W::Sums as Fields<S>>::Of<Lanes<S, L>>,
) {
    const {
        assert!(
            W::NEEDS.fit_lanes(),
            "lanes do not make what this law needs"
        )
    }
    let (k, position) = (*block.k, block.receivers.position);
    let (cut_off, scale) = (law.cut_off(), law.scale(&k));
    let mut to_k = *sums;
    let mut discarded = W::Sums::ZERO.splat::<Lanes<S, L>>();
    let sites = cells.sites();
    let mut candidates = block.candidates;
    while let [image, count, rest @ ..] = candidates {
        let (stretch, rest) = rest
            .split_at_checked(*count as usize)
            .unwrap_or((rest, &[]));
        candidates = rest;
        let shift = shift_of(cells, Image::unpacked(*image));
        for part in stretch.chunks(BLOCK) {
            for (i, &place) in part.iter().enumerate() {
                let (Some(site), Some(shown)) =
                    (sites.get(place as usize), nodes.get(place as usize))
                else {
                    continue;
                };
                let r = displacement(&position, &site.position, &shift);
                pairs.distance_squared[i] = Lanes::length_squared(&r);
                if W::NEEDS.widths == Widths::Both {
                    pairs.scale[i] = law.scale::<S>(&shown.splat::<S>());
                }
            }
            K::shapes::<S, W::CutOff, D, L>(cut_off, W::NEEDS, &scale, part.len(), pairs);
            for (i, &place) in part.iter().enumerate() {
                let (Some(site), Some(shown)) =
                    (sites.get(place as usize), nodes.get(place as usize))
                else {
                    continue;
                };
                let apart = Separation {
                    r: displacement(&position, &site.position, &shift),
                    distance_squared: pairs.distance_squared[i],
                    zeta: pairs.shapes(i, W::NEEDS),
                };
                let l = shown.splat::<Lanes<S, L>>();
                law.pair(&k, &l, &apart, &mut to_k, &mut discarded);
            }
        }
    }
    *sums = to_k;
}
