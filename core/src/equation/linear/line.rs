//! A line of particles in one dimension: its first state and its solver, from plain numbers.
//!
//! A device sets up its run with this code, and a server makes the same of the same numbers, so
//! that equal numbers give equal bits.

use crate::cutoff::CutOff;
use crate::domain::{Axis, Domain, Side};
use crate::scalar::Scalar;

use super::dynamics::LinearDynamics;
use super::system::FirstOrderSystem;
use crate::cloud::Particle;
use crate::cloud::VelocityField;

/// A cloud of `P` components on a line in solver units, every number an `f64` that the run's
/// scalar rounds once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<'a, const P: usize> {
    /// The domain is from minus this to plus this.
    pub half_length: f64,
    /// What is at its ends.
    pub sides: [Side; 2],
    /// The particles at the start.
    pub cloud: &'a [Particle<f64, 1, P>],
    /// ε.
    pub epsilon: f64,
    /// Factor of the stable time step, in (0, 1].
    pub courant: f64,
    /// The time step, where it is given: at most the stable one.
    pub step: Option<f64>,
    /// Duration.
    pub end: f64,
}

impl<const P: usize> Line<'_, P> {
    /// The solver, with the cut-off, the equations and the motion of the caller's choice.
    pub fn dynamics<S, C, F, A>(
        &self,
        cut_off: C,
        system: F,
        field: A,
    ) -> LinearDynamics<S, C, F, A, 1, P>
    where
        S: Scalar,
        C: CutOff,
        F: FirstOrderSystem<S, 1, P>,
        A: VelocityField<S, 1>,
    {
        let domain = Domain {
            axes: [Axis {
                lower: S::from_f64(-self.half_length),
                upper: S::from_f64(self.half_length),
                sides: self.sides,
            }],
        };
        let width = (cut_off, S::from_f64(self.epsilon));
        LinearDynamics::new(domain, width, system, field, S::from_f64(self.courant))
    }

    /// The particles of the first state, rounded to the scalar.
    pub fn particles<S: Scalar>(&self) -> impl Iterator<Item = Particle<S, 1, P>> {
        self.cloud.iter().map(Particle::rounded)
    }

    /// The time step, where it is given.
    pub fn step<S: Scalar>(&self) -> Option<S> {
        self.step.map(S::from_f64)
    }

    /// The duration of the run.
    pub fn duration<S: Scalar>(&self) -> S {
        S::from_f64(self.end)
    }
}
