//! Time, and when to stop.

use crate::cloud::Words;
use crate::error::Error;
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

    /// A run without an end, at its start. A time that grows so large that it no longer feels a
    /// step is an error ([`Error::Stalled`]): set it back before, where nothing depends on it.
    pub const fn endless() -> Self {
        Self::new(S::LARGEST)
    }

    /// The time that is left; `None` when the run is over.
    pub fn left(&self) -> Option<S> {
        let left = self.end - self.time;
        (left > S::ZERO).then_some(left)
    }

    /// A step of `dt`, or all that is `left` where no more than 2^-20 of a step would remain: that is
    /// rounding, and no step.
    pub fn with_rest(dt: S, left: S) -> S {
        let rest = left - dt;
        if rest <= dt * S::from_f64(9.536_743_164_062_5e-7) {
            left
        } else {
            dt
        }
    }

    /// Passes where the run is; its end is not of the run's making.
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        words.scalar(&mut self.time)?;
        words.count(&mut self.steps)
    }

    /// Counts a step of `dt`, at most what is left. Error: a step that the time, as a number
    /// of this format, does not feel; the run would never end.
    pub fn tick(&mut self, dt: S) -> Result<(), Error> {
        let left = self.end - self.time;
        let next = if dt >= left { self.end } else { self.time + dt };
        if !(next > self.time) {
            return Err(Error::Stalled);
        }
        self.time = next;
        self.steps = self.steps.saturating_add(1);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_step_ends_at_the_end_to_the_bit() {
        let mut clock = Clock::new(1.0f32);
        while let Some(left) = clock.left() {
            assert_eq!(clock.tick(if left < 0.3 { left } else { 0.3 }), Ok(()));
        }
        assert_eq!((clock.time, clock.steps), (1.0, 4));
    }

    /// Ten times 0.1 in f64 is 1.1e-16 short of 1: no eleventh step.
    #[test]
    fn what_rounding_leaves_is_no_step() {
        let mut clock = Clock::new(1.0f64);
        while let Some(left) = clock.left() {
            let dt = Clock::with_rest(if left < 0.1 { left } else { 0.1 }, left);
            assert_eq!(clock.tick(dt), Ok(()));
        }
        assert_eq!((clock.time, clock.steps), (1.0, 10));
        assert_eq!(Clock::with_rest(0.1, 0.100_001), 0.1);
        assert_eq!(Clock::with_rest(0.1f32, 0.100_000_01), 0.100_000_01);
    }

    #[test]
    fn a_step_that_the_time_does_not_feel_is_an_error() {
        let mut clock = Clock {
            time: 262_144.0f32,
            end: 1e6,
            steps: 7,
        };
        assert_eq!(clock.tick(0.01), Err(Error::Stalled));
        assert_eq!(clock.tick(0.0), Err(Error::Stalled));
        assert_eq!(clock.tick(f32::NAN), Err(Error::Stalled));
        assert_eq!(clock.steps, 7);
    }
}
