//! The snapshots of a run: a file for each, and one that lists them with their times.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use motes_core::cloud::Words;
use motes_core::error::Error;

use super::table::{WriteError, components, table, whole, write_text};
use super::vtu::{Cloud, escaped, write_vtu};

/// How snapshots are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SnapshotFormat {
    /// VTK unstructured grids, listed in `NAME.pvd`: for ParaView.
    #[default]
    Vtu,
    /// Tables, listed in `snapshots.csv`: for everything else.
    Csv,
}

/// One snapshot of a series.
#[derive(Clone, Debug, PartialEq)]
pub struct SnapshotEntry {
    /// The file, relative to the folder of the series.
    pub file: String,
    /// Its time.
    pub time: f64,
    /// Steps made until then.
    pub step: u64,
}

/// Snapshots `snapshots/NAME_000123.vtu` and the list of them, `NAME.pvd`.
///
/// The list is written whole after every snapshot: a run that is cut off leaves a valid series.
/// Snapshots of an earlier run in the same folder are not listed; [`super::RunFolder`] removes them.
#[derive(Clone, Debug)]
pub struct SnapshotSeries {
    folder: PathBuf,
    name: String,
    format: SnapshotFormat,
    entries: Vec<SnapshotEntry>,
}

impl SnapshotSeries {
    /// An empty series; nothing is made in the folder yet.
    pub fn new(folder: &Path, name: &str, format: SnapshotFormat) -> Self {
        Self {
            folder: folder.to_owned(),
            name: name.to_owned(),
            format,
            entries: Vec::new(),
        }
    }

    /// The files that a snapshot of a step is written to, relative to the folder: its own, and the
    /// list.
    pub fn names(&self, step: u64) -> [String; 2] {
        let extension = match self.format {
            SnapshotFormat::Vtu => "vtu",
            SnapshotFormat::Csv => "csv",
        };
        // `/` on every system: what stands in the list is no path of this machine.
        let file = format!("{SNAPSHOTS}/{}_{step:06}.{extension}", self.name);
        let list = match self.format {
            SnapshotFormat::Vtu => format!("{}.pvd", self.name),
            SnapshotFormat::Csv => "snapshots.csv".to_owned(),
        };
        [file, list]
    }

    /// Writes a snapshot, then the list. A second snapshot of the same step replaces the first.
    ///
    /// # Errors
    /// Those of [`write_vtu`]. The list then names what was written before.
    pub fn add(&mut self, cloud: &Cloud<'_>, step: u64) -> Result<(), WriteError> {
        let [file, _] = self.names(step);
        let path = self.folder.join(&file);
        let folder = self.folder.join(SNAPSHOTS);
        std::fs::create_dir_all(&folder).map_err(|error| WriteError::new(&folder, error))?;
        match self.format {
            SnapshotFormat::Vtu => write_vtu(&path, cloud)?,
            SnapshotFormat::Csv => write_cloud(&path, cloud)?,
        }
        let entry = SnapshotEntry {
            file,
            time: cloud.time,
            step,
        };
        match self.entries.last_mut() {
            Some(last) if last.step == step => *last = entry,
            _ => self.entries.push(entry),
        }
        self.write_list()
    }

    /// Passes which snapshots have been written.
    ///
    /// # Errors
    /// Those of [`Words`].
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        let mut count = self.entries.len() as u64;
        words.count(&mut count)?;
        for place in 0..count as usize {
            let entry = self.entries.get(place);
            let (mut step, mut time) = entry.map_or((0, 0.0), |entry| (entry.step, entry.time));
            words.count(&mut step)?;
            words.scalar(&mut time)?;
            if words.fills() {
                self.entries.truncate(place);
                let [file, _] = self.names(step);
                self.entries.push(SnapshotEntry { file, time, step });
            }
        }
        Ok(())
    }

    /// The snapshots written, oldest first.
    pub fn entries(&self) -> &[SnapshotEntry] {
        &self.entries
    }

    /// The file that lists the snapshots.
    pub fn list(&self) -> PathBuf {
        let [_, list] = self.names(0);
        self.folder.join(list)
    }

    fn write_list(&self) -> Result<(), WriteError> {
        match self.format {
            SnapshotFormat::Vtu => write_text(&self.list(), &collection(&self.entries)),
            SnapshotFormat::Csv => whole(&self.list(), |file| {
                let mut writer = csv::Writer::from_writer(file);
                writer.write_record(["file", "time", "step"])?;
                for SnapshotEntry { file, time, step } in &self.entries {
                    writer.write_record([file, &time.to_string(), &step.to_string()])?;
                }
                writer.flush()
            }),
        }
    }
}

/// Where the snapshots lie.
pub const SNAPSHOTS: &str = "snapshots";

/// ParaView's collection of files with times.
fn collection(entries: &[SnapshotEntry]) -> String {
    let mut text = "<?xml version=\"1.0\"?>\n\
                    <VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  \
                    <Collection>\n"
        .to_owned();
    for SnapshotEntry { file, time, .. } in entries {
        let file = escaped(file);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "    <DataSet timestep=\"{time}\" group=\"\" part=\"0\" file=\"{file}\"/>"
        );
    }
    text + "  </Collection>\n</VTKFile>\n"
}

/// Particles as a table: position, scalars, vectors by component, integers.
fn write_cloud(path: &Path, cloud: &Cloud<'_>) -> Result<(), WriteError> {
    cloud
        .check()
        .map_err(|error| WriteError::new(path, error))?;
    let components = |name: &str| components(name, 3);
    let mut heading = components("position");
    heading.extend(cloud.scalars.iter().map(|(name, _)| (*name).to_owned()));
    heading.extend(cloud.vectors.iter().flat_map(|(name, _)| components(name)));
    heading.extend(cloud.integers.iter().map(|(name, _)| (*name).to_owned()));
    table(path, &heading, |rows| {
        for (k, position) in cloud.positions.iter().enumerate() {
            let mut row = position.to_vec();
            row.extend(cloud.scalars.iter().map(|(_, values)| values[k]));
            row.extend(cloud.vectors.iter().flat_map(|(_, values)| values[k]));
            let integers = cloud.integers.iter();
            row.extend(integers.map(|(_, values)| f64::from(values[k])));
            rows.write(&row)?;
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const POSITIONS: [[f64; 3]; 2] = [[0.1, -0.2, 0.0], [1.0 / 3.0, 2.0, 0.0]];

    /// Adds snapshots at the times given; the step is the time in thousandths.
    fn add(series: &mut SnapshotSeries, times: &[f64]) {
        let scalars = [("density", vec![1.0, 1e-3])];
        let vectors = [("velocity", vec![[0.1, 0.2, 0.3], [5e-324, 0.0, -1.0]])];
        let integers = [("id", vec![0, u32::MAX])];
        for &time in times {
            let cloud = Cloud {
                positions: &POSITIONS,
                scalars: &scalars,
                vectors: &vectors,
                integers: &integers,
                time,
            };
            series.add(&cloud, (1000.0 * time) as u64).unwrap();
        }
    }

    /// The values of an attribute, in the order of the file.
    fn attribute<'a>(text: &'a str, name: &str) -> Vec<&'a str> {
        let start = format!(" {name}=\"");
        let values = text.split(start.as_str()).skip(1);
        values.map(|rest| rest.split('"').next().unwrap()).collect()
    }

    #[test]
    fn after_each_snapshot_the_list_names_files_that_exist_and_their_times() {
        let folder = tempfile::tempdir().unwrap();
        let mut series = SnapshotSeries::new(folder.path(), "a < b & c", SnapshotFormat::Vtu);
        let times = [0.0, 0.1, 0.30000000000000004];
        for count in 1..=times.len() {
            add(&mut series, &times[count - 1..count]);
            let text = std::fs::read_to_string(folder.path().join("a < b & c.pvd")).unwrap();
            assert!(text.trim_end().ends_with("</VTKFile>"));
            let read = attribute(&text, "timestep");
            let read: Vec<f64> = read.iter().map(|time| time.parse().unwrap()).collect();
            assert_eq!(read, times[..count]);
            let files = attribute(&text, "file");
            assert_eq!(files.len(), count);
            for (file, entry) in files.iter().zip(series.entries()) {
                assert_eq!(*file, escaped(&entry.file));
                assert!(folder.path().join(&entry.file).is_file());
            }
        }
        assert_eq!(series.entries()[1].file, "snapshots/a < b & c_000100.vtu");
    }

    #[test]
    fn a_snapshot_that_fails_leaves_the_list_as_it_was() {
        let folder = tempfile::tempdir().unwrap();
        for format in [SnapshotFormat::Vtu, SnapshotFormat::Csv] {
            let mut series = SnapshotSeries::new(folder.path(), "run", format);
            add(&mut series, &[0.0]);
            let before = std::fs::read_to_string(series.list()).unwrap();
            let broken = Cloud {
                positions: &POSITIONS,
                scalars: &[("density", vec![])],
                vectors: &[],
                integers: &[],
                time: 1.0,
            };
            series.add(&broken, 1).unwrap_err();
            assert_eq!(std::fs::read_to_string(series.list()).unwrap(), before);
            assert_eq!(series.entries().len(), 1);
        }
    }

    #[test]
    fn a_step_written_twice_is_listed_once() {
        let folder = tempfile::tempdir().unwrap();
        let mut series = SnapshotSeries::new(folder.path(), "run", SnapshotFormat::Vtu);
        add(&mut series, &[0.0, 0.5, 0.5]);
        let text = std::fs::read_to_string(series.list()).unwrap();
        assert_eq!(attribute(&text, "timestep"), ["0", "0.5"]);
    }

    #[test]
    fn a_table_holds_every_column_and_the_same_bits() {
        let folder = tempfile::tempdir().unwrap();
        let mut series = SnapshotSeries::new(folder.path(), "run", SnapshotFormat::Csv);
        add(&mut series, &[0.0, 0.125]);
        let list = std::fs::read_to_string(folder.path().join("snapshots.csv")).unwrap();
        assert_eq!(
            list,
            "file,time,step\nsnapshots/run_000000.csv,0,0\nsnapshots/run_000125.csv,0.125,125\n"
        );
        let mut reader =
            csv::Reader::from_path(folder.path().join("snapshots/run_000125.csv")).unwrap();
        let heading: Vec<String> = reader.headers().unwrap().iter().map(String::from).collect();
        let expected =
            "position_x position_y position_z density velocity_x velocity_y velocity_z id";
        assert_eq!(heading.join(" "), expected);
        let rows: Vec<Vec<f64>> = reader.deserialize().map(Result::unwrap).collect();
        assert_eq!(
            rows,
            [
                [0.1, -0.2, 0.0, 1.0, 0.1, 0.2, 0.3, 0.0],
                [1.0 / 3.0, 2.0, 0.0, 1e-3, 5e-324, 0.0, -1.0, 4294967295.0],
            ]
        );
    }
}
