//! A system with a source beside its own.

use super::system::FirstOrderSystem;
use crate::cloud::Place;
use crate::domain::Wall;
use crate::pairs::Fields;
use crate::scalar::{Number, Scalar};

/// `f(x,t)` that comes to that of a system: see [`Sourced`].
pub trait Addition<S: Scalar, const D: usize, const P: usize>: Sync {
    /// Adds it to the rates of all components.
    fn add(&self, place: &Place<S, D>, rates: &mut [S; P]);
}

impl<S, Q, const D: usize, const P: usize> Addition<S, D, P> for Option<Q>
where
    S: Scalar,
    Q: Addition<S, D, P>,
{
    fn add(&self, place: &Place<S, D>, rates: &mut [S; P]) {
        if let Some(source) = self {
            source.add(place, rates);
        }
    }
}

/// A system and `f(x,t)` beside its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sourced<F, Q> {
    /// The system.
    pub system: F,
    /// What comes to its source.
    pub source: Q,
}

impl<S, F, Q, const D: usize, const P: usize> FirstOrderSystem<S, D, P> for Sourced<F, Q>
where
    S: Scalar,
    F: FirstOrderSystem<S, D, P>,
    Q: Addition<S, D, P>,
{
    type Medium = F::Medium;
    const IS_UNIFORM: bool = F::IS_UNIFORM;
    const IS_COUPLED: bool = F::IS_COUPLED;

    fn source(&self, place: &Place<S, D>) -> [S; P] {
        let mut rates = self.system.source(place);
        self.source.add(place, &mut rates);
        rates
    }

    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        self.system.velocity(place)
    }
    fn medium(&self, place: &Place<S, D>) -> F::Medium {
        self.system.medium(place)
    }
    #[inline(always)]
    fn flux<N: Number<Scalar = S>>(
        &self,
        medium: &<F::Medium as Fields<S>>::Of<N>,
        n: &[N; D],
        u: &[N; P],
    ) -> [N; P] {
        self.system.flux(medium, n, u)
    }
    fn decay(&self, place: &Place<S, D>, u: &[S; P]) -> [S; P] {
        self.system.decay(place, u)
    }
    fn speed(&self, medium: &F::Medium) -> S {
        self.system.speed(medium)
    }
    fn damping(&self) -> S {
        self.system.damping()
    }
    fn symmetrised(&self, medium: &F::Medium, u: &[S; P]) -> [S; P] {
        self.system.symmetrised(medium, u)
    }
    fn growth(&self) -> S {
        self.system.growth()
    }
    fn reflected(&self, u: &[S; P], axis: usize) -> [S; P] {
        self.system.reflected(u, axis)
    }
    fn behind(&self, medium: &F::Medium, image: &[S; P], wall: &Wall<S>) -> [S; P] {
        self.system.behind(medium, image, wall)
    }
    fn reflected_medium(&self, medium: &F::Medium, axis: usize) -> F::Medium {
        self.system.reflected_medium(medium, axis)
    }
}
