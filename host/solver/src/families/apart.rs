//! That no two particles of a run start in one place, as its scalar rounds them.

use motes_core::domain::Axis;
use motes_core::scalar::Scalar;

use crate::run::RunError;
use crate::setup::{Room, SAME_PLACE, coincidence, mean_spacing};

/// Where a cloud lies: its axes in solver units, and what makes the scenario's of a place.
pub(super) struct Frame<'a> {
    pub axes: &'a [Axis<f64>; 3],
    pub middle: [f64; 3],
    pub length: f64,
}

/// Refuses two particles in one place.
///
/// # Errors
/// [`RunError::Coincident`].
pub(super) fn check_apart<'a, S: Scalar>(
    positions: impl Iterator<Item = &'a [S]>,
    frame: &Frame<'_>,
    scalar: &str,
) -> Result<(), RunError> {
    let mut dimension = 0;
    let spread = |x: &[S]| {
        dimension = x.len();
        std::array::from_fn(|i| x.get(i).map_or(0.0, |x| x.to_f64()))
    };
    let positions: Vec<[f64; 3]> = positions.map(spread).collect();
    let along = |i: usize| frame.axes.get(i).filter(|_| i < dimension);
    let mut room = Room {
        lower: std::array::from_fn(|i| along(i).map_or(0.0, |axis| axis.lower)),
        lengths: std::array::from_fn(|i| along(i).map_or(0.0, |axis| axis.upper - axis.lower)),
        periodic: std::array::from_fn(|i| along(i).is_some_and(Axis::is_periodic)),
    };
    let tolerance = SAME_PLACE * mean_spacing(&positions, &room);
    let Some(found) = coincidence(&positions, &room, tolerance) else {
        return Ok(());
    };
    room.lengths = room.lengths.map(|length| length * frame.length);
    let place = positions[found.second];
    let place = std::array::from_fn(|i| frame.middle[i] + place[i] * frame.length);
    Err(RunError::Coincident {
        first: found.first,
        second: found.second,
        count: found.count,
        place: room.shown(&place),
        scalar: scalar.to_owned(),
    })
}
