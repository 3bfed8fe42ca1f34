//! From a scenario to its result: set-up, run, exact solution, comparison.
//!
//! All of it is generic over the scalar, and none of it is compiled for one: the crates of
//! `host/compiled` do that, side by side, each through [`compiled`].

pub mod compiled;
pub mod engine;
pub mod exact;
pub mod families;
pub mod flows;
pub mod run;
pub mod setup;
pub mod sums;
pub mod symmetriser;
pub mod units;

pub use motes_scenario as scenario;
