//! Proofs that the sums over pairs stay in the range of a format that wraps.
//!
//! Before the sums of a law are made, the largest of what the particles show, the reach and the largest
//! number of partners bound every sum and product on the way: see [`Law::proof`](super::Law::proof).

use crate::error::{Error, Quantity};
use crate::neighbours::Cells;
use crate::scalar::Scalar;

/// A bound, and the place in sorted order of the particle that it comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Largest {
    /// The bound; not below 0.
    pub bound: f64,
    /// Where.
    pub place: usize,
}

impl Largest {
    /// The largest of some numbers in magnitude; they are compared as they are and turned into `f64`
    /// once.
    #[inline(always)]
    pub fn of<S: Scalar>(mut numbers: impl Iterator<Item = S> + Clone) -> Self {
        // By `fold`, which walks rows of rows as two loops.
        let all = numbers.clone();
        let ends = all.fold([S::ZERO; 2], |[low, high], number| {
            [low.lesser(number), high.greater(number)]
        });
        let [below, above] = ends.map(|end| end.to_f64().abs());
        let (bound, end) = match above >= below {
            true => (above, ends[1]),
            false => (below, ends[0]),
        };
        let place = numbers.position(|number| number == end).unwrap_or(0);
        Self { bound, place }
    }

    /// Takes another one in, if it is larger or no number.
    #[inline(always)]
    pub fn see(&mut self, place: usize, bound: f64) {
        if !(bound <= self.bound) {
            *self = Self { bound, place };
        }
    }

    /// The same times a factor.
    pub fn times(self, factor: f64) -> Self {
        Self {
            bound: self.bound * factor,
            ..self
        }
    }
}

/// Refuses a bound that the format does not hold; bounds are kept from rounding by one in a thousand.
pub fn holds<S: Scalar>(quantity: Quantity, particle: u32, bound: f64) -> Result<(), Error> {
    if !S::WRAPS || bound < 0.999 * S::LARGEST.to_f64() {
        return Ok(());
    }
    let (mut integer_bits, mut range) = (0, 0.999);
    while !(bound < range) && integer_bits < 127 {
        (integer_bits, range) = (integer_bits + 1, range + range);
    }
    Err(Error::Unproven {
        particle,
        quantity,
        integer_bits,
    })
}

/// A sorted cloud as a proof sees it.
pub struct Ground<'a, 'c, S, const D: usize> {
    /// The cloud.
    pub cells: &'a Cells<'c, S, D>,
    /// No particle has more partners.
    pub partners: f64,
    /// The largest distance of a pair.
    pub reach: f64,
}

impl<'a, 'c, S: Scalar, const D: usize> Ground<'a, 'c, S, D> {
    /// That of a cloud.
    pub fn of(cells: &'a Cells<'c, S, D>) -> Self {
        Self {
            cells,
            partners: cells.most_partners() as f64,
            reach: cells.grid().farthest().to_f64(),
        }
    }

    /// Refuses a bound that the format does not hold.
    pub fn holds(&self, quantity: Quantity, largest: Largest) -> Result<(), Error> {
        let id = self.cells.order().get(largest.place).copied();
        holds::<S>(quantity, id.unwrap_or(0), largest.bound)
    }
}
