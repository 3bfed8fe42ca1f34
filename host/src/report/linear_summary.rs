//! The summary of a run of a linear system: a table for people, one JSON object for programs.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;

use super::summary::{SpreadJson, ending};
use crate::comparison::Norms;
use crate::linear::{Experiment, RECONSTRUCTION, STATE};
use crate::simulation::Spread;

/// What a run came to. Serialised, it is the object that `--json` prints.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LinearSummary {
    /// Name of the scenario.
    pub scenario: String,
    /// Kind of the system.
    pub system: String,
    /// Name of the scalar.
    pub scalar: String,
    /// Dimension of space.
    pub dimension: usize,
    /// Names of the components.
    pub components: Vec<String>,
    /// Number of particles.
    pub particles: usize,
    /// Number of threads.
    pub threads: usize,
    /// Name of the time integrator.
    pub method: String,
    /// Mean spacing at the start.
    pub spacing: f64,
    /// Width of the cut-off.
    pub epsilon: f64,
    /// Steps made.
    pub steps: u64,
    /// Right-hand sides that they took.
    pub right_hand_sides: u64,
    /// Time reached.
    pub time: f64,
    /// The smallest and the largest time step.
    pub time_step: [f64; 2],
    /// Wall-clock seconds of the stepping.
    pub seconds: f64,
    /// Errors against the exact solution: of each component, of the state and of the
    /// reconstruction; `null` without one.
    pub errors: Option<BTreeMap<String, Norms>>,
    /// Drift of the sum of the strengths of each component, over the sum of their sizes; `null` where losses, sources or walls change it.
    pub drift: Option<BTreeMap<String, f64>>,
    /// The energy norm at the start and the end, and its bound at the end.
    pub energy_norm: EnergyJson,
    /// Neighbour counts at the end.
    pub neighbours: SpreadJson,
    /// Digest of the last state: 16 hexadecimal digits.
    pub digest: String,
    /// What a careful reader should know.
    pub warnings: Vec<String>,
}

/// The energy norm over a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct EnergyJson {
    /// At the start.
    pub first: f64,
    /// At the end.
    pub last: f64,
    /// What no solution exceeds at the end; `null` where nothing bounds them: driven walls, some
    /// reactions, a tensor in the direct form.
    pub bound: Option<f64>,
}

impl LinearSummary {
    /// Of an experiment made with that scalar on so many threads.
    pub fn new(experiment: &Experiment, scalar: &str, threads: usize) -> Self {
        let (plan, outcome) = (&experiment.plan, &experiment.outcome);
        let Spread { min, mean, max } = Spread::of(outcome.cloud.neighbours.iter().copied());
        let (first, last) = (
            &outcome.series[0],
            &outcome.series[outcome.series.len() - 1],
        );
        let thin = (min < 2.0 && plan.epsilon > 0.0).then(|| {
            format!(
                "a particle has {min} neighbour(s): the cloud is too thin there; use a \
                 larger epsilon (cut-off.eta)"
            )
        });
        Self {
            scenario: experiment.scenario.name.clone(),
            system: plan.system.name().to_owned(),
            scalar: scalar.to_owned(),
            dimension: plan.dimension,
            components: plan.names.clone(),
            particles: outcome.cloud.len(),
            threads,
            method: plan.method.name().to_owned(),
            spacing: plan.units.length,
            epsilon: plan.epsilon * plan.units.length,
            steps: outcome.steps,
            right_hand_sides: outcome.sides,
            time: outcome.time,
            time_step: [outcome.smallest_step, outcome.largest_step],
            seconds: outcome.seconds,
            errors: experiment.errors.clone(),
            drift: outcome.drift.as_ref().map(|drift| {
                plan.names
                    .iter()
                    .cloned()
                    .zip(drift.iter().copied())
                    .collect()
            }),
            energy_norm: EnergyJson {
                first: first.energy.norm,
                last: last.energy.norm,
                bound: Some(last.energy.bound).filter(|bound| bound.is_finite()),
            },
            neighbours: SpreadJson { min, mean, max },
            digest: outcome.digest.to_string(),
            warnings: thin
                .into_iter()
                .chain(experiment.doubts.iter().cloned())
                .collect(),
        }
    }
}

impl fmt::Display for LinearSummary {
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
            "{}: {}, {} particles, epsilon {:.2} spacings, {}, {} {threads}",
            self.scenario,
            self.system,
            self.particles,
            self.epsilon / self.spacing,
            self.scalar,
            self.threads
        )?;
        writeln!(
            f,
            "{} steps of {}, {} right-hand sides, to t = {:?} in {:.3} s: {per_step:.1} us a step, \
             {updates:.2} million particle updates/s",
            self.steps, self.method, self.right_hand_sides, self.time, self.seconds
        )?;
        if let Some(errors) = &self.errors {
            writeln!(f, "\n{:<16}{:>12}{:>12}{:>12}", "error", "L1", "L2", "Linf")?;
            let all = [STATE, RECONSTRUCTION];
            let fields = self.components.iter().map(String::as_str).chain(all);
            for (field, norms) in fields.filter_map(|field| errors.get_key_value(field)) {
                writeln!(
                    f,
                    "{field:<16}{:>12.4e}{:>12.4e}{:>12.4e}",
                    norms.l1, norms.l2, norms.linf
                )?;
            }
        }
        match &self.drift {
            Some(drift) => {
                let parts: Vec<_> = self
                    .components
                    .iter()
                    .filter_map(|name| Some(format!("{name} {:.1e}", drift.get(name)?)))
                    .collect();
                writeln!(f, "\ndrift      {}", parts.join(", "))?;
            }
            None => writeln!(
                f,
                "\ndrift      none to tell: losses, sources or walls change the sums"
            )?,
        }
        let EnergyJson { first, last, bound } = self.energy_norm;
        let bound = bound.map_or("no bound".to_owned(), |bound| format!("bound {bound:.6e}"));
        writeln!(f, "energy     norm {first:.6e} to {last:.6e}, {bound}")?;
        ending(
            f,
            self.time_step,
            self.neighbours,
            &self.digest,
            &self.warnings,
        )
    }
}
