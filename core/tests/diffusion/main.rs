//! Convection-diffusion against theory and exact solutions.

mod balance;
mod clouds;
mod forms;
mod layers;
mod media;
mod operator;
mod slab;
mod sums;
mod time;
mod transport;
mod upwind;
mod walls;
