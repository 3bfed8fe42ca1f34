//! Clouds of strengths: what linear systems and convection-diffusion share. The plan, the memory
//! and the simulation of both, over a solver of either.

mod balance;
mod budget;
mod description;
mod diffusivity;
mod digits;
mod doubts;
mod field;
mod frame;
mod geometry;
mod growth;
mod jumps;
mod layers;
mod measures;
mod memory;
mod particles;
mod plan;
mod principle;
mod quadrature;
mod simulation;
mod sizes;
mod solver;
mod waves;

pub(super) use balance::Source;
pub use field::{RunField, ScaledField};
pub(super) use frame::{BETWEEN, all_over, times};
pub(super) use geometry::{flow, length, periods, spread, wave_vector};
pub(super) use memory::CloudArrays;
pub use plan::Plan;
pub use quadrature::{Quadrature, QuadratureError};
pub(super) use simulation::start;
pub(super) use solver::{CloudView, Maker, Solver, row};
pub(super) use waves::row_sum;
