//! A source that formulas give, beside what a system has itself.

use motes_core::cloud::Place;
use motes_core::domain::Wall;
use motes_core::equation::linear::FirstOrderSystem;
use motes_core::pairs::Fields;
use motes_core::scalar::{Number, Scalar};

use crate::families::strengths::{Frame, Plan, rounded};
use crate::scenario::formula::Formula;

/// A system and `f(x,t)` beside its own.
pub(in crate::families) struct Sourced<F> {
    system: F,
    source: Option<Source>,
}

/// One formula a component. What they compute is an `f64`, rounded once to the scalar.
struct Source {
    formulas: Vec<Formula>,
    frame: Frame,
}

impl<F> Sourced<F> {
    /// A system with the source of its plan.
    pub fn new(system: F, plan: &Plan) -> Self {
        let source = plan.source.as_ref().map(|formulas| Source {
            formulas: formulas.clone(),
            frame: plan.frame(),
        });
        Self { system, source }
    }
}

impl<S, F, const D: usize, const P: usize> FirstOrderSystem<S, D, P> for Sourced<F>
where
    S: Scalar,
    F: FirstOrderSystem<S, D, P>,
{
    type Medium = F::Medium;
    const IS_UNIFORM: bool = F::IS_UNIFORM;
    const IS_COUPLED: bool = F::IS_COUPLED;

    fn source(&self, place: &Place<S, D>) -> [S; P] {
        let mut rates = self.system.source(place);
        if let Some(source) = &self.source {
            let point = source.frame.point(place);
            for (rate, formula) in rates.iter_mut().zip(&source.formulas) {
                *rate += rounded(formula.at(&point) * source.frame.time());
            }
        }
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
