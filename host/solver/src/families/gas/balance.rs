//! The mass that comes in and goes out through open sides.

use motes_core::cloud::Words;
use motes_core::domain::Domain;
use motes_core::error::Error;
use motes_core::scalar::Scalar;

use super::opening::{OpenSides, OpenZone};
use crate::run::{Balance, Series, inflow};
use crate::sums::Compensated;

/// What comes in.
const MASS: &str = "mass";

/// What has passed the open sides since the start.
#[derive(Clone, Debug, Default)]
pub(super) struct MassLedger {
    /// The mass that has come in at the lower and the upper side, below 0 where it went out, in
    /// units of the solver.
    mass: [Compensated; 2],
    /// Beyond which side each particle was before the step: 0 or 1, or 2 for none.
    before: Vec<u8>,
}

impl MassLedger {
    /// Remembers where particles are, before a step.
    pub fn open<S: Scalar, const D: usize>(&mut self, domain: &Domain<S, D>, at: &[[S; D]]) {
        self.before.clear();
        self.before.extend(at.iter().map(|x| place(domain, x)));
    }

    /// Counts those that have passed a side in the step.
    pub fn close<S: Scalar, const D: usize>(
        &mut self,
        domain: &Domain<S, D>,
        at: &[[S; D]],
        mass: &[S],
    ) {
        for ((&before, x), mass) in self.before.iter().zip(at).zip(mass) {
            let now = place(domain, x);
            if now == before {
                continue;
            }
            for (side, sign) in [(before, 1.0), (now, -1.0)] {
                if let Some(sum) = self.mass.get_mut(usize::from(side)) {
                    sum.add(sign * mass.to_f64());
                }
            }
        }
    }

    /// Passes the masses.
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        self.mass.iter_mut().try_for_each(|sum| sum.pass(words))
    }

    /// The mass that has come in through a side, in units of the solver.
    pub fn mass(&self, end: usize) -> f64 {
        self.mass[end].value()
    }
}

/// The open side that a position is beyond; 2 for none.
fn place<S: Scalar, const D: usize>(domain: &Domain<S, D>, position: &[S; D]) -> u8 {
    domain
        .passed(position)
        .map_or(2, |(_, side)| side.end as u8)
}

/// The sides that are open, by direction and end.
fn open_sides(opening: Option<&OpenSides>) -> impl Iterator<Item = (usize, usize)> {
    opening.into_iter().flat_map(|opening| {
        let is_open = |&end: &usize| opening.zones[end] != OpenZone::Shut;
        (0..2).filter(is_open).map(|end| (opening.axis, end))
    })
}

/// The ends of the sides that are open, and the columns that say what came in there.
pub(super) fn columns(opening: Option<&OpenSides>) -> Vec<(usize, String)> {
    open_sides(opening)
        .map(|(axis, end)| (end, inflow(axis, end, MASS)))
        .collect()
}

/// The balance of the mass; none where no side is open.
pub(super) fn balance(opening: Option<&OpenSides>, series: &Series) -> Vec<Balance> {
    let has_any = open_sides(opening).next().is_some();
    let of = || Balance::of(series, (MASS, MASS), open_sides(opening), None);
    has_any.then(of).into_iter().collect()
}
