//! The cut-off of order 4 that the quintic spline gives.

use super::quintic_spline::third_derivative;
use super::{CutOff, QuinticSpline};
use crate::scalar::Number;

/// `z = ((D+2) z₆ + q z₆')/2`, `z₆` the shape of [`QuinticSpline`]: its second moments are 0.
///
/// One derivative less smooth than M6, three times continuously differentiable, and negative
/// near its edge: see [`Smooth`](super::Smooth), which keeps its smoothness.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct QuinticSplineFour;

impl CutOff for QuinticSplineFour {
    #[inline(always)]
    fn support(self) -> u32 {
        3
    }

    fn order(self) -> u32 {
        4
    }

    fn smoothness<const D: usize>(self) -> u32 {
        QuinticSpline.smoothness::<D>() - 1
    }

    fn normalisation<const D: usize>(self) -> f64 {
        QuinticSpline.normalisation::<D>()
    }

    #[inline(always)]
    fn value<const D: usize, N: Number>(self, q: N) -> N {
        let value = N::literal(0.5 * (D + 2) as f64) * QuinticSpline.value::<D, N>(q);
        let slope = q * QuinticSpline.gradient::<D, N>(q);
        value + N::literal(0.5) * (q * slope)
    }

    /// `F = ((D+3) F₆ + z₆'')/2`.
    #[inline(always)]
    fn gradient<const D: usize, N: Number>(self, q: N) -> N {
        let gradient = N::literal(0.5 * (D + 3) as f64) * QuinticSpline.gradient::<D, N>(q);
        gradient + N::literal(0.5) * QuinticSpline.curvature::<D, N>(q)
    }

    /// `z'' = ((D+4) z₆'' + q z₆''')/2`.
    #[inline(always)]
    fn curvature<const D: usize, N: Number>(self, q: N) -> N {
        let curvature = N::literal(0.5 * (D + 4) as f64) * QuinticSpline.curvature::<D, N>(q);
        curvature + N::literal(0.5) * (q * third_derivative(q))
    }
}
