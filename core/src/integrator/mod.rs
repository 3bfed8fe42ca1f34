//! Time integrators.

mod clock;
pub mod leap_frog;
mod linear;
mod runge_kutta;
#[cfg(test)]
mod tests;

pub use clock::Clock;
pub use runge_kutta::{From, RK4, RungeKutta, SSP_RK3, SemiDiscrete, Stage};
