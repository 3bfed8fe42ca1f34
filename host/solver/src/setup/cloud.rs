//! Particles of a gas from a CSV file: a heading, then a row a particle.
//!
//! Columns, in any order: `position_x`, `velocity_x` and so on, one a direction (in one
//! dimension `position` and `velocity` will do), `mass`, and `energy` or `pressure`;
//! optional `density` and `material`. Others are passed over, so what motes writes can be
//! read again.

use std::path::Path;

use super::places::Places;
use super::{Placed, SetupError};
use crate::scenario::table::{self, Column, Row, Table, TableFault};
use crate::scenario::{EquationOfState, Scenario};
use crate::sums::compensated;

/// The particles of a file, in its order; `doubts`: what does not keep them from being run.
pub(super) fn read(
    path: &Path,
    scenario: &Scenario,
    doubts: &mut Vec<String>,
) -> Result<Vec<Placed>, SetupError> {
    table::read(path, |table| parsed(table, scenario, doubts)).map_err(SetupError::Cloud)
}

fn parsed(
    table: &Table<'_>,
    scenario: &Scenario,
    doubts: &mut Vec<String>,
) -> Result<Vec<Placed>, TableFault> {
    let columns = Columns::of(table, scenario)?;
    // A file need not say the density: then the mean is a first guess, once all masses are
    // known.
    let mut particles = Vec::new();
    let mut places = Places::new(&scenario.domain);
    table.rows(|row| {
        let particle = columns.particle(row, scenario)?;
        places.push(particle.position, row.place());
        particles.push(particle);
        Ok(())
    })?;
    places.check_apart(table)?;
    if columns.density.is_none() {
        guess_density(&mut particles, scenario);
        return Ok(particles);
    }
    let volumes: Vec<f64> = particles.iter().map(|p| p.mass / p.density).collect();
    if let Some(found) = places.contradiction(&volumes) {
        let Placed { mass, density, .. } = particles[found.particle];
        let message = format!(
            "line {}: density = {density} with mass = {mass} is a volume of {:.4e}, but its \
             neighbours leave it {:.4e}, a density of {:.4e}{}",
            places.line(found.particle).number,
            found.claimed,
            found.room,
            mass / found.room,
            found.extent(),
        );
        let help = "densities are summed from masses and places anyway (3.10): give mass, density and \
                    position in the scenario's units, or leave `density` out and give `energy`";
        if found.is_of_most {
            return Err(table.fault_at(places.line(found.particle), message, help));
        }
        doubts.push(format!("{message}; {help}"));
    }
    Ok(particles)
}

/// Gives every particle the mean density of the domain, and the pressure that goes with it.
fn guess_density(particles: &mut [Placed], scenario: &Scenario) {
    let extent = &scenario.domain.extent;
    let lengths = extent.lower.iter().zip(&extent.upper);
    let volume: f64 = lengths.map(|(lower, upper)| upper - lower).product();
    // In order of size: the rows may be in any.
    let mut masses: Vec<f64> = particles.iter().map(|p| p.mass).collect();
    masses.sort_unstable_by(f64::total_cmp);
    let density = compensated(masses.into_iter()) / volume;
    for particle in particles {
        let law = &scenario.materials[usize::from(particle.material)].law;
        particle.density = density;
        particle.pressure = law.pressure(density, particle.energy);
    }
}

/// The headings that are read.
const NAMES: [&str; 13] = [
    "position",
    "position_x",
    "position_y",
    "position_z",
    "velocity",
    "velocity_x",
    "velocity_y",
    "velocity_z",
    "mass",
    "energy",
    "pressure",
    "density",
    "material",
];

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
    fn of(table: &Table<'_>, scenario: &Scenario) -> Result<Self, TableFault> {
        let dimension = scenario.dimension;
        let need = format!(
            "need position_x, velocity_x and so on (dimension = {dimension}), mass, and energy or \
             pressure"
        );
        table.spelled(&NAMES)?;
        let columns = Self {
            position: table.vector("position", dimension, &need)?,
            velocity: table.vector("velocity", dimension, &need)?,
            mass: table.required("mass", &need)?,
            energy: table.optional("energy")?,
            pressure: table.optional("pressure")?,
            density: table.optional("density")?,
            material: table.optional("material")?,
        };
        let laws = || scenario.materials.iter().map(|material| &material.law);
        if columns.energy.is_none() && !laws().all(EquationOfState::is_barotropic) {
            if columns.pressure.is_none() {
                let message = "there is no column `energy` or `pressure`";
                return Err(table.fault(message.to_owned(), &need));
            }
            if columns.density.is_none() {
                let message = "there is a column `pressure`, but none of `density` that would \
                               make an energy of it";
                return Err(table.fault(message.to_owned(), &need));
            }
        }
        Ok(columns)
    }

    fn particle(&self, row: &Row<'_>, scenario: &Scenario) -> Result<Placed, TableFault> {
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
        let places = particle.position.iter_mut().zip(&self.position);
        for (i, (x, column)) in places.enumerate() {
            *x = row.within(column, scenario.domain.bounds(i))?;
        }
        for (u, column) in particle.velocity.iter_mut().zip(&self.velocity) {
            *u = row.number(column)?;
        }
        let law = &scenario.materials[usize::from(particle.material)].law;
        if !law.is_barotropic() {
            particle.energy = self.energy(row, law, particle.density)?;
        }
        if self.density.is_some() {
            particle.pressure = law.pressure(particle.density, particle.energy);
            self.agrees(row, law, &particle)?;
        }
        Ok(particle)
    }

    /// That a pressure beside an energy is the one that the equation of state gives.
    fn agrees(
        &self,
        row: &Row<'_>,
        law: &EquationOfState,
        particle: &Placed,
    ) -> Result<(), TableFault> {
        let (Some(_), Some(column), false) = (&self.energy, &self.pressure, law.is_barotropic())
        else {
            return Ok(());
        };
        let (given, made) = (row.number(column)?, particle.pressure);
        // What a run in few bits writes: a pressure that is a small difference of large terms.
        let rounding = 1e-5 * particle.density * particle.energy;
        if (given - made).abs() <= 0.01 * given.abs().max(made.abs()) + rounding {
            return Ok(());
        }
        let need = format!(
            "its density and energy give {made:.6e} by the equation of state ({}): take `energy` or \
             `pressure` out, or correct one of them, or [material]",
            law.name()
        );
        Err(row.fault(column, &need))
    }

    /// The energy of the row, or that of its pressure.
    fn energy(
        &self,
        row: &Row<'_>,
        law: &EquationOfState,
        density: f64,
    ) -> Result<f64, TableFault> {
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
}

/// The material of a row: a name, or its number from 0 as motes writes it.
fn material(row: &Row<'_>, column: &Column, scenario: &Scenario) -> Result<u8, TableFault> {
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
