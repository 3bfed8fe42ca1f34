//! Progress on the terminal, and Ctrl-C.

use std::io::{IsTerminal, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use indicatif::{HumanDuration, ProgressBar, ProgressStyle};

use crate::run::{Mark, Pace, Simulation};

/// Ctrl-C, once it is pressed, and whatever else asks the program to end.
#[derive(Clone, Default)]
pub(super) struct Interrupt {
    /// After the step.
    asked: Arc<AtomicBool>,
    /// In mid-step.
    at_once: Arc<AtomicBool>,
    /// Whether steps are made, whose end is worth waiting for.
    stepping: Arc<AtomicBool>,
}

impl Interrupt {
    /// Begins to listen.
    pub fn listen() -> Self {
        let interrupt = Self::default();
        let heard = interrupt.clone();
        // Without the handler Ctrl-C still ends the program, only less politely.
        let _ = ctrlc::set_handler(move || heard.press());
        interrupt
    }

    /// While steps are made, the first time lets the step end; the next stops what is computed, and the
    /// one after that the program.
    fn press(&self) {
        let again = self.asked.swap(true, Ordering::Relaxed);
        if !again && self.stepping.load(Ordering::Relaxed) {
            return;
        }
        if self.at_once.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    }

    /// Waits for the end of a step from now on.
    pub fn steps(&self) {
        self.stepping.store(true, Ordering::Relaxed);
    }

    /// Whether the program goes on.
    pub fn goes_on(&self) -> bool {
        !self.asked.load(Ordering::Relaxed)
    }

    /// What stops a step in its middle: true once that is asked for.
    pub fn flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.at_once)
    }
}

/// Days that a run may take without being asked for: nobody waits for a year.
pub(super) const LONGEST: f64 = 365.0;

/// Stops a run that would take longer than anybody waits.
pub(super) struct Patience {
    started: Option<Instant>,
    pace: Pace,
}

impl Patience {
    /// For a run that may take so many days.
    pub fn new(days: f64) -> Self {
        Self {
            started: None,
            pace: Pace::new(days),
        }
    }

    /// Looks at the run after a step.
    ///
    /// # Errors
    /// How long it would take.
    pub fn look(&mut self, simulation: &dyn Simulation) -> Result<(), String> {
        let started = self.started.get_or_insert_with(Instant::now);
        let now = Mark {
            seconds: started.elapsed().as_secs_f64(),
            done: simulation.done(),
            steps: simulation.steps(),
        };
        self.pace.stops(now).map_or(Ok(()), Err)
    }
}

/// Lines that say how far a run is where no terminal shows a bar: into log files.
pub(super) struct Lines {
    name: String,
    is_wanted: bool,
    started: Instant,
    told: Instant,
    /// What had been done when the program began.
    first: Option<(f64, u64)>,
}

/// How often a line is written.
const EVERY: Duration = Duration::from_secs(60);

impl Lines {
    /// For a run of that name; none where it is not wanted or a terminal shows a bar.
    pub fn new(name: &str, hidden: bool) -> Self {
        let now = Instant::now();
        Self {
            name: name.to_owned(),
            is_wanted: !hidden && !std::io::stderr().is_terminal(),
            started: now,
            told: now,
            first: None,
        }
    }

    /// Looks at the run after a step.
    pub fn look(&mut self, simulation: &dyn Simulation) {
        let (done, steps) = (simulation.done(), simulation.steps());
        let first = *self.first.get_or_insert((done, steps));
        if !self.is_wanted || self.told.elapsed() < EVERY {
            return;
        }
        self.told = Instant::now();
        let seconds = self.started.elapsed().as_secs_f64();
        let left = seconds * (1.0 - done) / (done - first.0);
        // Where nobody reads it the run goes on all the same.
        let _ = writeln!(
            std::io::stderr(),
            "{}: {:.1} %, t = {:.6}, {steps} steps, {:.1} a second, {} left",
            self.name,
            100.0 * done,
            simulation.time(),
            (steps - first.1) as f64 / seconds,
            HumanDuration(Duration::try_from_secs_f64(left).unwrap_or(Duration::MAX)),
        );
    }
}

/// A bar of that length and look; none where it is not wanted or nobody sees it.
pub(super) fn progress_bar(hidden: bool, length: u64, template: &str) -> ProgressBar {
    if hidden || !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(template);
    let bar = ProgressBar::new(length);
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
