//! The core of motes: a particle solver for first-order systems of partial differential
//! equations, without the standard library and without a heap.
//!
//! Features; all but `std` are on by default:
//!
//! | feature | what it adds |
//! |---|---|
//! | `fixed` | the fixed-point scalars `Q32` and `Q64`, over the crate `fixed` |
//! | `heapless` | all the memory of a cloud in one piece, for devices: `GasStorage`, `LinearStorage`, `DirectStorage`, `DiffusionStorage`; without it the caller lends slices |
//! | `micromath` | the scalar `Micro`: f32 with approximate square roots |
//! | `std` | square roots of the standard library instead of `libm`'s: the same bits, and they vectorise |
//!
//! No feature changes a bit of a result.
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
mod numbered;
pub mod pairs;
pub mod scalar;
