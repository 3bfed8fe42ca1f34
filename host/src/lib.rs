//! motes on a server: scenarios, threads, exact solutions, reports.
#![warn(missing_docs)]

pub mod engine;
pub mod simulation;
