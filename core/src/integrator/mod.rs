//! Time integrators.

mod clock;
mod diffusion;
pub mod leap_frog;
mod linear;
mod registers;
mod rkl2;
mod runge_kutta;
#[cfg(test)]
mod tests;

pub use clock::Clock;
pub use rkl2::{MOST_STAGES, Rkl2, Stabilised};
pub use runge_kutta::{From, RK4, RungeKutta, SSP_RK3, SemiDiscrete, Stage};
