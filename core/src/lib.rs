//! The core of motes: a particle solver for first-order systems of partial differential
//! equations, without the standard library and without a heap.
#![no_std]
#![forbid(unsafe_code)]

pub mod cutoff;
pub mod scalar;
