//! The state of a cloud of strengths: arrays side by side, in memory that belongs to the caller.

use super::column::{Columns, Unit, columns};
use crate::digest::Digest;
use crate::domain::Domain;
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
/// The first three are the state, with what rounding has kept from two of them; the others are made
/// from them.
pub struct State<'a, S: Scalar, const D: usize, const P: usize> {
    /// `x`.
    pub position: &'a mut [[S; D]],
    /// `w`.
    pub weight: &'a mut [S],
    /// What rounding has kept from the positions so far: [`Scalar::step`].
    pub position_remainder: &'a mut [[S; D]],
    /// The same of the weights.
    pub weight_remainder: &'a mut [S],
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
            self.position_remainder.len(),
            self.weight_remainder.len(),
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
            position_remainder: self.position_remainder.get_mut(id)?,
            weight_remainder: self.weight_remainder.get_mut(id)?,
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
        position_remainder: vectors, Vector, Directions, Unit::LENGTH, Carried;
        weight_remainder: scalars, Scalar, One, Unit::VOLUME, Carried;
        strength: strengths, Strength, Unknowns, Unit::UNKNOWN.times(Unit::VOLUME), State;
        value: vectors, Scalar, Unknowns, Unit::UNKNOWN, Carried;
        neighbours: scalars, Scalar, One, Unit::NONE, Derived;
    }
}

/// What a particle was at the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<S: Scalar, const D: usize, const P: usize> {
    /// Its position.
    pub position: [S; D],
    /// Its weight.
    pub weight: S,
    /// What rounding had kept from its position.
    pub position_remainder: [S; D],
    /// What rounding had kept from its weight.
    pub weight_remainder: S,
    /// Its strength.
    pub strength: [S::Wide; P],
}

/// One particle of a [`State`].
pub(crate) struct Row<'a, S: Scalar, const D: usize, const P: usize> {
    pub(crate) position: &'a mut [S; D],
    pub(crate) weight: &'a mut S,
    pub(crate) position_remainder: &'a mut [S; D],
    pub(crate) weight_remainder: &'a mut S,
    pub(crate) strength: &'a mut [S::Wide; P],
    value: &'a mut [S; P],
}

impl<S: Scalar, const D: usize, const P: usize> Row<'_, S, D, P> {
    /// What it is, for the start of a step.
    #[inline(always)]
    pub(crate) fn start(&self) -> Start<S, D, P> {
        Start {
            position: *self.position,
            weight: *self.weight,
            position_remainder: *self.position_remainder,
            weight_remainder: *self.weight_remainder,
            strength: *self.strength,
        }
    }

    /// Makes its place and weight what they were.
    #[inline(always)]
    pub(crate) fn put_back(&mut self, start: &Start<S, D, P>) {
        *self.position = start.position;
        *self.weight = start.weight;
        *self.position_remainder = start.position_remainder;
        *self.weight_remainder = start.weight_remainder;
    }

    /// Moves it by `dt` times its velocity and lets its weight grow by `dt` times that rate; `id` is for errors.
    #[inline(always)]
    pub(crate) fn carry(
        &mut self,
        domain: &Domain<S, D>,
        dt: S,
        (velocity, growth): (&[S; D], S),
        id: u32,
    ) -> Result<(), Error> {
        let mut step = [S::ZERO; D];
        for i in 0..D {
            step[i] = self.position[i].step(dt, velocity[i], &mut self.position_remainder[i]);
        }
        let reflected = domain.drift(self.position, &step, id)?;
        for (left, reflected) in self.position_remainder.iter_mut().zip(reflected) {
            if reflected {
                *left = -*left;
            }
        }
        *self.weight += self.weight.step(dt, growth, self.weight_remainder);
        Ok(())
    }

    /// Makes `u = q/w` anew.
    #[inline(always)]
    pub(crate) fn revalue(self) {
        *self.value = self.strength.map(|q| S::saturated(q) / *self.weight);
    }
}
