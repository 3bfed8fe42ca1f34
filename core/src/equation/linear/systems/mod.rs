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
mod variable_matrices;

pub use acoustics::Acoustics;
pub use elastic_waves::ElasticWaves;
pub use linearised_gas::LinearisedGas;
pub use matrices::Matrices;
pub use maxwell::MaxwellTe;
pub use shallow_water::{Location, ShallowWater};
pub use telegraph::Telegraph;
pub use transport::Transport;
pub use variable_matrices::{MatrixField, VariableMatrices};

pub use crate::cloud::Units;
