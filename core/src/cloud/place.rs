//! Where and when.

/// Where and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<S, const D: usize> {
    /// Position `x`.
    pub position: [S; D],
    /// Time `t`.
    pub time: S,
}
