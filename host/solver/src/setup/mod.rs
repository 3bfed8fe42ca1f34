//! From a scenario to particles: where they are at t = 0, and in what state.
//!
//! Ids run region by region in the order of the file, boxes first, then the balls that have
//! particles of their own; inside a lattice the first direction is the slowest and the last
//! the fastest. Elementary functions come from `libm` and random numbers from integers, so
//! that a scenario gives the same bits on every platform.
//!
//! An arrangement is a file here: `line`, `square`, `hexagonal`, `cubic`,
//! `close_packed`, `sampled`, `glass`, `cloud`.

mod apportion;
mod arrange;
mod block;
mod claims;
mod close_packed;
mod cloud;
mod coincidence;
mod cubic;
mod deposit;
mod error;
mod glass;
mod hexagonal;
mod line;
mod places;
mod profile;
mod random;
mod regions;
mod sampled;
mod square;
#[cfg(test)]
mod tests;
mod tree;

pub use crate::scenario::table::CloudError;
pub use apportion::apportion;
pub use claims::{Contradiction, contradiction};
pub use coincidence::{Coincidence, Room, SAME_PLACE, coincidence, mean_spacing};
pub use error::SetupError;
pub use places::Places;

use crate::scenario::table::MOST_ROWS;
use crate::scenario::{Arrangement, Scenario};

/// A particle at t = 0, in the scenario's units; components beyond the dimension are 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed {
    /// Where it is.
    pub position: [f64; 3],
    /// How it moves.
    pub velocity: [f64; 3],
    /// > 0.
    pub mass: f64,
    /// Mass / length^dimension, > 0. Of a cloud whose file does not say: the mean density of
    /// the domain, a first guess.
    pub density: f64,
    /// Density * velocity^2.
    pub pressure: f64,
    /// Internal energy per mass; 0 where it plays no part.
    pub energy: f64,
    /// A place in the scenario's list of materials.
    pub material: u8,
}

/// Ids, cells and words of neighbour lists are 32 bits wide; cells are up to four a particle.
pub const LARGEST: usize = MOST_ROWS;

/// The particles of a scenario at t = 0.
///
/// # Errors
/// Regions and deposits without particles, files that are no cloud, glasses too small for
/// their sides, and more than [`LARGEST`] particles.
pub fn particles(scenario: &Scenario) -> Result<Vec<Placed>, SetupError> {
    Ok(placed(scenario)?.0)
}

/// The same, and what a careful reader should know of the file that they come from.
///
/// # Errors
/// Those of [`particles`].
pub fn placed(scenario: &Scenario) -> Result<(Vec<Placed>, Vec<String>), SetupError> {
    check_count(scenario)?;
    let mut doubts = Vec::new();
    let mut particles = match (&scenario.resolution.arrangement, &scenario.profile) {
        (Arrangement::File(file), _) => cloud::read(file, scenario, &mut doubts)?,
        (_, Some(profile)) => profile::place(profile, scenario)?,
        (_, None) if scenario.dimension == 1 => line::place(scenario)?,
        (_, None) => regions::place(scenario)?,
    };
    deposit::add(scenario, &mut particles)?;
    Ok((particles, doubts))
}

/// Refuses more than [`LARGEST`] particles, before any is placed.
pub fn check_count(scenario: &Scenario) -> Result<(), SetupError> {
    let particles = scenario.resolution.particles;
    match particles > LARGEST {
        true => Err(SetupError::TooMany {
            particles,
            limit: LARGEST,
        }),
        false => Ok(()),
    }
}
