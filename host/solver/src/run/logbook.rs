//! What is measured of a run on its way: the time series, and what the end is compared with.

use std::time::Instant;

use motes_core::cloud::Words;
use motes_core::error::Error;

use super::error::RunError;
use super::outcome::{Outcome, Sample, Series};
use super::simulation::{Measures, Simulation, Step, Sum};
use crate::engine::Threads;

/// The logbook of a run: what [`Outcome`] is made of.
#[derive(Clone, Debug)]
pub struct Logbook {
    /// Rows of the time series, equally spaced in time.
    rows: usize,
    /// The sums at the start.
    first: Vec<Sum>,
    /// Those that were measured last.
    last: Vec<Sum>,
    samples: Vec<Sample>,
    /// Rows that have been due.
    due: f64,
    evaluations: u64,
    smallest: f64,
    largest: f64,
    /// What was computed all the same where it could not be proven to stay in range: the first of it.
    unproven: Option<String>,
    /// Wall-clock seconds before `since`.
    seconds: f64,
    since: Instant,
}

impl Logbook {
    /// That of a run at its start, for so many rows of the time series.
    pub fn new(simulation: &dyn Simulation, rows: usize) -> Self {
        let since = Instant::now();
        let (first, sample) = measured(simulation, 0.0);
        Self {
            rows,
            last: first.clone(),
            first,
            samples: vec![sample],
            due: 0.0,
            evaluations: 0,
            smallest: f64::INFINITY,
            largest: 0.0,
            unproven: None,
            seconds: 0.0,
            since,
        }
    }

    /// Notes a step that has just been made.
    ///
    /// # Errors
    /// Of the solver, where a row is due.
    pub fn step(
        &mut self,
        simulation: &mut dyn Simulation,
        step: Step,
        engine: &mut Threads,
    ) -> Result<(), RunError> {
        self.evaluations += u64::from(step.evaluations);
        // The last step is as long as what is left.
        if step.is_whole || self.largest == 0.0 {
            self.smallest = self.smallest.min(step.length);
            self.largest = self.largest.max(step.length);
        }
        if self.unproven.is_none() {
            self.unproven = engine.unproven().map(|error| error.to_string());
        }
        // A rounding short of its time is that time.
        let due = (simulation.done() * self.rows as f64 + 1e-9).floor();
        if due > self.due || simulation.is_over() {
            self.due = due;
            simulation.observe(engine)?;
            let (sums, sample) = measured(simulation, step.length);
            self.last = sums;
            self.samples.push(sample);
        }
        Ok(())
    }

    /// Passes all that is in it, times of day apart.
    ///
    /// # Errors
    /// Those of [`Words`].
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        words.same(self.rows as u64)?;
        for sums in [&mut self.first, &mut self.last] {
            for sum in sums {
                words.scalar(&mut sum.size)?;
                words.scalars(&mut sum.value)?;
            }
        }
        for number in [&mut self.due, &mut self.smallest, &mut self.largest] {
            words.scalar(number)?;
        }
        words.count(&mut self.evaluations)?;
        text(&mut self.unproven, words)?;
        let mut seconds = self.seconds + self.since.elapsed().as_secs_f64();
        words.scalar(&mut seconds)?;
        (self.seconds, self.since) = (seconds, Instant::now());
        let mut samples = self.samples.len() as u64;
        words.count(&mut samples)?;
        // There is one at least, that of the start, which says how many numbers a row has.
        let blank = self.samples[0].clone();
        for place in 0..samples {
            // No longer than what has been read: a number of rows is only a claim.
            if self.samples.len() as u64 <= place {
                self.samples.push(blank.clone());
            }
            let sample = &mut self.samples[place as usize];
            words.count(&mut sample.steps)?;
            words.scalar(&mut sample.time)?;
            words.scalar(&mut sample.time_step)?;
            words.scalars(&mut sample.values)?;
        }
        self.samples.truncate(samples as usize);
        Ok(())
    }

    /// What the run came to.
    ///
    /// # Errors
    /// Of the solver.
    pub fn close(
        self,
        simulation: &mut dyn Simulation,
        engine: &mut Threads,
    ) -> Result<Outcome, RunError> {
        let seconds = self.seconds + self.since.elapsed().as_secs_f64();
        let undamped = simulation.undamped(engine)?;
        let unproven = engine.take_unproven().map(|error| error.to_string());
        let digest = simulation.digest();
        let digest_unordered = simulation.digest_unordered();
        let description = simulation.description();
        let first = simulation.expected(self.first);
        let drift = first
            .iter()
            .zip(&self.last)
            .map(|(first, last)| drift(first, last));
        let drift = description.sums.iter().cloned().zip(drift);
        let is_any_known = description.known.contains(&true);
        let known = drift.zip(&description.known);
        let drift = known.filter(|(_, known)| **known || !is_any_known);
        Ok(Outcome {
            particles: simulation.particles(),
            series: Series {
                names: description.diagnostics.clone(),
                samples: self.samples,
            },
            steps: simulation.steps(),
            evaluations: self.evaluations,
            smallest_step: if self.smallest.is_finite() {
                self.smallest
            } else {
                0.0
            },
            largest_step: self.largest,
            time: simulation.time(),
            seconds,
            digest,
            digest_unordered,
            drift: drift.map(|(drift, _)| drift).collect(),
            is_conserving: description.is_conserving,
            neighbours: simulation.neighbours(),
            undamped,
            unproven: self.unproven.or(unproven),
        })
    }
}

/// Passes a text, where there is one.
fn text(text: &mut Option<String>, words: &mut dyn Words) -> Result<(), Error> {
    let mut bytes = text.take().unwrap_or_default().into_bytes();
    let mut length = bytes.len() as u64;
    words.count(&mut length)?;
    if length > LONGEST_TEXT {
        return Err(Error::Lengths);
    }
    bytes.resize(length as usize, 0);
    words.word(&mut bytes)?;
    let read = String::from_utf8(bytes).map_err(|_| Error::Lengths)?;
    *text = Some(read).filter(|text| !text.is_empty());
    Ok(())
}

/// More bytes than a sentence has.
const LONGEST_TEXT: u64 = 1 << 12;

/// The sums of now, and the rest of what is measured as a row of the time series.
fn measured(simulation: &dyn Simulation, time_step: f64) -> (Vec<Sum>, Sample) {
    let Measures { diagnostics, sums } = simulation.measures();
    let sample = Sample {
        time: simulation.time(),
        steps: simulation.steps(),
        time_step,
        values: diagnostics,
    };
    (sums, sample)
}

/// What a sum is off by from the one expected, over the larger of their sizes; of a vector the length.
fn drift(first: &Sum, last: &Sum) -> f64 {
    let moved = match (&first.value[..], &last.value[..]) {
        ([first], [last]) => last - first,
        (first, last) => {
            let squares = first.iter().zip(last).map(|(a, b)| (b - a) * (b - a));
            squares.sum::<f64>().sqrt()
        }
    };
    match moved == 0.0 {
        true => 0.0,
        false => moved / first.size.max(last.size),
    }
}
