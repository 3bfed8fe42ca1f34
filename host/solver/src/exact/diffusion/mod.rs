//! Exact solutions of convection and diffusion, `du/dt + div(a u) - div(b grad u) = f`.
//!
//! Lengths, times and u are in the caller's units; a diffusivity is length^2 / time, where
//! a file does not say otherwise `b T` with a tensor T, and all solutions are for t >= 0.
//! H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids, 2nd edition, 1959;
//! J. Crank, The Mathematics of Diffusion, 2nd edition, 1975.

pub mod band;
pub mod gaussian;
pub mod legendre;
pub mod mode;
pub mod modulation;
mod reaction;
#[cfg(test)]
mod residual;
pub mod slab;
mod tensor;
