//! motes on a server: scenarios, threads, exact solutions, reports.

pub mod benchmark;
pub mod cli;
pub mod experiment;
pub mod export;
pub mod io;
pub mod linear;
pub mod report;
mod scalars;
pub mod simulation;
pub mod snapshots;
pub mod study;
pub mod suite;

pub use motes_solver::{
    comparison, engine, exact, flows, scenario, setup, sums, symmetriser, units,
};
