//! The mass that comes in and goes out through open sides.

use motes_core::domain::Domain;
use motes_core::scalar::Scalar;

use super::opening::{OpenSides, OpenZone};
use crate::run::{Balance, Series};
use crate::sums::Compensated;

const AXES: [&str; 3] = ["x", "y", "z"];
const ENDS: [&str; 2] = ["lower", "upper"];

/// What has passed the open sides since the start.
#[derive(Clone, Debug, Default)]
pub(super) struct Ledger {
    /// The mass that has come in at the lower and the upper side, below 0 where it went out, in
    /// units of the solver.
    mass: [Compensated; 2],
    /// Beyond which side each particle was before the step: 0 or 1, or 2 for none.
    before: Vec<u8>,
}

impl Ledger {
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

/// The ends of the sides that are open, and the columns that say what came in there.
pub(super) fn columns(opening: Option<&OpenSides>) -> Vec<(usize, String)> {
    let Some(opening) = opening else {
        return Vec::new();
    };
    let is_open = |&end: &usize| opening.zones[end] != OpenZone::Shut;
    let name = |end: usize| format!("{}_{}", AXES[opening.axis], ENDS[end]);
    let ends = (0..ENDS.len()).filter(is_open);
    ends.map(|end| (end, format!("inflow_{}_mass", name(end))))
        .collect()
}

/// The balance of the mass; none where no side is open.
pub(super) fn balance(opening: Option<&OpenSides>, series: &Series) -> Vec<Balance> {
    let columns = columns(opening);
    if columns.is_empty() {
        return Vec::new();
    }
    let mass = series.of("mass");
    let ends = mass.last().zip(mass.first());
    let change = ends.map_or(f64::NAN, |(last, first)| last - first);
    let walls = columns.iter().map(|(_, column)| {
        let came = series.of(column).last().copied().unwrap_or(f64::NAN);
        let side = column.trim_start_matches("inflow_");
        (side.trim_end_matches("_mass").to_owned(), came)
    });
    let walls: std::collections::BTreeMap<_, _> = walls.collect();
    let residual = change - walls.values().sum::<f64>();
    vec![Balance {
        component: "mass".to_owned(),
        change,
        walls,
        reactions: None,
        residual,
    }]
}
