//! What is written and measured, whatever is simulated.

use crate::Extent;
use crate::bound::POSITIVE;
use crate::error::Fault;
use crate::geometry;
use crate::section::Section;

/// States written on the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Snapshots {
    /// How often.
    pub interval: Interval,
    /// As what.
    pub format: SnapshotFormat,
}

/// How often something happens.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Interval {
    /// After so much time, > 0.
    Time(f64),
    /// After so many steps, at least 1.
    Steps(usize),
}

/// The format of a snapshot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SnapshotFormat {
    /// VTK's XML for unstructured grids: ParaView reads it.
    Vtu,
    /// A table.
    Csv,
}

const FORMATS: &[(&str, SnapshotFormat)] =
    &[("vtu", SnapshotFormat::Vtu), ("csv", SnapshotFormat::Csv)];

/// Rows of the time series where none are given.
pub(super) const DEFAULT_SAMPLES: usize = 100;

/// Where errors are measured: the domain unless told.
pub(super) fn window(section: &Section<'_>, domain: &Extent) -> Result<Extent, Fault> {
    match section.optional("window") {
        Some(window) => geometry::extent_inside(&window.section()?, domain),
        None => Ok(domain.clone()),
    }
}

/// Whether steps are shortened so that rows of the time series and snapshots have their own times.
pub(super) fn exact_times(section: &Section<'_>) -> Result<bool, Fault> {
    let entry = section.optional("exact-times");
    entry.map_or(Ok(false), |entry| entry.truth())
}

/// Rows of the time series.
pub(super) fn samples(section: &Section<'_>) -> Result<usize, Fault> {
    let cure = "give the number of rows of the time series, for example 100";
    let samples = section.optional("samples");
    samples.map_or(Ok(DEFAULT_SAMPLES), |samples| {
        samples.count(u32::MAX, "1 to 4294967295", cure)
    })
}

/// States on the way, if any are written.
pub(super) fn snapshots(section: &Section<'_>) -> Result<Option<Snapshots>, Fault> {
    let Some(entry) = section.optional("snapshots") else {
        return Ok(None);
    };
    let section = entry.section()?;
    let interval = match (section.optional("every"), section.optional("steps")) {
        (Some(every), None) => Interval::Time(every.number(POSITIVE)?),
        (None, Some(steps)) => Interval::Steps(steps.count(
            u32::MAX,
            "1 to 4294967295",
            "give the number of steps from one snapshot to the next",
        )?),
        (Some(_), Some(steps)) => {
            let reason = "output.snapshots.every is there too".to_owned();
            return Err(steps.does_not_fit(reason, "keep one: every (a time) or steps"));
        }
        (None, None) => return Err(section.missing("every")),
    };
    let format = section.optional("format");
    let format = format.map_or(Ok(SnapshotFormat::Vtu), |entry| entry.choice(FORMATS))?;
    Ok(Some(Snapshots { interval, format }))
}
