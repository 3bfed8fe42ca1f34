//! Numbers that change in time, out of a CSV file: a heading, then a row a time.

use crate::scenario::error::Fault;
use crate::scenario::files::Files;
use crate::scenario::problem::Problem;
use crate::scenario::section::Section;
use crate::setup::table;

/// A number at some times, linear between them, constant before the first and after the last.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Ascending, at least one.
    pub times: Vec<f64>,
    /// One a time.
    pub values: Vec<f64>,
}

/// The column of the times.
const TIME: &str = "time";

impl Series {
    /// The number at a time.
    pub fn at(&self, time: f64) -> f64 {
        let later = self.times.partition_point(|&known| known <= time);
        let point = |i: usize| Some((*self.times.get(i)?, *self.values.get(i)?));
        match (later.checked_sub(1).and_then(point), point(later)) {
            (Some((start, from)), Some((end, to))) => {
                from + (to - from) * ((time - start) / (end - start))
            }
            (Some((_, value)), None) | (None, Some((_, value))) => value,
            (None, None) => 0.0,
        }
    }
}

/// `series` of a section: a column of a file, and its column `time`.
pub(super) fn series(section: &Section<'_>, files: Files<'_>) -> Result<Series, Fault> {
    let column = section.required("column")?.text()?;
    let file = files.text(&section.required("file")?)?;
    table::parse(&file.text, "time", |table| read(table, column)).map_err(|fault| {
        let problem = Problem::Table {
            message: fault.message,
            cure: fault.help,
        };
        Fault::of_file(problem, fault.span, file.name, file.text.into_owned())
    })
}

fn read(table: &table::Table<'_>, name: &str) -> Result<Series, table::Fault> {
    let need = format!("need `time` and the column that the scenario names, `{name}`");
    let time = table.required(TIME, &need)?;
    let value = table.required(name, &need)?;
    let mut series = Series {
        times: Vec::new(),
        values: Vec::new(),
    };
    table.rows(|row| {
        let now = row.number(&time)?;
        if let Some(last) = series.times.last().filter(|last| now <= **last) {
            let need = format!("need a time after that of the row before, {last}");
            return Err(row.fault(&time, &need));
        }
        series.times.push(now);
        series.values.push(row.number(&value)?);
        Ok(())
    })?;
    Ok(series)
}
