//! Convection-diffusion (4.1) on moving particles, in the direct form (4.6) and the mixed form
//! (4.3).
//!
//! `∂u/∂t + div(a u) - div(b ∇u) = f(x, t, u)`, for `P` species at once. Particles follow `a` and
//! carry strengths `q_k = w_k u_k`, as those of linear systems do: the state, its registers and
//! the velocity fields are those of [`linear`](super::linear).

mod conductor;
#[cfg(feature = "heapless")]
mod diffusion_storage;
mod direct;
mod drive;
mod dynamics;
mod joints;
mod ledger;
mod lists;

mod mean;
mod mixed;
mod named;
mod node;
mod passage;
mod problem;
mod rates;
mod reaction;
mod reconstruction;
mod samples;
mod slab;
mod storage;
mod wall;

pub use conductor::{Conductor, Modulation};
#[cfg(feature = "heapless")]
pub use diffusion_storage::{DiffusionStorage, DirectStorage};
pub use direct::Direct;
pub use drive::{Drive, DrivenCondition};
pub use dynamics::{DiffusionDynamics, Form};
pub use ledger::{Intake, Ledger};
pub use lists::Lists;
pub use mean::Mean;
pub use mixed::{FluxSums, MixedNode};
pub use named::NamedProblem;
pub use node::{DiffusionNode, DiffusionSums};
pub use problem::{DiffusionProblem, Heat};
pub use reaction::Reaction;
pub use samples::{Corners, LargestDiffusivity, ReactionPoint};
pub use slab::Slab;
pub use storage::{DiffusionWorkspace, MixedWorkspace};
pub use wall::Condition;
