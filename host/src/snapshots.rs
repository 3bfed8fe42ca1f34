//! Snapshots of a run, as often as its scenario says.

use std::path::Path;

use crate::io::{Cloud, SnapshotFormat, SnapshotSeries, WriteError};
use crate::scenario::{self, Interval, Scenario, Snapshots};
use crate::simulation::{Look, ParticleRow};

/// Writes snapshots where a scenario asks for them.
pub struct SnapshotWriter(Option<Writer>);

struct Writer {
    series: SnapshotSeries,
    interval: Interval,
    end: f64,
    /// Intervals that have passed.
    passed: f64,
}

impl SnapshotWriter {
    /// A writer into a folder; one that writes nothing where the scenario asks for none.
    ///
    /// # Errors
    /// A folder that cannot be written to.
    pub fn new(scenario: &Scenario, folder: &Path) -> Result<Self, WriteError> {
        let Some(Snapshots { interval, format }) = scenario.output.snapshots else {
            return Ok(Self(None));
        };
        let format = match format {
            scenario::SnapshotFormat::Vtu => SnapshotFormat::Vtu,
            scenario::SnapshotFormat::Csv => SnapshotFormat::Csv,
        };
        Ok(Self(Some(Writer {
            series: SnapshotSeries::new(folder, &scenario.name, format)?,
            interval,
            end: scenario.time.end,
            passed: -1.0,
        })))
    }

    /// Writes a snapshot if one is due: at the start, after every interval, and at the end.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn look(&mut self, look: &Look<'_>) -> Result<(), String> {
        let Some(writer) = &mut self.0 else {
            return Ok(());
        };
        // A time that is a rounding short of a multiple has reached it.
        let passed = match writer.interval {
            Interval::Time(every) => (look.time / every + 1e-9).floor(),
            Interval::Steps(every) => (look.steps / every as u64) as f64,
        };
        let over = look.time >= writer.end * (1.0 - 1e-9);
        if passed <= writer.passed && !over {
            return Ok(());
        }
        writer.passed = passed;
        let rows = (look.particles)();
        add(&mut writer.series, &rows, look).map_err(|error| {
            let report = miette::Report::new(error);
            format!("{report:?}")
        })
    }
}

/// Adds all fields of the particles.
fn add(
    series: &mut SnapshotSeries,
    rows: &[ParticleRow],
    look: &Look<'_>,
) -> Result<(), WriteError> {
    let of = |field: fn(&ParticleRow) -> f64| rows.iter().map(field).collect::<Vec<f64>>();
    let positions: Vec<[f64; 3]> = rows.iter().map(|row| row.position).collect();
    let velocities: Vec<[f64; 3]> = rows.iter().map(|row| row.velocity).collect();
    let cloud = Cloud {
        positions: &positions,
        scalars: &[
            ("mass", of(|p| p.mass)),
            ("density", of(|p| p.density)),
            ("pressure", of(|p| p.pressure)),
            ("energy", of(|p| p.energy)),
            ("sound_speed", of(|p| p.sound_speed)),
            ("divergence", of(|p| p.divergence)),
            ("viscosity_factor", of(|p| p.viscosity_factor)),
            ("epsilon", of(|p| p.epsilon)),
        ],
        vectors: &[("velocity", velocities)],
        integers: &[
            ("id", (0..rows.len() as u32).collect()),
            (
                "neighbours",
                rows.iter().map(|p| p.neighbours as u32).collect(),
            ),
            (
                "material",
                rows.iter().map(|p| u32::from(p.material)).collect(),
            ),
        ],
        time: look.time,
    };
    series.add(&cloud, look.steps)
}
