//! The summary of a run: a table for people, one JSON object for programs.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;

use crate::comparison::{FIELDS, Norms};
use crate::experiment::Experiment;
use crate::simulation::{Outcome, Spread};

/// What a run came to. Serialised, it is the object that `--json` prints.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the scalar.
    pub scalar: String,
    /// Dimension of space.
    pub dimension: usize,
    /// Number of particles.
    pub particles: usize,
    /// Number of threads.
    pub threads: usize,
    /// Steps made.
    pub steps: u64,
    /// Time reached.
    pub time: f64,
    /// The smallest and the largest time step.
    pub time_step: [f64; 2],
    /// Wall-clock seconds of the stepping.
    pub seconds: f64,
    /// Errors against the exact solution; `null` without one.
    pub errors: Option<BTreeMap<&'static str, Norms>>,
    /// Drift of the conserved sums; `null` where gas flows through the sides.
    pub drift: Option<DriftJson>,
    /// Neighbour counts at the end.
    pub neighbours: SpreadJson,
    /// Digest of the last state: 16 hexadecimal digits.
    pub digest: String,
    /// What a careful reader should know.
    pub warnings: Vec<String>,
}

/// Drift of the conserved sums.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DriftJson {
    /// Relative.
    pub mass: f64,
    /// Over total mass times the reference speed.
    pub momentum: f64,
    /// Over total mass times the reference speed times the size of the domain.
    pub angular_momentum: f64,
    /// Relative.
    pub energy: f64,
}

/// Smallest, mean and largest.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SpreadJson {
    /// The smallest.
    pub min: f64,
    /// The mean.
    pub mean: f64,
    /// The largest.
    pub max: f64,
}

impl Summary {
    /// Of an experiment made with that scalar on so many threads.
    pub fn new(experiment: &Experiment, scalar: &str, threads: usize) -> Self {
        let outcome = &experiment.outcome;
        let Spread { min, mean, max } =
            Spread::of(outcome.particles.iter().map(|particle| particle.neighbours));
        let lonely = outcome.lonely.iter().map(|lonely| {
            format!(
                "particle {} had {} neighbour(s) at t = {:.6}: its density no longer feels the \
                 spacing, and waves may move at wrong speeds; use eta, or a larger epsilon",
                lonely.particle, lonely.neighbours, lonely.time
            )
        });
        Self {
            scenario: experiment.scenario.name.clone(),
            scalar: scalar.to_owned(),
            dimension: experiment.scenario.dimension,
            particles: outcome.particles.len(),
            threads,
            steps: outcome.steps,
            time: outcome.time,
            time_step: [outcome.smallest_step, outcome.largest_step],
            seconds: outcome.seconds,
            errors: experiment.errors.clone(),
            drift: (!outcome.is_open).then_some(DriftJson {
                mass: outcome.drift.mass,
                momentum: outcome.drift.momentum,
                angular_momentum: outcome.drift.angular_momentum,
                energy: outcome.drift.energy,
            }),
            neighbours: SpreadJson { min, mean, max },
            digest: outcome.digest.to_string(),
            warnings: lonely
                .chain(drifted(outcome))
                .chain(experiment.doubts.iter().cloned())
                .collect(),
        }
    }
}

/// The energy that a sound run may gain or lose: leap-frog and viscosity stay far below it.
const SOUND_DRIFT: f64 = 1e-3;

/// A warning where the energy has moved as it does not in a sound run.
fn drifted(outcome: &Outcome) -> Option<String> {
    let drift = outcome.drift.energy;
    (!outcome.is_open && !(drift.abs() < SOUND_DRIFT)).then(|| {
        format!(
            "the total energy moved by {drift:.1e} of itself: in fixed point numbers may have \
             overflowed (--check-overflow tells), else the time step is too large (time.courant)"
        )
    })
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let per_step = 1e6 * self.seconds / self.steps.max(1) as f64;
        let updates = self.particles as f64 * self.steps as f64 / self.seconds / 1e6;
        let threads = if self.threads == 1 {
            "thread"
        } else {
            "threads"
        };
        writeln!(
            f,
            "{}: {} particles, {}, {} {threads}",
            self.scenario, self.particles, self.scalar, self.threads
        )?;
        writeln!(
            f,
            "{} steps to t = {} in {:.3} s: {per_step:.1} us a step, {updates:.2} million particle \
             updates/s",
            self.steps, self.time, self.seconds
        )?;
        if let Some(errors) = &self.errors {
            writeln!(f, "\n{:<10}{:>12}{:>12}{:>12}", "error", "L1", "L2", "Linf")?;
            for (field, norms) in FIELDS
                .iter()
                .filter_map(|field| errors.get_key_value(field))
            {
                writeln!(
                    f,
                    "{field:<10}{:>12.4e}{:>12.4e}{:>12.4e}",
                    norms.l1, norms.l2, norms.linf
                )?;
            }
        }
        match &self.drift {
            Some(drift) => writeln!(
                f,
                "\ndrift      mass {:.1e}, momentum {:.1e}, energy {:.1e}",
                drift.mass, drift.momentum, drift.energy
            )?,
            None => writeln!(f, "\ndrift      none to tell: gas flows through the sides")?,
        }
        ending(
            f,
            self.time_step,
            self.neighbours,
            &self.digest,
            &self.warnings,
        )
    }
}

/// The last lines of every summary.
pub(super) fn ending(
    f: &mut fmt::Formatter<'_>,
    [smallest, largest]: [f64; 2],
    SpreadJson { min, mean, max }: SpreadJson,
    digest: &str,
    warnings: &[String],
) -> fmt::Result {
    writeln!(f, "time step  {smallest:.3e} to {largest:.3e}")?;
    writeln!(f, "neighbours {min} to {max}, mean {mean:.2}")?;
    write!(f, "digest     {digest}")?;
    for warning in warnings {
        write!(f, "\nwarning: {warning}")?;
    }
    Ok(())
}
