//! Where the solver's numbers are in the scenario's units: what formulas are given.

use motes_core::cloud::Place;
use motes_core::equation::linear::systems::Units;
use motes_core::scalar::Scalar;

use crate::scenario::Extent;

/// The way from a place of the solver to a point of a formula: a place and a time in the scenario's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The middle of the domain, 0 for the solver; 0 beyond the dimension.
    pub middle: [f64; 3],
    /// What the solver units are.
    pub units: Units,
}

impl Frame {
    /// That of a domain.
    pub fn new(extent: &Extent, units: Units) -> Self {
        let middle = |i: usize| {
            if i < extent.lower.len() {
                extent.middle(i)
            } else {
                0.0
            }
        };
        Self {
            middle: std::array::from_fn(middle),
            units,
        }
    }

    /// The unit of time in the scenario's units.
    pub fn time(&self) -> f64 {
        self.units.length / self.units.velocity
    }

    /// A point as formulas take it.
    pub fn point<S: Scalar, const D: usize>(&self, place: &Place<S, D>) -> [f64; 4] {
        let x = |i: usize| match place.position.get(i) {
            Some(x) => self.middle[i] + x.to_f64() * self.units.length,
            None => 0.0,
        };
        [x(0), x(1), x(2), place.time.to_f64() * self.time()]
    }
}

/// The value of a formula in the scalar of a run. What is no number stays none in floats; a format that
/// has none takes its largest number, which no proof lets pass.
pub(in crate::families) fn rounded<S: Scalar>(value: f64) -> S {
    match value.is_nan() && S::WRAPS {
        true => S::LARGEST,
        false => S::from_f64(value),
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
