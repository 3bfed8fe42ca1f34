//! Snapshots of a run, as often as its scenario says.

use std::path::Path;

use crate::io::{Cloud, SnapshotFormat, SnapshotSeries, WriteError};
use crate::linear;
use crate::scenario::{self, Interval, Snapshots};
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
    /// A writer into a folder, of a run of that name until `end`; one that writes nothing where
    /// no snapshots are asked for.
    ///
    /// # Errors
    /// A folder that cannot be written to.
    pub fn new(
        snapshots: Option<Snapshots>,
        (name, end): (&str, f64),
        folder: &Path,
    ) -> Result<Self, WriteError> {
        let Some(Snapshots { interval, format }) = snapshots else {
            return Ok(Self(None));
        };
        let format = match format {
            scenario::SnapshotFormat::Vtu => SnapshotFormat::Vtu,
            scenario::SnapshotFormat::Csv => SnapshotFormat::Csv,
        };
        Ok(Self(Some(Writer {
            series: SnapshotSeries::new(folder, name, format)?,
            interval,
            end,
            passed: -1.0,
        })))
    }

    /// Writes a snapshot of a gas if one is due: at the start, after every interval, and at the
    /// end.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn look(&mut self, look: &Look<'_>) -> Result<(), String> {
        let Some(writer) = self.due(look.time, look.steps) else {
            return Ok(());
        };
        let rows = (look.particles)();
        told(add_gas(&mut writer.series, &rows, look))
    }

    /// The same of a linear system whose components have these names.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn look_linear(&mut self, look: &linear::Look<'_>, names: &[String]) -> Result<(), String> {
        let Some(writer) = self.due(look.time, look.steps) else {
            return Ok(());
        };
        let cloud = (look.cloud)();
        told(add_linear(&mut writer.series, &cloud, names, look))
    }

    /// The writer, if a snapshot is due.
    fn due(&mut self, time: f64, steps: u64) -> Option<&mut Writer> {
        let writer = self.0.as_mut()?;
        // A time that is a rounding short of a multiple has reached it.
        let passed = match writer.interval {
            Interval::Time(every) => (time / every + 1e-9).floor(),
            Interval::Steps(every) => (steps / every as u64) as f64,
        };
        let over = time >= writer.end * (1.0 - 1e-9);
        if passed <= writer.passed && !over {
            return None;
        }
        writer.passed = passed;
        Some(writer)
    }
}

/// The error as text, with its cure.
fn told(result: Result<(), WriteError>) -> Result<(), String> {
    result.map_err(|error| {
        let report = miette::Report::new(error);
        format!("{report:?}")
    })
}

/// Adds all fields of the particles of a gas.
fn add_gas(
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

/// Adds weights and components of the particles of a linear system.
fn add_linear(
    series: &mut SnapshotSeries,
    cloud: &linear::Cloud,
    names: &[String],
    look: &linear::Look<'_>,
) -> Result<(), WriteError> {
    let mut scalars = vec![("weight", cloud.weights.clone())];
    for (component, name) in names.iter().enumerate() {
        scalars.push((name, cloud.component(component)));
    }
    let cloud = Cloud {
        positions: &cloud.positions,
        scalars: &scalars,
        vectors: &[],
        integers: &[
            ("id", (0..cloud.len() as u32).collect()),
            (
                "neighbours",
                cloud.neighbours.iter().map(|&n| n as u32).collect(),
            ),
        ],
        time: look.time,
    };
    series.add(&cloud, look.steps)
}
