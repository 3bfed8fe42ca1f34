//! The state of a cloud of strengths: arrays side by side, in memory that belongs to the caller.

use super::column::{Columns, Unit, columns};
use crate::digest::Digest;
use crate::error::{Error, Quantity};
use crate::numbered::numbered;
use crate::scalar::Scalar;

/// A particle as it is put into a cloud.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle<S, const D: usize, const P: usize> {
    /// Position `x`.
    pub position: [S; D],
    /// Weight `w` > 0, a volume.
    pub weight: S,
    /// `u`.
    pub value: [S; P],
}

impl<const D: usize, const P: usize> Particle<f64, D, P> {
    /// The particle in another scalar: every number rounded once.
    pub fn rounded<S: Scalar>(&self) -> Particle<S, D, P> {
        Particle {
            position: self.position.map(S::from_f64),
            weight: S::from_f64(self.weight),
            value: self.value.map(S::from_f64),
        }
    }
}

/// The state, the measure `Σ_k q_k δ(x - x_k)` of (1.11): one array a quantity, all of the same
/// length, indexed by particle id.
///
/// The first three are the state; the others are made from them.
pub struct State<'a, S: Scalar, const D: usize, const P: usize> {
    /// `x`.
    pub position: &'a mut [[S; D]],
    /// `w`.
    pub weight: &'a mut [S],
    /// `q = w u`, in the width of a product: in fixed point what a step adds to it is exact.
    pub strength: &'a mut [[S::Wide; P]],
    /// `u = q/w`, rounded.
    pub value: &'a mut [[S; P]],
    /// Partners within the support, without the particle itself.
    pub neighbours: &'a mut [S],
}

impl<S: Scalar, const D: usize, const P: usize> State<'_, S, D, P> {
    /// The digest of the state: position, weight and strength, each for all particles in id
    /// order.
    pub fn digest(&self) -> Digest {
        Columns::digest(self)
    }

    /// The same in any order of the particles: [`Columns::digest_unordered`].
    pub fn digest_unordered(&self) -> Digest {
        Columns::digest_unordered(self)
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.weight.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.weight.is_empty()
    }

    /// Sets strengths from weights and values: `q = w u` (1.19).
    pub fn weigh(&mut self) {
        let particles = self.strength.iter_mut().zip(self.weight.iter());
        for ((strength, &weight), value) in particles.zip(self.value.iter()) {
            *strength = value.map(|u| S::product(weight, u));
        }
    }

    /// `Σ_k q_k`, exact in fixed point: what (1.21)' says of.
    pub fn total(&self) -> [S::Wide; P] {
        let nothing = [S::product(S::ZERO, S::ZERO); P];
        self.strength.iter().fold(nothing, |mut sum, strength| {
            for (sum, &q) in sum.iter_mut().zip(strength) {
                *sum = S::wide_sum(*sum, q);
            }
            sum
        })
    }

    /// Whether all arrays have the same length.
    pub(crate) fn is_consistent(&self) -> bool {
        let n = self.weight.len();
        let lengths = [
            self.position.len(),
            self.strength.len(),
            self.value.len(),
            self.neighbours.len(),
        ];
        lengths.iter().all(|&length| length == n)
    }

    /// The entries of a particle; `None` beyond the end.
    #[inline(always)]
    pub(crate) fn row(&mut self, id: usize) -> Option<Row<'_, S, D, P>> {
        Some(Row {
            position: self.position.get_mut(id)?,
            weight: self.weight.get_mut(id)?,
            strength: self.strength.get_mut(id)?,
            value: self.value.get_mut(id)?,
        })
    }

    /// The first particle with a number that no run can go on with.
    pub(crate) fn check(&self) -> Result<(), Error> {
        for (id, (&weight, value)) in numbered(self.weight.iter().zip(self.value.iter())) {
            let particle = id as u32;
            let lost = |quantity| Err(Error::NotFinite { particle, quantity });
            if !weight.is_finite() {
                return lost(Quantity::Weight);
            }
            if !(weight > S::ZERO) {
                return Err(Error::Weight { particle });
            }
            if !value.iter().all(|u| u.is_finite()) {
                return lost(Quantity::Strength);
            }
        }
        Ok(())
    }
}

columns! {
    impl [const D: usize, const P: usize] State<'_, S, D, P> {
        position: vectors, Position, Directions, Unit::LENGTH, State;
        weight: scalars, Scalar, One, Unit::VOLUME, State;
        strength: strengths, Strength, Unknowns, Unit::UNKNOWN.times(Unit::VOLUME), State;
        value: vectors, Scalar, Unknowns, Unit::UNKNOWN, Carried;
        neighbours: scalars, Scalar, One, Unit::NONE, Derived;
    }
}

/// One particle of a [`State`].
pub(crate) struct Row<'a, S: Scalar, const D: usize, const P: usize> {
    pub(crate) position: &'a mut [S; D],
    pub(crate) weight: &'a mut S,
    pub(crate) strength: &'a mut [S::Wide; P],
    value: &'a mut [S; P],
}

impl<S: Scalar, const D: usize, const P: usize> Row<'_, S, D, P> {
    /// Makes `u = q/w` anew.
    #[inline(always)]
    pub(crate) fn revalue(self) {
        *self.value = self.strength.map(|q| S::saturated(q) / *self.weight);
    }
}
