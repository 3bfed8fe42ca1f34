//! What a run tells people and programs.

pub mod figure;
pub mod summary;
