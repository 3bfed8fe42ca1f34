//! Snapshots of a run, as often as its scenario says.

use motes_core::cloud::Words;
use motes_core::error::Error;

use crate::io::{Cloud, RunFolder, SnapshotFormat, SnapshotSeries, WriteError};
use crate::run::{Kind, Simulation};
use crate::scenario::{self, AnyScenario, Interval, Snapshots};

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
    /// A writer into the folder of a run of a scenario; one that writes nothing where it asks for
    /// no snapshots.
    pub fn new(scenario: &AnyScenario, folder: &RunFolder) -> Self {
        let Some(Snapshots { interval, format }) = scenario.snapshots() else {
            return Self(None);
        };
        let format = match format {
            scenario::SnapshotFormat::Vtu => SnapshotFormat::Vtu,
            scenario::SnapshotFormat::Csv => SnapshotFormat::Csv,
        };
        Self(Some(Writer {
            series: SnapshotSeries::new(folder.path(), scenario.name(), format),
            interval,
            end: scenario.end(),
            passed: -1.0,
        }))
    }

    /// Writes a snapshot if one is due: at the start, after every interval, and at the end.
    ///
    /// # Errors
    /// A file that cannot be written, as text with its cure.
    pub fn look(
        &mut self,
        simulation: &dyn Simulation,
        folder: &mut RunFolder,
    ) -> Result<(), String> {
        let Some(writer) = self.due(simulation.time(), simulation.steps()) else {
            return Ok(());
        };
        let names = writer.series.names(simulation.steps());
        let noted = names
            .iter()
            .try_for_each(|name| folder.place(name).map(drop));
        let added = noted.and_then(|()| add(&mut writer.series, simulation));
        added.map_err(|error| {
            let report = miette::Report::new(error);
            format!("{report:?}")
        })
    }

    /// Passes which snapshots have been written.
    ///
    /// # Errors
    /// Those of [`Words`].
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        let Some(writer) = &mut self.0 else {
            return Ok(());
        };
        words.scalar(&mut writer.passed)?;
        writer.series.pass(words)
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

/// Adds the fields that a simulation has for snapshots, and ids.
fn add(series: &mut SnapshotSeries, simulation: &dyn Simulation) -> Result<(), WriteError> {
    let description = simulation.description();
    let of = |kind: Kind| {
        let fields = description
            .snapshot
            .iter()
            .map(|&place| &description.fields[place]);
        fields
            .filter(move |field| field.kind == kind)
            .collect::<Vec<_>>()
    };
    let [scalar, vector, integer] = [Kind::Scalar, Kind::Vector, Kind::Integer].map(of);
    let mut positions = Vec::new();
    let mut scalars: Vec<_> = scalar.iter().map(|field| (&*field.name, vec![])).collect();
    let mut vectors: Vec<_> = vector.iter().map(|field| (&*field.name, vec![])).collect();
    let mut integers = vec![("id", vec![])];
    integers.extend(integer.iter().map(|field| (&*field.name, vec![])));
    simulation.each(|row| {
        integers[0].1.push(positions.len() as u32);
        positions.push(row.position);
        for (field, (_, values)) in scalar.iter().zip(&mut scalars) {
            values.push(row.values[field.first]);
        }
        for (field, (_, values)) in vector.iter().zip(&mut vectors) {
            let vector = &row.values[field.places()];
            values.push(std::array::from_fn(|i| {
                vector.get(i).copied().unwrap_or(0.0)
            }));
        }
        for (field, (_, values)) in integer.iter().zip(&mut integers[1..]) {
            values.push(row.values[field.first] as u32);
        }
    });
    let cloud = Cloud {
        positions: &positions,
        scalars: &scalars,
        vectors: &vectors,
        integers: &integers,
        time: simulation.time(),
    };
    series.add(&cloud, simulation.steps())
}
