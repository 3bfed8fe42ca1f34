//! What formulas are given, and where they are looked at before a run.

use motes_core::cloud::{Frame, Units};

use crate::scenario::Extent;

/// The way from places of the solver to points of formulas: a place and a time in the scenario's units.
pub(super) fn frame(extent: &Extent, units: Units) -> Frame {
    let middle = |i: usize| {
        if i < extent.lower.len() {
            extent.middle(i)
        } else {
            0.0
        }
    };
    Frame {
        middle: std::array::from_fn(middle),
        units,
    }
}

/// Nodes along each direction, and times, at which formulas are looked at before a run.
const NODES: [usize; 3] = [257, 33, 13];
/// Times, equally spaced from the start to the end.
pub(in crate::families) const TIMES: usize = 9;
/// What a formula may be between them, in what it is at them.
pub(in crate::families) const BETWEEN: f64 = 1.25;

/// Calls a function at points all over a box, at one time.
pub(in crate::families) fn all_over(extent: &Extent, time: f64, mut of: impl FnMut(&[f64; 4])) {
    let dimension = extent.lower.len();
    let nodes = NODES[dimension - 1];
    for mut number in 0..nodes.pow(dimension as u32) {
        let mut point = [0.0, 0.0, 0.0, time];
        for (i, x) in point.iter_mut().enumerate().take(dimension) {
            let part = (number % nodes) as f64 / (nodes - 1) as f64;
            *x = extent.lower[i] + part * (extent.upper[i] - extent.lower[i]);
            number /= nodes;
        }
        of(&point);
    }
}

/// The times at which formulas are looked at, from 0 to the end of a run.
pub(in crate::families) fn times(duration: f64) -> impl Iterator<Item = f64> {
    (0..TIMES).map(move |i| duration * i as f64 / (TIMES - 1) as f64)
}
