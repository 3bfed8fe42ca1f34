//! Time, and when to stop.

use crate::scalar::Scalar;

/// The time of a run from 0 to `end`. The last step ends at `end` to the bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock<S> {
    /// Where the run is.
    pub time: S,
    /// Where it ends.
    pub end: S,
    /// Steps made.
    pub steps: u64,
}

impl<S: Scalar> Clock<S> {
    /// A run of that duration, at its start.
    pub const fn new(end: S) -> Self {
        Self {
            time: S::ZERO,
            end,
            steps: 0,
        }
    }

    /// The time that is left; `None` when the run is over.
    pub fn left(&self) -> Option<S> {
        let left = self.end - self.time;
        (left > S::ZERO).then_some(left)
    }

    /// Counts a step of `dt`, at most what is left.
    pub fn tick(&mut self, dt: S) {
        let left = self.end - self.time;
        self.time = if dt < left { self.time + dt } else { self.end };
        self.steps += 1;
    }
}
