//! One scenario in several number formats: what each loses, what it takes, and which is enough.
//!
//! Each format is a whole run. The runs are compared at their end, particle by particle, with the one
//! in the finest format ([`Difference`]), and with the exact solution where there is one.

mod difference;
mod format;
mod last;
mod rounding;
mod side_by_side;

pub use difference::{Difference, Matching};
pub use format::{FormatOutcome, FormatRow, Ran, Refusal, finest};
pub use last::{LastState, POSITION};
pub use rounding::{Loss, Rounding, step};
pub use side_by_side::{shares, side_by_side};

use crate::run::ScalarName;
use crate::scenario::AnyScenario;

/// What a comparison came to. Serialised, it is the object that `--json` prints.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Comparison {
    /// Name of the scenario.
    pub scenario: String,
    /// Dimension of space.
    pub dimension: usize,
    /// Particles at the start.
    pub particles: usize,
    /// The time at which the runs are compared, that of their end.
    pub time: f64,
    /// The field of the line, the picture and the first table.
    pub field: String,
    /// The format that the others are compared with: the finest that ran.
    pub reference: String,
    /// The L2 norm of the field itself in the reference; `None` without particles in the window.
    pub size: Option<f64>,
    /// A row for each format, in the order they were asked for.
    pub rows: Vec<FormatRow>,
    /// How the difference of the field falls with the bits behind the point.
    pub rounding: Rounding,
    /// What a careful reader should know: what all runs share once, the rest with its format.
    pub warnings: Vec<String>,
}

/// A run that is compared.
pub struct Finished {
    /// What it came to, without its difference.
    pub ran: Ran,
    /// Its particles.
    pub last: LastState,
}

impl Comparison {
    /// Of runs in some formats, or why there are none; `None` where there is none at all.
    pub fn new(
        scenario: &AnyScenario,
        field: &str,
        runs: Vec<(ScalarName, Result<Finished, Refusal>)>,
    ) -> Option<Self> {
        let ran = runs.iter().filter(|(_, run)| run.is_ok());
        let reference = finest(ran.map(|(scalar, _)| *scalar))?;
        let found = runs.iter().find(|(scalar, _)| *scalar == reference);
        let first = found.and_then(|(_, run)| run.as_ref().ok())?;
        let (first, time) = (first.last.clone(), first.ran.time);
        let matching = Matching::of(scenario);
        let size = matching.size(&first, field);
        let mut warnings = Vec::new();
        let row = |(scalar, run): (ScalarName, Result<Finished, Refusal>)| {
            let outcome = match run {
                Ok(Finished { mut ran, last }) => {
                    match matching.obstacle(&first, &last) {
                        _ if scalar == reference => {}
                        Some(obstacle) => ran.warnings.push(format!("no differences: {obstacle}")),
                        None => ran.difference = Some(matching.differences(&first, &last)),
                    }
                    FormatOutcome::Ran(Box::new(ran))
                }
                Err(refusal) => FormatOutcome::Refused(refusal),
            };
            FormatRow::new(scalar, outcome)
        };
        let rows: Vec<FormatRow> = runs.into_iter().map(row).collect();
        shared_once(&rows, &mut warnings);
        let floor = rows
            .iter()
            .find(|row| row.scalar == reference.name())
            .and_then(|row| row.relative_error(field, size));
        let losses: Vec<Loss> = rows.iter().filter_map(|row| row.loss(field)).collect();
        let rounding = Rounding::new(&losses, reference.fraction_bits(), floor);
        Some(Self {
            scenario: scenario.name().to_owned(),
            dimension: scenario.dimension(),
            particles: first.particles(),
            time,
            field: field.to_owned(),
            reference: reference.name().to_owned(),
            size,
            rows,
            rounding,
            warnings,
        })
    }
}

/// The warnings of all runs: what each of them says once, the rest with its format.
fn shared_once(rows: &[FormatRow], warnings: &mut Vec<String>) {
    let ran: Vec<(&str, &Ran)> = rows
        .iter()
        .filter_map(|row| Some((row.scalar.as_str(), row.ran()?)))
        .collect();
    for (scalar, run) in &ran {
        for warning in &run.warnings {
            let text = match ran.iter().all(|(_, run)| run.warnings.contains(warning)) {
                true => warning.clone(),
                false => format!("{scalar}: {warning}"),
            };
            if !warnings.contains(&text) {
                warnings.push(text);
            }
        }
    }
}
