//! Times that steps are to end at.

use motes_core::cloud::Words;
use motes_core::error::Error;
use motes_core::integrator::Clock;
use motes_core::scalar::Scalar;

/// How near to a time, as a part of its interval, a run must be to have reached it: rounding.
const REACHED: f64 = 1e-9;

/// The multiples of some intervals, in the scenario's unit of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Schedule {
    intervals: Vec<f64>,
}

impl Schedule {
    /// Of these intervals, each > 0.
    pub fn new(intervals: Vec<f64>) -> Self {
        Self { intervals }
    }

    /// The first time after this one; infinite where there is none.
    pub fn after(&self, time: f64) -> f64 {
        let next = |every: &f64| ((time / every + REACHED).floor() + 1.0) * every;
        self.intervals
            .iter()
            .map(next)
            .fold(f64::INFINITY, f64::min)
    }
}

/// How far a step may go.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Room<S> {
    /// Its length at the most.
    pub longest: S,
    /// Where it ends then, as the clock counts, and in the scenario's unit; `None` at the end of
    /// the run.
    place: Option<(S, f64)>,
}

/// The schedule of a run, and the time of it that the run has met.
#[derive(Clone, Debug)]
pub(crate) struct Stops<S> {
    schedule: Schedule,
    met: Option<(S, f64)>,
}

impl<S: Scalar> Stops<S> {
    /// No times to meet.
    pub fn none() -> Self {
        Self::new(Schedule::default())
    }

    /// The times of a schedule.
    pub fn new(schedule: Schedule) -> Self {
        Self {
            schedule,
            met: None,
        }
    }

    /// Passes the time that was met.
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        let mut has_met = u64::from(self.met.is_some());
        words.count(&mut has_met)?;
        let (mut place, mut time) = self.met.unwrap_or((S::ZERO, 0.0));
        words.scalar(&mut place)?;
        words.scalar(&mut time)?;
        self.met = (has_met != 0).then_some((place, time));
        Ok(())
    }

    /// The time of a clock in the scenario's unit: the very time that was asked for where the run
    /// has met one.
    pub fn time(&self, clock: &Clock<S>, unit: f64) -> f64 {
        match self.met {
            Some((place, time)) if place == clock.time => time,
            _ => clock.time.to_f64() * unit,
        }
    }

    /// How far a step may go, with so much left to the end of the run.
    pub fn room(&self, clock: &Clock<S>, left: S, unit: f64) -> Room<S> {
        let end = Room {
            longest: left,
            place: None,
        };
        let time = self.schedule.after(self.time(clock, unit));
        if !(time < clock.end.to_f64() * unit * (1.0 - REACHED)) {
            return end;
        }
        let place = S::from_f64(time / unit);
        let longest = place - clock.time;
        // A format may not tell the time from that of now.
        if !(longest > S::ZERO && longest < left) {
            return end;
        }
        Room {
            longest,
            place: Some((place, time)),
        }
    }

    /// Moves a clock on by a step: to the bit where the step fills its room.
    pub fn tick(&mut self, clock: &mut Clock<S>, dt: S, room: &Room<S>) -> Result<(), Error> {
        clock.tick(dt)?;
        if let (Some(met), false) = (room.place, dt < room.longest) {
            clock.time = met.0;
            self.met = Some(met);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_multiple_of_every_interval_is_met_once_to_the_bit() {
        let (unit, end) = (0.37, 1.0);
        let schedule = Schedule::new(vec![0.1, 0.3, 1.0 / 7.0]);
        let mut stops = Stops::<f32>::new(schedule);
        let mut clock = Clock::new((end / unit) as f32);
        let mut seen = Vec::new();
        while let Some(left) = clock.left() {
            let room = stops.room(&clock, left, unit);
            let dt = room.longest.lesser(0.11);
            stops.tick(&mut clock, dt, &room).unwrap();
            if !(dt < room.longest) {
                seen.push(stops.time(&clock, unit));
            }
        }
        let tenths = (1..10).map(|i| 0.1 * f64::from(i));
        let mut expected: Vec<f64> = tenths.chain((1..7).map(|i| f64::from(i) / 7.0)).collect();
        expected.sort_by(f64::total_cmp);
        assert_eq!(seen.len(), expected.len() + 1, "{seen:?}");
        for (seen, expected) in seen.iter().zip(&expected) {
            assert!((seen - expected).abs() < 1e-15, "{seen} for {expected}");
        }
        assert_eq!(clock.time, clock.end);
    }
}
