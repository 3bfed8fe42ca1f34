//! The digest of a state: 64 bits that change when any bit of it does.

use core::fmt;

use xxhash_rust::xxh64::xxh64;

use crate::equation::gas::Gas;
use crate::equation::linear::State;
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

    /// Adds an array of vectors, in id order, each by components.
    pub fn vectors<S: Scalar, const D: usize>(&mut self, values: &[[S; D]]) {
        for value in values {
            self.scalars(value);
        }
    }

    /// Adds an array of vectors of sums of products: each 16 bytes, zero-extended.
    pub fn wide<S: Scalar, const P: usize>(&mut self, values: &[[S::Wide; P]]) {
        let nothing = S::product(S::ZERO, S::ZERO);
        for &value in values.iter().flatten() {
            // As for scalars: both zeros have one digest.
            let bytes = S::wide_bits(S::wide_sum(value, nothing)).to_le_bytes();
            self.0 = xxh64(&bytes, self.0);
        }
    }

    /// The digest of all that was added.
    pub fn digest(&self) -> Digest {
        Digest(self.0)
    }
}

impl<S: Scalar, const D: usize> Gas<'_, S, D> {
    /// The digest of the state: position, velocity, energy, mass, ε, density, force, power,
    /// its slope and the factor of the viscosity, each for all particles in id order.
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
        digester.scalars(self.power_slope);
        digester.scalars(self.viscosity_factor);
        digester.digest()
    }
}

impl<S: Scalar, const D: usize, const P: usize> State<'_, S, D, P> {
    /// The digest of the state: position, weight and strength, each for all particles in id
    /// order.
    pub fn digest(&self) -> Digest {
        let mut digester = Digester::new();
        digester.vectors(self.position);
        digester.scalars(self.weight);
        digester.wide::<S, P>(self.strength);
        digester.digest()
    }
}
