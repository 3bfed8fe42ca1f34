//! Particles from a CSV file: a heading, then a row a particle.
//!
//! Columns, in any order: `position_x`, `velocity_x` and so on, one a direction (in one
//! dimension `position` and `velocity` will do), `mass`, and `energy` or `pressure`;
//! optional `density` and `material`. Others are passed over, so what motes writes can be
//! read again.

use std::fmt;
use std::ops::Range;
use std::path::Path;

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};

use super::{LARGEST, Placed, SetupError};
use crate::scenario::{EquationOfState, Scenario, Side};

/// Why a file is no cloud of particles, and where.
///
/// As a `miette::Report` it prints `file:line:column`, the line itself and the cure.
#[derive(Debug)]
pub struct CloudError {
    message: String,
    help: String,
    place: Option<(NamedSource<String>, Range<usize>)>,
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
        let (text, _) = self.place.as_ref()?;
        Some(text)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let (_, span) = self.place.as_ref()?;
        let label = LabeledSpan::at(span.clone(), "here");
        Some(Box::new(std::iter::once(label)))
    }
}

/// The particles of a file, in its order.
pub(super) fn read(path: &Path, scenario: &Scenario) -> Result<Vec<Placed>, SetupError> {
    let name = path.display().to_string();
    let nowhere = |message: String, help: &str| {
        Box::new(CloudError {
            message,
            help: help.to_owned(),
            place: None,
        })
    };
    let help = "check resolution.file: it is looked for in the folder of the scenario";
    let bytes = std::fs::read(path)
        .map_err(|error| nowhere(format!("cannot read `{name}`: {error}"), help))?;
    let text = String::from_utf8(bytes).map_err(|_| {
        nowhere(
            format!("`{name}` is not UTF-8 text"),
            "give a CSV file with a heading and a row a particle",
        )
    })?;
    parsed(&text, scenario).map_err(|fault| {
        let place = Some((NamedSource::new(&name, text.clone()), fault.span));
        SetupError::Cloud(Box::new(CloudError {
            message: fault.message,
            help: fault.help,
            place,
        }))
    })
}

/// Something wrong at some bytes of the text.
struct Fault {
    message: String,
    help: String,
    span: Range<usize>,
}

impl Fault {
    fn new(message: String, help: impl Into<String>, span: Range<usize>) -> Self {
        let help = help.into();
        Self {
            message,
            help,
            span,
        }
    }
}

fn parsed(text: &str, scenario: &Scenario) -> Result<Vec<Placed>, Fault> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let first_line = 0..text.find('\n').unwrap_or(text.len());
    let heading = reader
        .headers()
        .map_err(|error| Fault::new(error.to_string(), "give a heading", first_line.clone()))?;
    let columns = Columns::of(heading, scenario, first_line.clone())?;
    // A file need not say the density: then the mean is a first guess, once all masses are
    // known.
    let mut particles = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| broken(text, &error))?;
        if particles.len() == LARGEST {
            let message = format!("more than {LARGEST} particles");
            return Err(Fault::new(message, "give fewer particles", first_line));
        }
        let row = Row {
            text,
            record: &record,
        };
        particles.push(columns.particle(&row, scenario)?);
    }
    if particles.is_empty() {
        let message = "there are no particles in the file".to_owned();
        return Err(Fault::new(message, "add a row a particle", first_line));
    }
    if columns.density.is_none() {
        guess_density(&mut particles, scenario);
    }
    Ok(particles)
}

/// Gives every particle the mean density of the domain, and the pressure that goes with it.
fn guess_density(particles: &mut [Placed], scenario: &Scenario) {
    let extent = &scenario.domain.extent;
    let lengths = extent.lower.iter().zip(&extent.upper);
    let volume: f64 = lengths.map(|(lower, upper)| upper - lower).product();
    let density = particles.iter().map(|p| p.mass).sum::<f64>() / volume;
    for particle in particles {
        let law = &scenario.materials[usize::from(particle.material)].law;
        particle.density = density;
        particle.pressure = law.pressure(density, particle.energy);
    }
}

/// A row that is no record: most often one with too few or too many fields.
fn broken(text: &str, error: &csv::Error) -> Fault {
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
    Fault::new(message, help, line_at(text, start))
}

/// The line that begins at a byte, or behind the line end there.
fn line_at(text: &str, byte: usize) -> Range<usize> {
    let rest = text.get(byte..).unwrap_or("");
    let start = byte.min(text.len()) + (rest.len() - rest.trim_start().len());
    let rest = text.get(start..).unwrap_or("");
    start..start + rest.find(['\r', '\n']).unwrap_or(rest.len())
}

/// A record and the text it comes from.
struct Row<'a> {
    text: &'a str,
    record: &'a csv::StringRecord,
}

impl Row<'_> {
    fn field(&self, column: &Column) -> &str {
        self.record.get(column.index).unwrap_or("")
    }

    fn line(&self) -> u64 {
        self.record.position().map_or(0, |position| position.line())
    }

    /// The bytes of a field; the whole line if it has quotes.
    fn span(&self, column: &Column) -> Range<usize> {
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
    fn fault(&self, column: &Column, need: &str) -> Fault {
        let message = format!(
            "line {}, {} = {}",
            self.line(),
            column.name,
            self.field(column)
        );
        Fault::new(message, need, self.span(column))
    }

    fn number(&self, column: &Column) -> Result<f64, Fault> {
        let number = self.field(column).parse::<f64>().ok();
        number
            .filter(|number| number.is_finite())
            .ok_or_else(|| self.fault(column, "need an ordinary number"))
    }

    fn positive(&self, column: &Column) -> Result<f64, Fault> {
        let number = self.number(column)?;
        match number > 0.0 {
            true => Ok(number),
            false => Err(self.fault(column, "need a number larger than 0")),
        }
    }
}

/// A column that is read.
struct Column {
    name: String,
    index: usize,
}

/// The columns that are read.
struct Columns {
    position: Vec<Column>,
    velocity: Vec<Column>,
    mass: Column,
    energy: Option<Column>,
    pressure: Option<Column>,
    density: Option<Column>,
    material: Option<Column>,
}

impl Columns {
    fn of(
        heading: &csv::StringRecord,
        scenario: &Scenario,
        line: Range<usize>,
    ) -> Result<Self, Fault> {
        let optional = |name: &str| {
            let index = heading.iter().position(|column| column == name)?;
            let name = name.to_owned();
            Some(Column { name, index })
        };
        let missing = |message: String| {
            let help = format!(
                "need position_x, velocity_x and so on (dimension = {}), mass, and energy or \
                 pressure; the columns are: {}",
                scenario.dimension,
                heading.iter().collect::<Vec<_>>().join(", ")
            );
            Fault::new(message, help, line.clone())
        };
        let required = |name: &str| {
            optional(name).ok_or_else(|| missing(format!("there is no column `{name}`")))
        };
        let vector = |name: &str| -> Result<Vec<Column>, Fault> {
            let plain = optional(name).filter(|_| scenario.dimension == 1);
            if let Some(column) = plain {
                return Ok(vec![column]);
            }
            let axes = ["x", "y", "z"].into_iter().take(scenario.dimension);
            axes.map(|axis| required(&format!("{name}_{axis}")))
                .collect()
        };
        let columns = Self {
            position: vector("position")?,
            velocity: vector("velocity")?,
            mass: required("mass")?,
            energy: optional("energy"),
            pressure: optional("pressure"),
            density: optional("density"),
            material: optional("material"),
        };
        let laws = || scenario.materials.iter().map(|material| &material.law);
        if columns.energy.is_none() && !laws().all(EquationOfState::is_barotropic) {
            if columns.pressure.is_none() {
                return Err(missing(
                    "there is no column `energy` or `pressure`".to_owned(),
                ));
            }
            if columns.density.is_none() {
                let message = "there is a column `pressure`, but none of `density` that would \
                               make an energy of it";
                return Err(missing(message.to_owned()));
            }
        }
        Ok(columns)
    }

    fn particle(&self, row: &Row<'_>, scenario: &Scenario) -> Result<Placed, Fault> {
        let mut particle = Placed {
            position: [0.0; 3],
            velocity: [0.0; 3],
            mass: row.positive(&self.mass)?,
            density: match &self.density {
                Some(column) => row.positive(column)?,
                None => 0.0,
            },
            pressure: 0.0,
            energy: 0.0,
            material: match &self.material {
                Some(column) => material(row, column, scenario)?,
                None => 0,
            },
        };
        for (x, column) in particle.position.iter_mut().zip(&self.position) {
            *x = row.number(column)?;
        }
        self.check_position(row, &particle, scenario)?;
        for (u, column) in particle.velocity.iter_mut().zip(&self.velocity) {
            *u = row.number(column)?;
        }
        let law = &scenario.materials[usize::from(particle.material)].law;
        if !law.is_barotropic() {
            particle.energy = self.energy(row, law, particle.density)?;
        }
        if self.density.is_some() {
            particle.pressure = law.pressure(particle.density, particle.energy);
        }
        Ok(particle)
    }

    /// The energy of the row, or that of its pressure.
    fn energy(&self, row: &Row<'_>, law: &EquationOfState, density: f64) -> Result<f64, Fault> {
        if let Some(column) = &self.energy {
            return row.positive(column);
        }
        let Some(column) = &self.pressure else {
            return Ok(0.0);
        };
        let energy = law.energy(density, row.number(column)?);
        match energy > 0.0 {
            true => Ok(energy),
            false => Err(row.fault(column, "need a pressure that leaves an energy above 0")),
        }
    }

    /// Beyond a wall or a periodic side there is nothing.
    fn check_position(
        &self,
        row: &Row<'_>,
        particle: &Placed,
        scenario: &Scenario,
    ) -> Result<(), Fault> {
        let extent = &scenario.domain.extent;
        for (i, column) in self.position.iter().enumerate() {
            let (x, sides) = (particle.position[i], scenario.domain.sides[i]);
            let below = sides[0] != Side::Free && x < extent.lower[i];
            let above = sides[1] != Side::Free && x > extent.upper[i];
            if below || above {
                let (lower, upper) = (extent.lower[i], extent.upper[i]);
                let need = format!("need a place in the domain: [{lower}, {upper}]");
                return Err(row.fault(column, &need));
            }
        }
        Ok(())
    }
}

/// The material of a row: a name, or its number from 0 as motes writes it.
fn material(row: &Row<'_>, column: &Column, scenario: &Scenario) -> Result<u8, Fault> {
    let names = || {
        scenario
            .materials
            .iter()
            .map(|material| material.name.as_str())
    };
    let field = row.field(column);
    let place = names().position(|name| name == field);
    let number = || field.parse().ok().filter(|&n| n < names().count());
    place
        .or_else(number)
        .and_then(|place| u8::try_from(place).ok())
        .ok_or_else(|| {
            let known: Vec<&str> = names().collect();
            row.fault(
                column,
                &format!("need one of the materials: {}", known.join(", ")),
            )
        })
}
