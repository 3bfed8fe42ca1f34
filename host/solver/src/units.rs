//! Solver units: the mean spacing, the mean density and the largest sound speed of the first
//! state are 1, and the middle of the domain is 0.
//!
//! In them a particle has a mass of about 1 and nothing is large, which is what lets a
//! 32-bit fixed-point number hold a run.

/// The size of each solver unit in the scenario's own units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolverUnits {
    /// The unit of length: the mean spacing.
    pub length: f64,
    /// The unit of mass: the mean mass of a particle.
    pub mass: f64,
    /// The unit of velocity: the reference sound speed.
    pub velocity: f64,
    /// The dimension of space.
    pub dimension: i32,
}

impl SolverUnits {
    /// The unit of time.
    pub fn time(&self) -> f64 {
        self.length / self.velocity
    }
    /// The unit of density.
    pub fn density(&self) -> f64 {
        self.mass / self.length.powi(self.dimension)
    }
    /// The unit of energy per mass.
    pub fn energy(&self) -> f64 {
        self.velocity * self.velocity
    }
}
