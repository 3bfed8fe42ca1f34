//! Linear first-order systems (1.1) on moving particles: (1.18) to (1.21).
//!
//! `∂u/∂t + Σ_i ∂_i(A^i u) + A⁰ u = f`, `u` of `P` components, `A^i = a^i I + B^i`. Particles
//! follow a field `a` ([`VelocityField`]) that is free to choose, and carry strengths
//! `q_k = w_k u_k`. A [`FirstOrderSystem`] says what the `A^i` are: `systems` has some, each in a
//! file that reads like its equations.

#[cfg(feature = "heapless")]
mod cloud;
mod dynamics;
mod field;
mod law;
mod line;
#[cfg(feature = "heapless")]
mod linear_storage;
mod rates;
mod reconstruction;
mod state;
mod storage;
mod system;
pub mod systems;

#[cfg(feature = "heapless")]
pub(crate) use cloud::CloudStorage;
pub use dynamics::{LinearDynamics, Stability};
pub use field::{
    Compression, Named as NamedField, Rotation, Shear, Still, Uniform, VelocityField, Wave,
};
pub use law::{SystemNode, SystemSums};
pub use line::Line;
#[cfg(feature = "heapless")]
pub use linear_storage::LinearStorage;
pub use state::{Particle, State};
pub use storage::{LinearWorkspace, Register, Start};
pub use system::{FirstOrderSystem, Nothing, Place};
