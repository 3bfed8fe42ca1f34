//! Watching that a run does not grow faster than any solution may.

use motes_core::cloud::Words;
use motes_core::error::Error;

use crate::run::RunError;

/// The part of the first norm below which nothing is said: what is left of a solution that has
/// died away may be rounding.
const FLOOR: f64 = 1e-3;

/// The bound of the energy norm, carried along with a run: `‖u‖' <= λ ‖u‖ + ‖f‖`; infinite where
/// there is none.
pub(super) struct Monitor {
    rate: Option<f64>,
    order: u32,
    margin: f64,
    floor: f64,
    bound: f64,
}

impl Monitor {
    /// A monitor of a system that grows at most at `rate`, stepped by a method of that order;
    /// `margin`: the part of the bound that a run may exceed it by.
    pub fn new(rate: Option<f64>, order: u32, margin: f64, norm: f64) -> Self {
        Self {
            rate,
            order,
            margin,
            floor: FLOOR * norm,
            bound: match rate {
                Some(_) => norm,
                None => f64::INFINITY,
            },
        }
    }

    /// What no solution exceeds; infinite where nothing bounds them.
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// Passes the bound.
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        words.scalar(&mut self.bound)
    }

    /// Moves the bound on by a step in which `‖f‖` is `source`.
    ///
    /// # Errors
    /// A norm beyond it, or that is no number, also where there is no bound.
    pub fn step(&mut self, time: f64, dt: f64, source: f64, norm: f64) -> Result<(), RunError> {
        if !norm.is_finite() {
            return Err(RunError::Lost { time });
        }
        let Some(rate) = self.rate else {
            return Ok(());
        };
        // A stable method of order p makes `Σ_(j<=p) z^j/j!` of `e^z`: more where losses are stiff.
        let z = rate * dt;
        let (mut term, mut made) = (1.0, 1.0);
        for j in 1..=self.order {
            term *= z / f64::from(j);
            made += term;
        }
        let factor = libm::exp(z).max(made.abs());
        self.bound = factor.max(1.0) * dt * source + factor * self.bound;
        let most = (1.0 + self.margin) * self.bound + self.floor;
        if norm <= most {
            return Ok(());
        }
        Err(RunError::Growth {
            time,
            norm,
            bound: self.bound,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_norm_that_follows_its_bound_passes_and_one_that_leaves_it_does_not() {
        let mut monitor = Monitor::new(Some(0.5), 4, 0.1, 2.0);
        let norm = |t: f64| 2.0 * libm::exp(0.5 * t);
        for i in 1..=10 {
            let t = 0.1 * f64::from(i);
            assert!(monitor.step(t, 0.1, 0.0, 1.09 * norm(t)).is_ok());
        }
        assert!((monitor.bound() / norm(1.0) - 1.0).abs() < 1e-12);
        let error = monitor.step(1.1, 0.1, 0.0, 1.2 * norm(1.1));
        assert!(error.unwrap_err().to_string().contains("no solution grows"));
    }

    /// Stiff losses in a stable step: RK4 leaves 0.28 where the solution has 0.25.
    #[test]
    fn losses_that_a_step_resolves_badly_are_no_growth() {
        let mut monitor = Monitor::new(Some(-300.0), 4, 0.01, 1.0);
        assert!(monitor.step(0.0, 1.39 / 300.0, 0.0, 0.2848).is_ok());
        assert!(monitor.step(0.0, 1.39 / 300.0, 0.0, 0.2848).is_err());
    }

    /// What has overflowed is not below its bound.
    #[test]
    fn a_norm_that_is_no_number_stops_the_run() {
        let mut monitor = Monitor::new(Some(0.0), 4, 0.1, 1.0);
        assert!(monitor.step(1.0, 1.0, 0.0, f64::NAN).is_err());
        assert!(monitor.step(1.0, 1.0, 0.0, f64::INFINITY).is_err());
        let mut unbounded = Monitor::new(None, 2, 0.1, 1.0);
        assert!(unbounded.step(1.0, 1.0, 0.0, 1e300).is_ok());
        let error = unbounded.step(1.0, 1.0, 0.0, f64::NAN).unwrap_err();
        assert!(error.to_string().contains("t = 1.0 the energy norm is no"));
    }

    #[test]
    fn a_source_raises_the_bound_by_its_norm() {
        let mut monitor = Monitor::new(Some(0.0), 4, 0.1, 1.0);
        for i in 1..=10 {
            let t = f64::from(i);
            assert!(monitor.step(t, 1.0, 3.0, 1.0 + 3.0 * t).is_ok());
        }
        assert!(monitor.step(11.0, 1.0, 0.0, 40.0).is_err());
    }
}
