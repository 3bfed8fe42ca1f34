//! Time integrators.

mod clock;
mod diffusion;
mod dynamics;
mod linear;
mod rkl2;
mod runge_kutta;
mod stepper;
#[cfg(test)]
mod tests;

pub use clock::Clock;
pub use dynamics::{DiffusionMethod, LeapFrog, OpenGas, Scheme};
pub use rkl2::{MOST_STAGES, Rkl2, Stabilised};
pub use runge_kutta::{From, RK4, RungeKutta, SSP_RK3, SemiDiscrete, Stage};
pub use stepper::Stepper;
