//! motes on a server: scenarios, threads, exact solutions, reports.

pub mod benchmark;
pub mod cli;
pub mod experiment;
pub mod export;
pub mod io;
pub mod report;
pub mod run;
mod scalars;
pub mod snapshots;
pub mod study;
pub mod suite;

pub use motes_solver::{engine, exact, families, flows, scenario, setup, sums, symmetriser, units};
