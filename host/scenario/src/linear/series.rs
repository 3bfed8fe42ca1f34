//! Numbers that change in time, out of a CSV file: a heading, then a row a time.

use crate::entry::Entry;
use crate::error::Fault;
use crate::files::Files;
use crate::problem::Problem;
use crate::section::Section;
use crate::table;

/// A number at some times, linear between them; where it is held, constant before the first and after
/// the last.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// The file as the scenario names it.
    pub file: String,
    /// What it holds.
    pub text: String,
    /// Ascending, at least one.
    pub times: Vec<f64>,
    /// One a time.
    pub values: Vec<f64>,
    /// Whether it may be shorter than the run.
    pub is_held: bool,
}

/// The column of the times.
const TIME: &str = "time";

/// `series` of a section: a column of a file, and its column `time`; it covers a run from 0 to `end`
/// unless it is held.
pub(super) fn series(
    section: &Section<'_>,
    files: Files<'_>,
    end: Option<f64>,
) -> Result<Series, Fault> {
    let column = section.required("column")?.text()?;
    let entry = section.required("file")?;
    let file = files.text(&entry)?;
    let read = table::parse(&file.text, "time", |table| read(table, column));
    let (times, values) = read.map_err(|fault| {
        let problem = Problem::Table {
            message: fault.message,
            cure: fault.help,
        };
        Fault::of_file(
            problem,
            fault.span,
            file.name,
            file.text.clone().into_owned(),
        )
    })?;
    let held = section.optional("beyond");
    let is_held = held.map_or(Ok(false), |entry| entry.choice(&[("hold", true)]))?;
    if !is_held && let Some(end) = end {
        covers(&entry, &times, end)?;
    }
    Ok(Series {
        file: entry.text()?.to_owned(),
        text: file.text.into_owned(),
        times,
        values,
        is_held,
    })
}

/// What a rounding of a time may be, as a part of the run.
const ROUNDING: f64 = 1e-9;

/// That some times reach from the start of a run to its end.
fn covers(file: &Entry<'_>, times: &[f64], end: f64) -> Result<(), Fault> {
    let (Some(&first), Some(&last)) = (times.first(), times.last()) else {
        return Ok(());
    };
    if first <= ROUNDING * end && last >= end * (1.0 - ROUNDING) {
        return Ok(());
    }
    let times = match times.len() {
        1 => format!("the only time in it is {first}"),
        _ => format!("its times go from {first} to {last}"),
    };
    let reason = format!("{times}, the run from 0 to {end}");
    let cure = "give rows for the whole run, in its unit of time and from its start (0 is the start, \
                time.end the end), or set beyond = \"hold\" in `series`: the first number before the \
                first time, and the last after the last";
    Err(file.does_not_fit(reason, cure))
}

/// Times and values.
fn read(table: &table::Table<'_>, name: &str) -> Result<(Vec<f64>, Vec<f64>), table::TableFault> {
    let need = format!("need `time` and the column that the scenario names, `{name}`");
    let time = table.required(TIME, &need)?;
    let value = table.required(name, &need)?;
    let (mut times, mut values) = (Vec::new(), Vec::new());
    table.rows(|row| {
        let now = row.number(&time)?;
        if let Some(last) = times.last().filter(|last| now <= **last) {
            let need = format!("need a time after that of the row before, {last}");
            return Err(row.fault(&time, &need));
        }
        times.push(now);
        values.push(row.number(&value)?);
        Ok(())
    })?;
    Ok((times, values))
}
