//! The digest of a state: 64 bits that change when any bit of it does.

use core::fmt;

use xxhash_rust::xxh64::xxh64;

use crate::scalar::Scalar;

/// A chain of XXH64: printed as 16 hexadecimal digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest(pub u64);

impl fmt::Display for Digest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

/// Takes scalars into a [`Digest`], one after the other.
///
/// The digest after a scalar is the XXH64 of its bytes with the digest before it as the
/// seed, from 0. (One call of the hash for each scalar: a streaming hash keeps a buffer, and
/// its bookkeeping has panics in it.)
#[derive(Clone, Copy, Debug, Default)]
pub struct Digester(u64);

impl Digester {
    /// A digest of nothing yet.
    pub const fn new() -> Self {
        Self(0)
    }

    /// Adds one scalar: its bit pattern, least significant byte first.
    pub fn scalar<S: Scalar>(&mut self, value: S) {
        // -0.0 + 0.0 is +0.0: both zeros have one digest.
        let bytes = (value + S::ZERO).bits().to_le_bytes();
        self.0 = xxh64(bytes.get(..S::BYTES).unwrap_or(&bytes), self.0);
    }

    /// Adds an array, in id order.
    pub fn scalars<S: Scalar>(&mut self, values: &[S]) {
        for &value in values {
            self.scalar(value);
        }
    }

    /// Adds an array of sums of products: each 16 bytes, zero-extended.
    pub fn wide<S: Scalar>(&mut self, values: &[S::Wide]) {
        let nothing = S::product(S::ZERO, S::ZERO);
        for &value in values {
            // As for scalars: both zeros have one digest.
            let bytes = S::wide_bits(S::wide_sum(value, nothing)).to_le_bytes();
            self.0 = xxh64(&bytes, self.0);
        }
    }

    /// Adds whole numbers.
    pub fn integers(&mut self, values: &[u8]) {
        self.0 = xxh64(values, self.0);
    }

    /// The digest of all that was added.
    pub fn digest(&self) -> Digest {
        Digest(self.0)
    }
}
