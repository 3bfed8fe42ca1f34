//! Time integrators.

mod clock;
pub mod leap_frog;

pub use clock::Clock;
