//! Convection-diffusion (4.1) on moving particles, in the direct form (4.6) and the mixed form
//! (4.3).
//!
//! `∂u/∂t + div(a u) - div(b ∇u) = f(x, t, u)`, for `P` species at once. Particles follow `a` and
//! carry strengths `q_k = w_k u_k`, as those of linear systems do: the state, its registers and
//! the velocity fields are those of [`linear`](super::linear).

mod direct;
mod dynamics;
mod mixed;
mod node;
mod problem;
mod rates;
mod storage;
mod wall;

pub use dynamics::{DiffusionDynamics, Form};
pub use mixed::{FluxSums, MixedNode};
pub use node::{DiffusionNode, DiffusionSums};
pub use problem::{DiffusionProblem, Heat};
pub use storage::{DiffusionStorage, DiffusionWorkspace};
pub use wall::Condition;
