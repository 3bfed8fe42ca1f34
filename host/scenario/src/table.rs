//! A CSV file of particles or times as rows of numbers, with faults that name line, field and cure.

use std::fmt;
use std::ops::Range;
use std::path::Path;

use miette::{Diagnostic, LabeledSpan, SourceCode};

use crate::read::{self, MOST_OF_TABLE};
use crate::snippet::{Snippet, shortened, shortened_sentence};

/// The most rows of a file: as many particles as ids can count.
pub const MOST_ROWS: usize = 1 << 29;

/// Why a file is no cloud of particles, and where.
///
/// As a `miette::Report` it prints `file:line:column`, the line itself and the cure.
#[derive(Debug)]
pub struct CloudError {
    message: String,
    help: String,
    place: Option<Snippet>,
}

impl fmt::Display for CloudError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for CloudError {}

impl Diagnostic for CloudError {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(&self.help))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        let place = self.place.as_ref()?;
        Some(place)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let place = self.place.as_ref()?;
        Some(Box::new(std::iter::once(place.label())))
    }
}

/// Reads a file with a row a particle and parses it.
///
/// # Errors
/// A file that cannot be read or is not UTF-8, and what `parsed` finds.
pub fn read<T>(
    path: &Path,
    parsed: impl FnOnce(&Table<'_>) -> Result<T, TableFault>,
) -> Result<T, Box<CloudError>> {
    let name = path.display().to_string();
    let nowhere = |message: String, help: &str| {
        Box::new(CloudError {
            message,
            help: help.to_owned(),
            place: None,
        })
    };
    let help = "check resolution.file: it is looked for in the folder of the scenario";
    let bytes = read::bytes(path, MOST_OF_TABLE).map_err(|unread| {
        nowhere(
            unread.message(&shortened(&name)),
            unread.cure().unwrap_or(help),
        )
    })?;
    let text = String::from_utf8(bytes).map_err(|_| {
        nowhere(
            format!("`{name}` is not UTF-8 text"),
            "give a CSV file with a heading and a row a particle",
        )
    })?;
    parse(&text, "particle", parsed).map_err(|fault| {
        Box::new(CloudError {
            message: fault.message,
            help: fault.help,
            place: Some(Snippet::new(name.clone(), text.clone(), fault.span)),
        })
    })
}

/// Parses the text of a file with a row for `each` of something.
///
/// # Errors
/// A heading that is no record, and what `parsed` finds.
pub fn parse<T>(
    text: &str,
    each: &'static str,
    parsed: impl FnOnce(&Table<'_>) -> Result<T, TableFault>,
) -> Result<T, TableFault> {
    Table::of(text, each).and_then(|table| parsed(&table))
}

/// Something wrong at some bytes of the text.
pub struct TableFault {
    /// What is wrong: column, value and line.
    pub message: String,
    /// The cure.
    pub help: String,
    /// Bytes of the text.
    pub span: Range<usize>,
}

impl TableFault {
    /// A fault at some bytes of the text.
    pub fn new(message: String, help: impl Into<String>, span: Range<usize>) -> Self {
        let help = help.into();
        Self {
            message,
            help,
            span,
        }
    }
}

/// The text of a file, and its heading.
pub struct Table<'a> {
    text: &'a str,
    each: &'static str,
    heading: csv::StringRecord,
}

impl<'a> Table<'a> {
    fn of(text: &'a str, each: &'static str) -> Result<Self, TableFault> {
        let heading = reader(text).headers().cloned();
        let heading = heading.map_err(|error| {
            let line = 0..text.find('\n').unwrap_or(text.len());
            TableFault::new(error.to_string(), "give a heading", line)
        })?;
        Ok(Self {
            text,
            each,
            heading,
        })
    }

    /// Where the heading stands.
    pub fn first_line(&self) -> Range<usize> {
        0..self.text.find('\n').unwrap_or(self.text.len())
    }

    /// A fault of the heading; the help is completed with the columns that there are.
    pub fn fault(&self, message: String, need: &str) -> TableFault {
        let columns = self.heading.iter().collect::<Vec<_>>().join(", ");
        let columns = shortened_sentence(&columns);
        let separators = [(';', "`;`"), ('\t', "tabs")];
        let found = separators.iter().find(|(separator, _)| {
            let headings = &self.text[self.first_line()];
            self.heading.len() == 1 && headings.contains(*separator)
        });
        let help = match found {
            Some((_, name)) => {
                format!("the columns are separated by {name}: separate them by commas; {need}")
            }
            None => format!("{need}; the columns are: {columns}"),
        };
        TableFault::new(message, help, self.first_line())
    }

    /// A fault of a whole row.
    pub fn fault_at(&self, line: Line, message: String, help: impl Into<String>) -> TableFault {
        TableFault::new(message, help, line_at(self.text, line.byte as usize))
    }

    /// A column, if it is there.
    ///
    /// # Errors
    /// It is there twice.
    pub fn optional(&self, name: &str) -> Result<Option<Column>, TableFault> {
        let mut places = (0..).zip(self.heading.iter());
        let mut next = || places.find(|(_, column)| *column == name);
        let Some((index, _)) = next() else {
            return Ok(None);
        };
        if let Some((second, _)) = next() {
            let twice = [index, second].map(|place| (place, name));
            return Err(self.ambiguous(&twice));
        }
        let name = name.to_owned();
        Ok(Some(Column { name, index }))
    }

    /// That no other heading reads as one of these names but for its letters' case.
    ///
    /// # Errors
    /// The first that does.
    pub fn spelled(&self, names: &[&str]) -> Result<(), TableFault> {
        for (place, heading) in (1..).zip(self.heading.iter()) {
            let alike = |name: &&&str| name.eq_ignore_ascii_case(heading);
            let Some(name) = names
                .iter()
                .find(alike)
                .filter(|_| !names.contains(&heading))
            else {
                continue;
            };
            let message =
                format!("column {place} is called `{heading}`, which is not read as `{name}`");
            let help = format!("write `{name}`, or take the column out: case counts in headings");
            return Err(TableFault::new(message, help, self.first_line()));
        }
        Ok(())
    }

    /// The fault of two columns, by their places from 0, that say the same thing.
    fn ambiguous(&self, columns: &[(usize, &str); 2]) -> TableFault {
        let [(first, a), (second, b)] = columns;
        let (first, second) = (first + 1, second + 1);
        let message = match a == b {
            true => format!("the heading has `{a}` twice, as columns {first} and {second}"),
            false => {
                format!("columns {first} and {second}, `{a}` and `{b}`, are the same quantity")
            }
        };
        TableFault::new(
            message,
            "keep one of the two columns, or give the other another name",
            self.first_line(),
        )
    }

    /// A column; `need` says which ones a file has.
    ///
    /// # Errors
    /// There is no such column.
    pub fn required(&self, name: &str, need: &str) -> Result<Column, TableFault> {
        let missing = || self.fault(format!("there is no column `{}`", shortened(name)), need);
        self.optional(name)?.ok_or_else(missing)
    }

    /// The columns of a vector: `name_x` and so on; in one dimension `name` will do.
    ///
    /// # Errors
    /// One of them is not there, or there twice.
    pub fn vector(
        &self,
        name: &str,
        dimension: usize,
        need: &str,
    ) -> Result<Vec<Column>, TableFault> {
        if dimension == 1
            && let Some(column) = self.optional(name)?
        {
            let along = format!("{name}_x");
            return match self.optional(&along)? {
                Some(other) => Err(self.ambiguous(&[(column.index, name), (other.index, &along)])),
                None => Ok(vec![column]),
            };
        }
        let axes = ["x", "y", "z"].into_iter().take(dimension);
        axes.map(|axis| self.required(&format!("{name}_{axis}"), need))
            .collect()
    }

    /// Takes one row after the other.
    ///
    /// # Errors
    /// A row with too few or too many fields, no row at all, more than ids can count, and what
    /// the caller finds.
    pub fn rows(
        &self,
        mut take: impl FnMut(&Row<'_>) -> Result<(), TableFault>,
    ) -> Result<(), TableFault> {
        let mut count = 0;
        for record in reader(self.text).records() {
            let record = record.map_err(|error| broken(self.text, &error))?;
            if count == MOST_ROWS {
                let message = format!("more than {MOST_ROWS} {}s", self.each);
                let help = format!("give fewer {}s", self.each);
                return Err(TableFault::new(message, help, self.first_line()));
            }
            count += 1;
            take(&Row {
                text: self.text,
                record: &record,
            })?;
        }
        if count > 0 {
            return Ok(());
        }
        let message = format!("there are no {}s in the file", self.each);
        let help = format!("add a row a {}", self.each);
        Err(TableFault::new(message, help, self.first_line()))
    }
}

fn reader(text: &str) -> csv::Reader<&[u8]> {
    csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes())
}

/// A row that is no record: most often one with too few or too many fields.
fn broken(text: &str, error: &csv::Error) -> TableFault {
    let start = error
        .position()
        .map_or(0, |position| position.byte() as usize);
    let message = match error.kind() {
        csv::ErrorKind::UnequalLengths {
            pos,
            expected_len,
            len,
        } => {
            let line = pos.as_ref().map_or(0, |position| position.line());
            format!("line {line} has {len} fields, the heading has {expected_len}")
        }
        _ => error.to_string(),
    };
    let help = "give every row a field for each column; a file cut short ends like this";
    TableFault::new(message, help, line_at(text, start))
}

/// The line that begins at a byte, or behind the line end there.
fn line_at(text: &str, byte: usize) -> Range<usize> {
    let rest = text.get(byte..).unwrap_or("");
    let start = byte.min(text.len()) + (rest.len() - rest.trim_start().len());
    let rest = text.get(start..).unwrap_or("");
    start..start + rest.find(['\r', '\n']).unwrap_or(rest.len())
}

/// Where a row stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// From 1.
    pub number: u64,
    byte: u64,
}

/// A record and the text it comes from.
pub struct Row<'a> {
    text: &'a str,
    record: &'a csv::StringRecord,
}

impl Row<'_> {
    /// The text of a field; empty if the row is shorter.
    pub fn field(&self, column: &Column) -> &str {
        self.record.get(column.index).unwrap_or("")
    }

    /// The line of the text, from 1.
    pub fn line(&self) -> u64 {
        self.record.position().map_or(0, |position| position.line())
    }

    /// Where it stands.
    pub fn place(&self) -> Line {
        Line {
            number: self.line(),
            byte: self.record.position().map_or(0, |position| position.byte()),
        }
    }

    /// The bytes of a field; the whole line if it has quotes.
    pub fn span(&self, column: &Column) -> Range<usize> {
        let start = self.record.position().map_or(0, |position| position.byte());
        let line = line_at(self.text, start as usize);
        let content = &self.text[line.clone()];
        if content.contains('"') {
            return line;
        }
        let mut start = line.start;
        for (index, field) in content.split(',').enumerate() {
            if index == column.index {
                return start..start + field.len();
            }
            start += field.len() + 1;
        }
        line
    }

    /// A fault of a field: `line 3, mass = -1: need ...`.
    pub fn fault(&self, column: &Column, need: &str) -> TableFault {
        let message = format!(
            "line {}, {} = {}",
            self.line(),
            shortened(&column.name),
            shortened(self.field(column))
        );
        TableFault::new(message, need, self.span(column))
    }

    /// A finite number.
    ///
    /// # Errors
    /// Any other text.
    pub fn number(&self, column: &Column) -> Result<f64, TableFault> {
        let number = self.field(column).parse::<f64>().ok();
        number
            .filter(|number| number.is_finite())
            .ok_or_else(|| self.fault(column, "need an ordinary number"))
    }

    /// A coordinate between bounds.
    ///
    /// # Errors
    /// No finite number, or one outside.
    pub fn within(&self, column: &Column, [lower, upper]: [f64; 2]) -> Result<f64, TableFault> {
        let x = self.number(column)?;
        if (lower..=upper).contains(&x) {
            return Ok(x);
        }
        let need = format!("need a place in the domain: [{lower}, {upper}]");
        Err(self.fault(column, &need))
    }

    /// A number larger than 0.
    ///
    /// # Errors
    /// Any other text.
    pub fn positive(&self, column: &Column) -> Result<f64, TableFault> {
        let number = self.number(column)?;
        match number > 0.0 {
            true => Ok(number),
            false => Err(self.fault(column, "need a number larger than 0")),
        }
    }
}

/// A column that is read.
pub struct Column {
    /// As the heading has it.
    pub name: String,
    index: usize,
}
