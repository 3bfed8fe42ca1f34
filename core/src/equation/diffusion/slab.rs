//! A slab in one dimension: its first state, its problem and its solver, from plain numbers.
//!
//! A device sets up its run with this code, and a server makes the same of the same numbers, so
//! that equal numbers give equal bits.

use super::dynamics::{DiffusionDynamics, Form};
use super::lists::Lists;
use super::mean::Mean;
use super::named::NamedProblem;
use crate::cloud::{Particle, VelocityField};
use crate::cutoff::CutOff;
use crate::domain::{Axis, Domain, Side};
use crate::error::Error;
use crate::scalar::Scalar;

/// One species between two walls or on a ring, in solver units, every number an `f64` that the
/// run's scalar rounds once. For the direct form and the stabilised method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab<'a> {
    /// The domain is from minus this to plus this.
    pub half_length: f64,
    /// What is at its ends.
    pub sides: [Side; 2],
    /// Diffusivity, reaction and walls.
    pub problem: NamedProblem<'a, f64, 1, 1>,
    /// Of the diffusivities of two particles.
    pub mean: Mean,
    /// The particles at the start.
    pub cloud: &'a [Particle<f64, 1, 1>],
    /// ε.
    pub epsilon: f64,
    /// Factor of the stable time step, in (0, 1].
    pub courant: f64,
    /// For how many stages a step is made.
    pub stages: u32,
    /// The longest step that is made without being given.
    pub longest: f64,
    /// The time step, where it is given: at most the stable one.
    pub step: Option<f64>,
    /// Duration.
    pub end: f64,
}

impl Slab<'_> {
    /// The solver, with the cut-off and the motion of the caller's choice; its problem is
    /// [`Slab::problem`].
    pub fn dynamics<'m, S, C, A>(
        &self,
        cut_off: C,
        problem: NamedProblem<'m, S, 1, 1>,
        field: A,
    ) -> DiffusionDynamics<S, C, NamedProblem<'m, S, 1, 1>, A, 1, 1>
    where
        S: Scalar,
        C: CutOff,
        A: VelocityField<S, 1>,
    {
        DiffusionDynamics {
            domain: Domain {
                axes: [Axis {
                    lower: S::from_f64(-self.half_length),
                    upper: S::from_f64(self.half_length),
                    sides: self.sides,
                }],
            },
            cut_off,
            epsilon: S::from_f64(self.epsilon),
            problem,
            field,
            form: Form::Direct,
            mean: self.mean,
            courant: S::from_f64(self.courant),
        }
    }

    /// The problem, rounded to the scalar. Error: lists without room for it.
    pub fn problem<'m, S: Scalar, const POINTS: usize, const LAYERS: usize>(
        &self,
        lists: &'m mut Lists<S, POINTS, LAYERS>,
    ) -> Result<NamedProblem<'m, S, 1, 1>, Error> {
        self.problem.rounded(lists)
    }

    /// The particles of the first state, rounded to the scalar.
    pub fn particles<S: Scalar>(&self) -> impl Iterator<Item = Particle<S, 1, 1>> {
        self.cloud.iter().map(Particle::rounded)
    }

    /// The time step, where it is given.
    pub fn step<S: Scalar>(&self) -> Option<S> {
        self.step.map(S::from_f64)
    }

    /// The longest step that is made without being given.
    pub fn longest<S: Scalar>(&self) -> S {
        S::from_f64(self.longest)
    }

    /// The duration of the run.
    pub fn duration<S: Scalar>(&self) -> S {
        S::from_f64(self.end)
    }
}
