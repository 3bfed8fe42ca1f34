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

/// Nothing that was proven overflowed; and of both kinds there were some.
pub fn agree(pairs: &[(Made, Made)]) {
    for (at, &(guarded, marked)) in pairs.iter().enumerate() {
        assert!(
            guarded != Made::Steps || marked == Made::Steps,
            "case {at}: proven, and {marked:?}: {pairs:?}"
        );
        // Where an overflow was marked, a proof had failed before.
        assert!(
            marked != Made::Overflowed || guarded == Made::Unproven,
            "case {at}: {guarded:?}, and {marked:?}: {pairs:?}"
        );
    }
    let proven = pairs.iter().any(|pair| pair.0 == Made::Steps);
    let refused = pairs.iter().any(|pair| pair.0 == Made::Unproven);
    let overflowed = pairs.iter().any(|pair| pair.1 == Made::Overflowed);
    assert!(proven && refused && overflowed, "{pairs:?}");
}
