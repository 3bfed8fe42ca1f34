//! Numbers that change in time, out of a CSV file: a heading, then a row a time.

use crate::error::Fault;
use crate::files::Files;
use crate::problem::Problem;
use crate::section::Section;
use crate::table;

/// A number at some times, linear between them, constant before the first and after the last.
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
}

/// The column of the times.
const TIME: &str = "time";

/// `series` of a section: a column of a file, and its column `time`.
pub(super) fn series(section: &Section<'_>, files: Files<'_>) -> Result<Series, Fault> {
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
    Ok(Series {
        file: entry.text()?.to_owned(),
        text: file.text.into_owned(),
        times,
        values,
    })
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
