//! Transport of a scalar.

use super::super::system::FirstOrderSystem;
use crate::cloud::Place;
use crate::cloud::VelocityField;
use crate::pairs::Nothing;
use crate::scalar::{Number, Scalar};

/// `∂u/∂t + div(v u) + λ u = s`.
///
/// On particles that follow `v` there is nothing between particles (2.2), and `u_k` has the error
/// of the time integrator alone. On particles that follow anything else `B^i = (v^i - a^i)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transport<S, V> {
    /// `v`.
    pub velocity: V,
    /// `λ`.
    pub decay: S,
    /// `s`.
    pub source: S,
}

impl<S: Scalar, V: VelocityField<S, D>, const D: usize> FirstOrderSystem<S, D, 1>
    for Transport<S, V>
{
    type Medium = Nothing;
    const IS_UNIFORM: bool = true;
    const IS_COUPLED: bool = false;

    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        self.velocity.velocity(place)
    }
    fn medium(&self, _: &Place<S, D>) -> Nothing {
        Nothing
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(&self, _: &Nothing, _: &[N; D], _: &[N; 1]) -> [N; 1] {
        [N::zero()]
    }
    fn decay(&self, _: &Place<S, D>, u: &[S; 1]) -> [S; 1] {
        u.map(|u| self.decay * u)
    }
    fn source(&self, _: &Place<S, D>) -> [S; 1] {
        [self.source]
    }
    fn speed(&self, _: &Nothing) -> S {
        S::ZERO
    }
    fn damping(&self) -> S {
        self.decay.abs()
    }
    fn growth(&self) -> S {
        self.velocity.convergence().half() - self.decay
    }
}
