//! The core of motes: a particle solver for first-order systems of partial differential
//! equations, without the standard library and without a heap.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

pub mod cloud;
pub mod cutoff;
pub mod digest;
pub mod domain;
pub mod equation;
pub mod error;
pub mod integrator;
pub mod material;
pub mod neighbours;
pub mod pairs;
pub mod scalar;
