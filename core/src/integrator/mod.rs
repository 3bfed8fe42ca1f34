//! Time integrators.

pub mod leap_frog;
