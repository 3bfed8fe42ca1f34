//! A source that formulas give, beside what a system has itself.

use motes_core::cloud::{Frame, Place};
use motes_core::equation::linear::Addition;
use motes_core::scalar::Scalar;

use crate::families::strengths::Plan;
use crate::scenario::formula::Formula;

/// One formula a component. What they compute is an `f64`, rounded once to the scalar.
pub(in crate::families) struct SourceFormulas {
    formulas: Vec<Formula>,
    frame: Frame,
}

impl SourceFormulas {
    /// Those of a plan, if it has any.
    pub fn of(plan: &Plan) -> Option<Self> {
        let formulas = plan.source.as_ref()?;
        Some(Self {
            formulas: formulas.clone(),
            frame: plan.frame(),
        })
    }
}

impl<S: Scalar, const D: usize, const P: usize> Addition<S, D, P> for SourceFormulas {
    fn add(&self, place: &Place<S, D>, rates: &mut [S; P]) {
        let point = self.frame.point(place);
        for (rate, formula) in rates.iter_mut().zip(&self.formulas) {
            *rate += self.frame.rate::<S>(formula.at(&point));
        }
    }
}
