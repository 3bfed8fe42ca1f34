//! How fast a run gets on, and whether it ends in a time that one waits for.

/// Seconds over which a pace is measured, at the least.
const WINDOW: f64 = 2.0;

/// Steps over which a pace is measured, at the least.
const STEPS: u64 = 3;

/// Stretches, one after the other, that must all tell of a run without end: the first steps of a
/// blast are short.
const STRETCHES: u32 = 2;

/// Seconds of a day.
const DAY: f64 = 86_400.0;

/// Watches a run by the clock. Its caller has the clock, so that what is decided follows from the
/// numbers alone.
#[derive(Clone, Debug)]
pub struct Pace {
    /// Seconds that a run may take yet.
    longest: f64,
    mark: Mark,
    slow: u32,
}

/// Where a run is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mark {
    /// Seconds since its first step.
    pub seconds: f64,
    /// Part of it that is done, in [0, 1].
    pub done: f64,
    /// Steps made.
    pub steps: u64,
}

impl Pace {
    /// For a run that may take so many days.
    pub fn new(days: f64) -> Self {
        Self {
            longest: days * DAY,
            mark: Mark::default(),
            slow: 0,
        }
    }

    /// Hears where the run is; why it is to stop, if it would take longer.
    pub fn stops(&mut self, now: Mark) -> Option<String> {
        let (seconds, steps) = (now.seconds - self.mark.seconds, now.steps - self.mark.steps);
        if seconds < WINDOW || steps < STEPS {
            return None;
        }
        // Infinite where the run does not move in the digits of its own time.
        let left = (1.0 - now.done) * seconds / (now.done - self.mark.done);
        self.mark = now;
        if left <= self.longest {
            self.slow = 0;
            return None;
        }
        self.slow += 1;
        (self.slow >= STRETCHES).then(|| {
            format!(
                "the run has no end that one waits for: at its pace it would take some {} more, {:.1e} \
                 s a step; a speed, a diffusivity, a rate or a width is out of proportion to \
                 time.end, or has become so. --longest DAYS lets a run take more than {:.0} days",
                span(left),
                seconds / steps as f64,
                self.longest / DAY
            )
        })
    }
}

/// A time in words.
fn span(seconds: f64) -> String {
    let days = seconds / DAY;
    match days {
        days if days < 1000.0 => format!("{days:.1} days"),
        days if days < 1e9 => format!("{:.0} years", days / 365.25),
        _ => "millions of years".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What becomes of a run with such steps: seconds and parts of the run.
    fn watched(days: f64, steps: impl Iterator<Item = (f64, f64)>) -> Option<(u64, String)> {
        let mut pace = Pace::new(days);
        let mut now = Mark::default();
        for (seconds, part) in steps {
            now.seconds += seconds;
            now.done += part;
            now.steps += 1;
            if let Some(why) = pace.stops(now) {
                return Some((now.steps, why));
            }
        }
        None
    }

    #[test]
    fn a_run_of_years_stops_after_seconds_and_says_how_long_it_would_be() {
        // A millisecond a step, 1e12 steps: 31.7 years.
        let endless = std::iter::repeat_n((1e-3, 1e-12), 100_000);
        let (steps, why) = watched(365.0, endless).unwrap();
        assert!((4000..4100).contains(&steps), "{steps}");
        assert!(
            why.contains("32 years") && why.contains("--longest"),
            "{why}"
        );
        let endless = std::iter::repeat_n((1e-3, 1e-12), 100_000);
        assert_eq!(watched(20_000.0, endless), None);
        // Steps so short that the part done does not change.
        let still = std::iter::repeat_n((1e-3, 0.0), 100_000);
        assert!(
            watched(365.0, still)
                .unwrap()
                .1
                .contains("millions of years")
        );
    }

    #[test]
    fn a_run_that_ends_and_one_that_only_begins_slowly_go_on() {
        let fair = std::iter::repeat_n((0.1, 1e-6), 1_000_000);
        assert_eq!(watched(365.0, fair), None);
        // Two seconds of steps a million times too short.
        let slow = std::iter::repeat_n((0.01, 1e-13), 250);
        assert_eq!(
            watched(365.0, slow.chain(std::iter::repeat_n((0.01, 1e-6), 10_000))),
            None
        );
        // A step may take longer than the stretch.
        let long = std::iter::repeat_n((60.0, 1e-9), 6);
        assert_eq!(watched(365.0, long).unwrap().0, 6);
    }
}
