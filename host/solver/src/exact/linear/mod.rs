//! Exact solutions of linear systems of first order, `du/dt + Σ_i d_i(A^i u) + A^0 u = f`.
//!
//! Every file but [`transport`] has constant coefficients, and its solution names them as a
//! [`system::System`]; [`modes`] solves any of those, one wave vector at a time.

pub mod acoustics;
pub mod elastic;
pub mod error;
mod gaussian;
pub mod linearised_gas;
pub mod maxwell;
pub mod modes;
pub mod plane_wave;
#[cfg(test)]
pub(in crate::exact) mod residual;
pub mod shallow_water;
pub mod system;
pub mod telegraph;
pub mod transport;
