//! What becomes of steps in fixed point.

use motes_core::error::Error;

/// What became of some steps: proven, refused by a proof, or stopped otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Made {
    Steps,
    Unproven,
    Overflowed,
    Stopped,
}

impl From<Result<(), Error>> for Made {
    fn from(result: Result<(), Error>) -> Self {
        match result {
            Ok(()) => Self::Steps,
            Err(Error::Unproven { .. }) => Self::Unproven,
            Err(Error::NotFinite { .. }) => Self::Overflowed,
            Err(_) => Self::Stopped,
        }
    }
}
