//! A scenario as Rust source for a device: numbers in solver units, written with the digits that
//! read back to the same bits.

mod line;
mod tube;

pub use line::{NoLine, line};
pub use tube::{NoTube, tube};

/// The command that made a file, fit for a line of comment.
fn one_line(command: &str) -> String {
    command.split_whitespace().collect::<Vec<_>>().join(" ")
}
