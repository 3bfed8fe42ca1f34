//! The box that a lattice fills.

use super::SetupError;
use crate::scenario::{Domain, Extent, Side};

/// How many times as many points as were asked for a lattice may have: rounding to whole spacings
/// gives no more, unless the box is thinner than one.
const MOST_FITTED: f64 = 2.0;

/// So many points more than that a lattice may have: a handful is rounded coarsely.
const FEW: f64 = 8.0;

/// An empty list with room for the points of a lattice with so many along each direction, where
/// about `asked` of them were wanted.
pub(super) fn room(counts: [usize; 3], asked: f64) -> Result<Vec<[f64; 3]>, SetupError> {
    // As an f64: the shape of a box may ask for more than an integer holds.
    let fitted: f64 = counts.iter().map(|&count| count as f64).product();
    if !(fitted <= MOST_FITTED * asked + FEW) {
        return Err(SetupError::Flat { fitted, asked });
    }
    let mut points = Vec::new();
    let reserved = points.try_reserve_exact(fitted as usize);
    reserved.map_err(|_| SetupError::Room { particles: fitted })?;
    Ok(points)
}

/// A box to be filled with points; components beyond the dimension are 0 to 0.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Block {
    pub(super) dimension: usize,
    pub(super) lower: [f64; 3],
    pub(super) upper: [f64; 3],
    /// Directions in which it closes on itself: it spans a periodic domain.
    pub(super) periodic: [bool; 3],
}

impl Block {
    /// A box in a domain.
    pub(super) fn new(extent: &Extent, domain: &Domain) -> Self {
        let mut block = Self {
            dimension: extent.lower.len(),
            lower: [0.0; 3],
            upper: [0.0; 3],
            periodic: [false; 3],
        };
        for i in 0..block.dimension {
            (block.lower[i], block.upper[i]) = (extent.lower[i], extent.upper[i]);
            block.periodic[i] = domain.sides[i] == [Side::Periodic; 2]
                && domain.extent.lower[i] == extent.lower[i]
                && domain.extent.upper[i] == extent.upper[i];
        }
        block
    }

    pub(super) fn length(&self, i: usize) -> f64 {
        self.upper[i] - self.lower[i]
    }

    pub(super) fn volume(&self) -> f64 {
        (0..self.dimension).map(|i| self.length(i)).product()
    }

    /// How often `spacing` fits along a direction: at least once.
    pub(super) fn fitted(&self, i: usize, spacing: f64) -> usize {
        ((self.length(i) / spacing).round() as usize).max(1)
    }

    /// As [`Self::fitted`], but even where the direction is periodic, for layers that alternate.
    pub(super) fn fitted_layers(&self, i: usize, spacing: f64) -> usize {
        if self.periodic[i] {
            self.fitted(i, 2.0 * spacing).saturating_mul(2)
        } else {
            self.fitted(i, spacing)
        }
    }

    /// The place at a fraction of the way from the lower to the upper side; inside, also where
    /// the sum rounds.
    pub(super) fn at(&self, i: usize, cell: f64, cells: usize) -> f64 {
        let spacing = self.length(i) / cells as f64;
        (self.lower[i] + spacing * cell).min(self.upper[i])
    }

    /// A point, brought back: through periodic sides, off the others.
    pub(super) fn inside(&self, mut point: [f64; 3]) -> [f64; 3] {
        for i in 0..self.dimension {
            let (x, lower, upper) = (point[i], self.lower[i], self.upper[i]);
            let back = match (x < lower, x >= upper, self.periodic[i]) {
                (true, _, true) => x + (upper - lower),
                (_, true, true) => x - (upper - lower),
                (true, _, false) => lower + (lower - x),
                (_, true, false) => upper - (x - upper),
                _ => x,
            };
            point[i] = back.clamp(lower, upper);
        }
        point
    }
}

/// The distance of particles that have this volume each: its root of the dimension.
pub(super) fn spacing(volume: f64, dimension: usize) -> f64 {
    match dimension {
        1 => volume,
        2 => volume.sqrt(),
        _ => libm::cbrt(volume),
    }
}
