//! Visits to the partners of one particle, one by one.

use crate::neighbours::{Cells, Image, Run};
use crate::scalar::{Number, Scalar};

/// A partner as a particle sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Partner<S, const D: usize> {
    /// Its place in sorted order.
    pub place: usize,
    /// How it is seen.
    pub image: Image<D>,
    /// `r = x_k - x_l`.
    pub r: [S; D],
    /// `|r|²`.
    pub distance_squared: S,
}

/// Visits the real and periodic partners of the particle at a place of the sorted order, itself
/// among them, in the order of summation.
pub(crate) fn each_partner<S: Scalar, const D: usize>(
    cells: &Cells<'_, S, D>,
    place: usize,
    mut visit: impl FnMut(&Partner<S, D>),
) {
    let cell = cells.cell(place);
    for run in &cells.runs(&cell, cell.last().copied().unwrap_or(0)) {
        each_of(cells, place, run, &mut visit);
    }
}

/// Visits its partners behind walls, its own images among them, in the order of summation.
pub(crate) fn each_image<S: Scalar, const D: usize>(
    cells: &Cells<'_, S, D>,
    place: usize,
    mut visit: impl FnMut(&Partner<S, D>),
) {
    mirror_runs(cells, &cells.cell(place), |run| {
        each_of(cells, place, run, &mut visit);
    });
}

fn each_of<S: Scalar, const D: usize>(
    cells: &Cells<'_, S, D>,
    place: usize,
    run: &Run<D>,
    visit: &mut impl FnMut(&Partner<S, D>),
) {
    let range = run.start as usize..run.end as usize;
    let (Some(site), Some(partners)) = (cells.sites().get(place), cells.sites().get(range.clone()))
    else {
        return;
    };
    let offsets = cells.grid().offsets(run.image);
    for (place, partner) in range.zip(partners) {
        let mut r = [S::ZERO; D];
        for i in 0..D {
            r[i] = offsets[i].displacement(site.position[i], partner.position[i]);
        }
        let distance_squared = S::length_squared(&r);
        if distance_squared < Number::max(site.reach_squared, partner.reach_squared) {
            visit(&Partner {
                place,
                image: run.image,
                r,
                distance_squared,
            });
        }
    }
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
