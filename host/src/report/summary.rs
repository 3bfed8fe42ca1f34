//! The summary of a run: a table for people, one JSON object for programs.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Serialize, Serializer};

use crate::experiment::Experiment;
use crate::run::{Balance, EnergyNorm, Norms, Spread};

/// What a run came to. Serialised, it is the object that `--json` prints; what only some families
/// have is left out of the object of the others.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Name of the scenario.
    pub scenario: String,
    /// Kind of the system.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub system: Option<String>,
    /// Name of the scalar.
    pub scalar: String,
    /// Dimension of space.
    pub dimension: usize,
    /// Names of the components.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub components: Option<Vec<String>>,
    /// Number of particles.
    pub particles: usize,
    /// Number of threads.
    pub threads: usize,
    /// Name of the time integrator.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub method: Option<String>,
    /// Mean spacing at the start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spacing: Option<f64>,
    /// Width of the cut-off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub epsilon: Option<f64>,
    /// Steps made.
    pub steps: u64,
    /// Right-hand sides that they took.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub right_hand_sides: Option<u64>,
    /// Time reached.
    pub time: f64,
    /// The smallest and the largest time step.
    pub time_step: [f64; 2],
    /// Wall-clock seconds of the stepping.
    pub seconds: f64,
    /// Errors against the exact solution by field; `null` without one.
    pub errors: Option<BTreeMap<String, Norms>>,
    /// Drift of the sums of which it is known what they should be; `null` where there is none.
    #[serde(serialize_with = "as_object")]
    pub drift: Option<Vec<(String, f64)>>,
    /// The energy norm at the start and the end, and its bound at the end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy_norm: Option<EnergyNorm>,
    /// What came in through walls or open sides and from reactions, by component; left out where
    /// nothing may.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub balance: Vec<Balance>,
    /// The force of a gas on each of its walls at the end; left out where there is none.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub wall_forces: BTreeMap<String, Vec<f64>>,
    /// Neighbour counts at the end.
    pub neighbours: Spread,
    /// Digest of the last state: 16 hexadecimal digits.
    pub digest: String,
    /// The same whatever the order of the particles: a sum over them.
    pub digest_unordered: String,
    /// What a careful reader should know.
    pub warnings: Vec<String>,
    /// The fields compared, in the order of tables.
    #[serde(skip)]
    fields: Vec<String>,
    /// Why there is no drift to tell.
    #[serde(skip)]
    leak: &'static str,
}

/// Named numbers as an object that keeps their order.
fn as_object<S: Serializer>(
    numbers: &Option<Vec<(String, f64)>>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match numbers {
        Some(numbers) => serializer.collect_map(numbers.iter().map(|(name, x)| (name, x))),
        None => serializer.serialize_none(),
    }
}

impl Summary {
    /// Of an experiment made with that scalar on so many threads.
    pub fn new(experiment: &Experiment, scalar: &str, threads: usize) -> Self {
        let (outcome, simulation) = (&experiment.outcome, &experiment.simulation);
        let description = simulation.description();
        let summary = Self {
            scenario: experiment.scenario.name().to_owned(),
            system: None,
            scalar: scalar.to_owned(),
            dimension: description.dimension,
            components: None,
            particles: outcome.particles,
            threads,
            method: None,
            spacing: None,
            epsilon: None,
            steps: outcome.steps,
            right_hand_sides: None,
            time: outcome.time,
            time_step: [outcome.smallest_step, outcome.largest_step],
            seconds: outcome.seconds,
            errors: experiment.errors.clone(),
            drift: experiment.drift(),
            energy_norm: None,
            balance: simulation.balance(outcome),
            wall_forces: simulation.wall_forces(outcome),
            neighbours: outcome.neighbours,
            digest: outcome.digest.to_string(),
            digest_unordered: outcome.digest_unordered.to_string(),
            warnings: experiment.warnings(),
            fields: crate::families::compared(&experiment.scenario),
            leak: description.leak,
        };
        let Some(particulars) = simulation.particulars(outcome) else {
            return summary;
        };
        let mut drift = summary.drift;
        if let Some(drift) = &mut drift {
            drift.sort_by(|a, b| a.0.cmp(&b.0));
        }
        Self {
            system: Some(particulars.system),
            components: Some(particulars.components),
            method: Some(particulars.method),
            spacing: Some(description.spacing),
            epsilon: Some(particulars.epsilon),
            right_hand_sides: Some(outcome.evaluations),
            energy_norm: Some(particulars.energy_norm),
            drift,
            ..summary
        }
    }

    /// The first two lines: what was run, and how.
    fn head(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let threads = if self.threads == 1 {
            "thread"
        } else {
            "threads"
        };
        write!(f, "{}: ", self.scenario)?;
        if let Some(system) = &self.system {
            write!(f, "{system}, ")?;
        }
        write!(f, "{} particles, ", self.particles)?;
        if let (Some(epsilon), Some(spacing)) = (self.epsilon, self.spacing) {
            write!(f, "epsilon {:.2} spacings, ", epsilon / spacing)?;
        }
        writeln!(f, "{}, {} {threads}", self.scalar, self.threads)?;
        write!(f, "{} steps ", self.steps)?;
        if let (Some(method), Some(sides)) = (&self.method, self.right_hand_sides) {
            write!(f, "of {method}, {sides} right-hand sides, ")?;
        }
        let per_step = 1e6 * self.seconds / self.steps.max(1) as f64;
        let updates = self.particles as f64 * self.steps as f64 / self.seconds / 1e6;
        writeln!(
            f,
            "to t = {:?} in {:.3} s: {per_step:.1} us a step, {updates:.2} million particle \
             updates/s",
            self.time, self.seconds
        )
    }

    fn errors(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(errors) = &self.errors else {
            return Ok(());
        };
        let width = 2 + self.fields.iter().map(String::len).max().unwrap_or(0);
        writeln!(
            f,
            "\n{:<width$}{:>12}{:>12}{:>12}",
            "error", "L1", "L2", "Linf"
        )?;
        let fields = self.fields.iter();
        for (field, norms) in fields.filter_map(|field| errors.get_key_value(field)) {
            let Norms { l1, l2, linf, .. } = norms;
            writeln!(f, "{field:<width$}{l1:>12.4e}{l2:>12.4e}{linf:>12.4e}")?;
        }
        Ok(())
    }

    fn sums(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.drift {
            Some(drift) => {
                let parts = drift
                    .iter()
                    .map(|(name, drift)| format!("{name} {drift:.1e}"));
                writeln!(f, "\ndrift      {}", parts.collect::<Vec<_>>().join(", "))?;
            }
            None => {
                writeln!(f, "\ndrift      none to tell: {}", self.leak)?;
            }
        }
        if let Some(EnergyNorm { first, last, bound }) = self.energy_norm {
            let bound = bound.map_or("no bound".to_owned(), |bound| format!("bound {bound:.6e}"));
            writeln!(f, "energy     norm {first:.6e} to {last:.6e}, {bound}")?;
        }
        for balance in &self.balance {
            let walls = balance.walls.iter();
            let walls =
                walls.map(|(wall, value)| format!("{} {value:+.6e}", wall.replace('_', " ")));
            let reactions = balance
                .reactions
                .map(|value| format!("reactions {value:+.6e}"));
            let parts: Vec<String> = walls.chain(reactions).collect();
            let Balance {
                component,
                change,
                residual,
                ..
            } = balance;
            let parts = parts.join(", ");
            writeln!(
                f,
                "balance    {component} {change:+.6e}: {parts}, left {residual:.1e}"
            )?;
        }
        Ok(())
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.head(f)?;
        self.errors(f)?;
        self.sums(f)?;
        let ([smallest, largest], Spread { min, mean, max }) = (self.time_step, self.neighbours);
        writeln!(f, "time step  {smallest:.3e} to {largest:.3e}")?;
        writeln!(f, "neighbours {min} to {max}, mean {mean:.2}")?;
        writeln!(f, "digest     {}", self.digest)?;
        write!(
            f,
            "           {} in any order of the particles",
            self.digest_unordered
        )?;
        for warning in &self.warnings {
            write!(f, "\nwarning: {warning}")?;
        }
        Ok(())
    }
}
