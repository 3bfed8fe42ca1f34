//! motes on a server: scenarios, threads, exact solutions, reports.

pub mod benchmark;
pub mod cli;
pub mod comparison;
pub mod engine;
pub mod exact;
pub mod experiment;
pub mod export;
pub mod flows;
pub mod io;
pub mod linear;
pub mod report;
pub mod scenario;
pub mod setup;
pub mod simulation;
pub mod snapshots;
pub mod study;
pub mod suite;
pub mod sums;
pub mod symmetriser;
mod table;
pub mod units;
