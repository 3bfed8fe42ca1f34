//! Linear first-order systems (1.1) on moving particles: (1.18) to (1.21).
//!
//! `∂u/∂t + Σ_i ∂_i(A^i u) + A⁰ u = f`, `u` of `P` components, `A^i = a^i I + B^i`. Particles
//! follow a field `a` ([`VelocityField`]) that is free to choose, and carry strengths
//! `q_k = w_k u_k`. A [`FirstOrderSystem`] says what the `A^i` are: `systems` has some, each in a
//! file that reads like its equations.

mod dynamics;
mod law;
mod line;
#[cfg(feature = "heapless")]
mod linear_storage;
mod rates;
mod reconstruction;
mod sourced;
mod storage;
mod system;
pub mod systems;

pub use dynamics::{LinearDynamics, Stability};
pub use law::{SystemNode, SystemSums};
pub use line::Line;
#[cfg(feature = "heapless")]
pub use linear_storage::LinearStorage;
pub use sourced::{Addition, Sourced};
pub use storage::LinearWorkspace;
pub use system::FirstOrderSystem;

pub use crate::cloud::{
    Compression, NamedField, Particle, Place, Register, Rotation, Shear, Start, State, Still,
    Uniform, VelocityField, Wave,
};
pub use crate::pairs::Nothing;
