//! Gas dynamics in `D` dimensions: (3.7), (3.10), (3.12), (3.13).
//!
//! `dx_k/dt = u_k`
//!
//! `ρ_k = Σ_l m_l ζ_ε_k(x_k - x_l)`                                         [`density`]
//!
//! `m_k du_k/dt = -Σ_l m_k m_l [P_k ∇ζ_kl(ε_k) + P_l ∇ζ_kl(ε_l) + Π_kl g_kl]`  [`motion`]
//!
//! `m_k de_k/dt = m_k P_k Σ_l m_l (u_k-u_l)·∇ζ_kl(ε_k) + 1/2 Σ_l m_k m_l Π_kl (u_k-u_l)·g_kl`
//!
//! with `P = p/(Ω ρ²)`, `g_kl` the mean of the two gradients and `Π` the pseudo-viscosity.
//!
//! Differs from the paper: ε may vary from particle to particle, hence Ω (Springel &
//! Hernquist, MNRAS 333, 649, 2002); any dimension; signs as corrected in `docs/paper.md`.

mod densities;
pub mod density;
pub mod direction;
mod dynamics;
mod end;
pub mod energy;
pub mod exchange;
mod exchange_rates;
pub mod far;
#[cfg(feature = "heapless")]
mod gas_storage;
pub mod gradient;
mod inflow;
mod leap_frog;
pub mod motion;
mod node;
pub mod open;
pub mod options;
mod packing;
mod physics;
mod proof;
mod rates;
pub mod reservoir;
pub mod state;
mod storage;
pub mod stress;
pub mod switch;
pub mod terms;
pub mod tube;
pub mod viscosity;
mod wall_forces;
pub mod walls;
mod waves;

pub use density::Width;
pub use dynamics::GasDynamics;
pub use far::Far;
#[cfg(feature = "heapless")]
pub use gas_storage::{GasStorage, OptionsStorage, PlainStorage};
pub use inflow::Inflow;
pub use open::{Cloud, Opening, Zone};
pub use options::{Diffusion, EnergyForm, Options, Plain, Switch, Weights};
pub use packing::Packing;
pub use physics::{Physics, Sorted, Thermal};
pub use state::{Gas, Particle};
pub use storage::{GradientBuffers, RatesOf, Workspace};
pub use terms::Terms;
pub use tube::{Stretch, Tube};
pub use viscosity::Viscosity;
pub use wall_forces::WallForces;
pub use walls::NoSlip;
