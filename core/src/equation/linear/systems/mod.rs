//! Linear systems, one per file. Each gives its equations, its symmetriser and the parity of its
//! components at a wall.

mod acoustics;
mod elastic_waves;
mod linearised_gas;
mod matrices;
mod maxwell;
mod shallow_water;
mod telegraph;
#[cfg(test)]
mod tests;
mod transport;

pub use acoustics::Acoustics;
pub use elastic_waves::ElasticWaves;
pub use linearised_gas::LinearisedGas;
pub use matrices::Matrices;
pub use maxwell::MaxwellTe;
pub use shallow_water::{Location, ShallowWater};
pub use telegraph::Telegraph;
pub use transport::Transport;

/// What is 1 for the solver, in the units that a system's numbers are given in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// The unit of length: the mean spacing.
    pub length: f64,
    /// The unit of velocity: the fastest wave.
    pub velocity: f64,
}

impl Units {
    /// Numbers are in solver units already.
    pub const ONE: Self = Self {
        length: 1.0,
        velocity: 1.0,
    };

    /// A factor of a space derivative in solver units.
    fn flux(&self, factor: f64) -> f64 {
        factor / self.velocity
    }

    /// A rate in solver units.
    fn rate(&self, rate: f64) -> f64 {
        rate * (self.length / self.velocity)
    }
}
