//! The partners of one particle, one by one: for what only particles near a wall or a joint need.

use super::law::{Law, Separation};
use super::mirror::mirror_runs;
use crate::cutoff::Shapes;
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

impl<S: Scalar, const D: usize> Partner<S, D> {
    /// What lies between, for a law whose scale is the same for all particles.
    pub fn apart<W: Law<S, D>>(&self, law: &W, scale: S) -> Separation<S, D> {
        let scales = [scale; 2];
        Separation {
            r: self.r,
            distance_squared: self.distance_squared,
            zeta: Shapes::of::<W::CutOff, D>(
                law.cut_off(),
                W::NEEDS,
                self.distance_squared,
                scales,
            ),
        }
    }
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
