//! The places of the particles of a file, with the lines that they stand on.

use super::claims::{Contradiction, contradiction};
use super::coincidence::{Room, SAME_PLACE, coincidence, mean_spacing};
use crate::scenario::table::{Line, Table, TableFault};
use crate::scenario::{Domain, Side};

/// The places of the particles of a file.
pub struct Places {
    positions: Vec<[f64; 3]>,
    lines: Vec<Line>,
    room: Room,
    mirrored: [[bool; 2]; 3],
}

impl Room {
    /// The room of a domain.
    pub fn of(domain: &Domain) -> Self {
        let extent = &domain.extent;
        let at = |corner: &[f64], i: usize| corner.get(i).copied().unwrap_or(0.0);
        Self {
            lower: std::array::from_fn(|i| at(&extent.lower, i)),
            lengths: std::array::from_fn(|i| at(&extent.upper, i) - at(&extent.lower, i)),
            periodic: std::array::from_fn(|i| domain.sides.get(i) == Some(&[Side::Periodic; 2])),
        }
    }
}

impl Places {
    /// None yet, in a domain.
    pub fn new(domain: &Domain) -> Self {
        let mirrored = |i: usize| {
            let sides = domain.sides.get(i);
            sides.map_or([false; 2], |sides| sides.map(|side| side == Side::Mirror))
        };
        Self {
            positions: Vec::new(),
            lines: Vec::new(),
            room: Room::of(domain),
            mirrored: std::array::from_fn(mirrored),
        }
    }

    /// Adds one.
    pub fn push(&mut self, position: [f64; 3], line: Line) {
        self.positions.push(position);
        self.lines.push(line);
    }

    /// Where the row of a particle stands.
    pub fn line(&self, particle: usize) -> Line {
        self.lines[particle]
    }

    /// That no two are one.
    ///
    /// # Errors
    /// The first particle that lies where one before it lies, with the lines and places of both.
    pub fn check_apart(&self, table: &Table<'_>) -> Result<(), TableFault> {
        let tolerance = SAME_PLACE * mean_spacing(&self.positions, &self.room);
        let Some(found) = coincidence(&self.positions, &self.room, tolerance) else {
            return Ok(());
        };
        let particles = [found.first, found.second];
        let [first, second] = particles.map(|id| self.lines[id].number);
        let [there, here] = particles.map(|id| self.room.shown(&self.positions[id]));
        let mut message = format!(
            "line {second}: the particle at {here} lies where that of line {first} lies, at {there}"
        );
        let along = |i: &usize| {
            let [a, b] = particles.map(|id| self.positions[id][*i]);
            self.room.periodic[*i] && (a - b).abs() > 0.5 * self.room.lengths[*i]
        };
        if let Some(axis) = (0..3).find(along) {
            let axis = ["x", "y", "z"][axis];
            message += &format!(": the sides along {axis} are periodic, both ends of it one place");
        }
        if found.count > 1 {
            message += &format!(
                "; so do {} of {} particles",
                found.count,
                self.positions.len()
            );
        }
        let help = "keep one particle a place: no width of the cut-off tells two apart there. Of a \
                    period give the lower end or the upper, not both";
        Err(table.fault_at(self.lines[found.second], message, help))
    }

    /// The first contradiction between the places and the volumes of the particles.
    pub fn contradiction(&self, volumes: &[f64]) -> Option<Contradiction> {
        contradiction(&self.positions, volumes, &self.room, &self.mirrored)
    }
}
