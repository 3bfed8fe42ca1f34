//! Receiver lanes: a block of consecutive receivers shares its candidates.
//!
//! Lane `i` holds receiver `i` of the block and adds the terms of the candidates in ascending
//! order, as the plain loop does; a lane out of reach adds 0. Which candidates any lane needs
//! is found once and kept in a [`List`] for all laws of a step.
//!
//! The two inner loops are a [`Kernel`]: a host compiles them into functions of their own for
//! each instruction set. They are `inline(always)` all the way down, and take and leave lanes
//! in memory: that is what the compiler turns into vectors. Inlined into more than they need,
//! or split by a call, they lose a factor of ten.

use super::kernel::{Kernel, Operands, Receivers};
use super::law::{Fields, Law, Settled};
use super::mirror::mirror_terms;
use crate::cutoff::PairBlock;
use crate::neighbours::{Cells, Run};
use crate::scalar::{Lanes, Scalar};

/// Receivers `start..end` of the sorted order, all in one row of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block<const D: usize> {
    /// The first receiver.
    pub start: usize,
    /// One beyond the last.
    pub end: usize,
    /// The cell of the first one.
    pub cell: [u32; D],
}

/// The blocks of `L` receivers that make up a range of the sorted order.
pub struct Blocks<'a, 'c, S, const D: usize, const L: usize> {
    cells: &'a Cells<'c, S, D>,
    next: usize,
    end: usize,
}

impl<'a, 'c, S: Scalar, const D: usize, const L: usize> Blocks<'a, 'c, S, D, L> {
    /// Cuts `start..end`, as far as there are receivers, into blocks at every `L` of them and at
    /// ends of rows.
    pub fn new(cells: &'a Cells<'c, S, D>, start: usize, end: usize) -> Self {
        const { assert!(L > 0, "a block has a lane at the least") }
        Self {
            cells,
            next: start,
            end: end.min(cells.sites().len()),
        }
    }
}

impl<S: Scalar, const D: usize, const L: usize> Iterator for Blocks<'_, '_, S, D, L> {
    type Item = Block<D>;

    // The same for every law: compiled once.
    #[inline(never)]
    fn next(&mut self) -> Option<Block<D>> {
        if self.next >= self.end {
            return None;
        }
        let start = self.next;
        let cell = self.cells.cell(start);
        let row_end = self.cells.row_end(&cell) as usize;
        let end = (start + L).min(self.end).min(row_end.max(start + 1));
        self.next = end;
        Some(Block { start, end, cell })
    }
}

/// The candidates of a range of blocks, in memory that can grow or not.
///
/// A stream of words: for each block its number of words, then for each stretch of equal
/// image the image, the number of candidates, and their places in the sorted order.
pub trait List {
    /// Room for that many more words beyond the last committed one, or `None`.
    fn room(&mut self, words: usize) -> Option<&mut [u32]>;
    /// Keeps that many words of it.
    fn commit(&mut self, words: usize);
    /// The words kept from `start` on.
    fn words(&self, start: usize) -> &[u32];
}

/// Evaluates `law` for the receivers `first..first + settled.len()` of the sorted order, `L`
/// at a time.
///
/// With `fresh`, the candidates are found and added to `list`, which the caller has emptied;
/// without, `list` holds them from an earlier call over the same range and the same cells.
/// Returns `false` when the list is full; then nothing of `settled` is meaningful.
pub fn lanes<K: Kernel, S: Scalar, const D: usize, const L: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    first: usize,
    settled: &mut [Settled<W::Node, W::Sums>],
    list: &mut impl List,
    fresh: bool,
) -> bool {
    let mut pairs = PairBlock::zero();
    let mut word = 0;
    let end = first.saturating_add(settled.len());
    for block in Blocks::<S, D, L>::new(cells, first, end) {
        let receivers = Receivers::<S, D, L>::of(cells, block.start..block.end);
        if fresh && !find_candidates::<K, S, D, L>(cells, &block, &receivers, list) {
            return false;
        }
        let words = list.words(word);
        let Some((&count, words)) = words.split_first() else {
            return false;
        };
        let candidates = words.get(..count as usize).unwrap_or(&[]);
        word += 1 + count as usize;
        let range = block.start - first..block.end - first;
        if let Some(settled) = settled.get_mut(range) {
            settle::<K, S, D, L, W>(
                law,
                cells,
                nodes,
                &Group {
                    start: block.start,
                    receivers: &receivers,
                    candidates,
                },
                &mut pairs,
                settled,
            );
        }
    }
    true
}

/// Writes the candidates that any receiver of the block needs: the same for every law, and compiled once.
#[inline(never)]
fn find_candidates<K: Kernel, S: Scalar, const D: usize, const L: usize>(
    cells: &Cells<'_, S, D>,
    block: &Block<D>,
    receivers: &Receivers<S, D, L>,
    list: &mut impl List,
) -> bool {
    let last = cells.cell(block.end - 1)[D - 1];
    let runs = cells.runs(&block.cell, last);
    let length = |run: &Run<D>| (run.end - run.start) as usize;
    let most: usize = runs.iter().map(|run| length(run) + 2).sum();
    let Some(words) = list.room(1 + most) else {
        return false;
    };
    let used = K::find(cells, receivers, &runs, words);
    list.commit(used);
    true
}

/// The receivers of a block with their candidates.
struct Group<'a, S, const D: usize, const L: usize> {
    /// The first one, in sorted order.
    start: usize,
    receivers: &'a Receivers<S, D, L>,
    candidates: &'a [u32],
}

/// Evaluates the law for the receivers of a block until every lane is done. A lane that is done
/// freezes.
fn settle<K: Kernel, S: Scalar, const D: usize, const L: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    group: &Group<'_, S, D, L>,
    pairs: &mut PairBlock<Lanes<S, L>>,
    settled: &mut [Settled<W::Node, W::Sums>],
) {
    let start = group.start;
    let near_wall = |place| cells.grid().near_wall(&cells.cell(place));
    let walls = cells.grid().has_walls() && (start..start + settled.len()).any(near_wall);
    let shown = nodes.get(start..).unwrap_or(&[]);
    for (settled, shown) in settled.iter_mut().zip(shown) {
        settled.node = *shown;
    }
    let mut done = [false; L];
    loop {
        let k = W::Node::gather::<Lanes<S, L>>(settled.iter().map(|settled| &settled.node));
        let operands = Operands {
            receivers: group.receivers,
            k: &k,
            candidates: group.candidates,
        };
        let mut sums = W::Sums::ZERO.splat::<Lanes<S, L>>();
        K::sum::<S, D, L, W>(law, cells, nodes, &operands, pairs, &mut sums);
        let mut all_done = true;
        for (i, (done, settled)) in done.iter_mut().zip(settled.iter_mut()).enumerate() {
            if *done {
                continue;
            }
            settled.sums = W::Sums::lane::<Lanes<S, L>>(&sums, i);
            if walls {
                add_mirrors(law, cells, nodes, start + i, settled);
            }
            *done = law.close(&mut settled.node, &settled.sums);
            all_done &= *done;
        }
        if all_done {
            return;
        }
    }
}

/// Adds what a receiver gets from behind the walls to its sums.
fn add_mirrors<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    place: usize,
    settled: &mut Settled<W::Node, W::Sums>,
) {
    let mut sums = settled.sums.splat::<S>();
    let cell = cells.cell(place);
    if let Some(site) = cells.sites().get(place) {
        mirror_terms(law, cells, nodes, site, &cell, &settled.node, &mut sums);
    }
    settled.sums = W::Sums::lane::<S>(&sums, 0);
}
