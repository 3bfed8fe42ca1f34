//! Exact solutions, one per file, shared by tests, pictures and studies.

pub mod riemann;
