//! The digest of a state: 64 bits that change when any bit of it does.

use core::fmt;

use xxhash_rust::xxh64::Xxh64;

use crate::equation::gas::Gas;
use crate::scalar::Scalar;

/// XXH64 (seed 0) over the bits of a state; printed as 16 hexadecimal digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest(pub u64);

impl fmt::Display for Digest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

/// Feeds arrays of scalars to a [`Digest`].
pub struct Digester(Xxh64);

impl Default for Digester {
    fn default() -> Self {
        Self::new()
    }
}

impl Digester {
    /// A digest of nothing yet.
    pub fn new() -> Self {
        Self(Xxh64::new(0))
    }

    /// Adds one scalar: its bit pattern, least significant byte first.
    pub fn scalar<S: Scalar>(&mut self, value: S) {
        // -0.0 + 0.0 is +0.0: both zeros have one digest.
        let bytes = (value + S::ZERO).bits().to_le_bytes();
        self.0.update(bytes.get(..S::BYTES).unwrap_or(&bytes));
    }

    /// Adds an array, in id order.
    pub fn scalars<S: Scalar>(&mut self, values: &[S]) {
        for &value in values {
            self.scalar(value);
        }
    }

    /// Adds an array of vectors, in id order, each by components.
    pub fn vectors<S: Scalar, const D: usize>(&mut self, values: &[[S; D]]) {
        for value in values {
            self.scalars(value);
        }
    }

    /// The digest of all that was added.
    pub fn digest(&self) -> Digest {
        Digest(self.0.digest())
    }
}

impl<S: Scalar, const D: usize> Gas<'_, S, D> {
    /// The digest of the state: position, velocity, energy, mass, ε, density, force and
    /// power, each for all particles in id order.
    pub fn digest(&self) -> Digest {
        let mut digester = Digester::new();
        digester.vectors(self.position);
        digester.vectors(self.velocity);
        digester.scalars(self.energy);
        digester.scalars(self.mass);
        digester.scalars(self.epsilon);
        digester.scalars(self.density);
        digester.vectors(self.force);
        digester.scalars(self.power);
        digester.digest()
    }
}
