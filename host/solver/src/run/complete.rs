//! The run loop: from the start to the end, whatever is solved.

use std::time::Instant;

use super::error::RunError;
use super::outcome::{Outcome, Sample, Series};
use super::simulation::{Measures, Simulation, Sum};
use crate::engine::Threads;

/// What a run tells its caller, and hears from it, between steps.
pub struct Control<'a> {
    /// Rows of the time series, equally spaced in time.
    pub samples: usize,
    /// Called with the part of the run that is done, in [0, 1]; `false` stops the run.
    pub progress: &'a mut dyn FnMut(f64) -> bool,
    /// Called at the start and after each step. Looking changes no bit.
    pub look: &'a mut dyn FnMut(&dyn Simulation) -> Result<(), String>,
}

/// Steps a simulation from where it is to its end.
///
/// # Errors
/// What [`RunError`] lists.
pub fn complete(
    simulation: &mut dyn Simulation,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    let started = Instant::now();
    let (first, sample) = measured(simulation, 0.0);
    let (mut last, mut samples) = (first.clone(), vec![sample]);
    let (mut sampled, mut evaluations) = (0.0, 0);
    let (mut smallest, mut largest) = (f64::INFINITY, 0.0f64);
    show(simulation, control)?;
    while let Some(step) = simulation.step(engine)? {
        evaluations += u64::from(step.evaluations);
        // The last step is as long as what is left.
        if step.is_whole || largest == 0.0 {
            (smallest, largest) = (smallest.min(step.length), largest.max(step.length));
        }
        let done = simulation.done();
        // A rounding short of its time is that time.
        let due = (done * control.samples as f64 + 1e-9).floor();
        if due > sampled || simulation.is_over() {
            sampled = due;
            simulation.observe(engine)?;
            let (sums, sample) = measured(simulation, step.length);
            last = sums;
            samples.push(sample);
        }
        show(simulation, control)?;
        if !(control.progress)(done) {
            return Err(RunError::Interrupted {
                time: simulation.time(),
                step: simulation.steps(),
            });
        }
    }
    let seconds = started.elapsed().as_secs_f64();
    let undamped = simulation.undamped(engine)?;
    let digest = simulation.digest();
    let digest_unordered = simulation.digest_unordered();
    let description = simulation.description();
    let first = simulation.expected(first);
    let drift = first
        .iter()
        .zip(&last)
        .map(|(first, last)| drift(first, last));
    let drift = description.sums.iter().cloned().zip(drift);
    let is_any_known = description.known.contains(&true);
    let known = drift.zip(&description.known);
    let drift = known.filter(|(_, known)| **known || !is_any_known);
    Ok(Outcome {
        particles: simulation.particles(),
        series: Series {
            names: description.diagnostics.clone(),
            samples,
        },
        steps: simulation.steps(),
        evaluations,
        smallest_step: if smallest.is_finite() { smallest } else { 0.0 },
        largest_step: largest,
        time: simulation.time(),
        seconds,
        digest,
        digest_unordered,
        drift: drift.map(|(drift, _)| drift).collect(),
        is_conserving: description.is_conserving,
        neighbours: simulation.neighbours(),
        undamped,
    })
}

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

fn show(simulation: &dyn Simulation, control: &mut Control<'_>) -> Result<(), RunError> {
    (control.look)(simulation).map_err(|reason| RunError::Look {
        time: simulation.time(),
        reason,
    })
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
