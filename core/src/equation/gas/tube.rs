//! A tube of gas in one dimension: its first state and its solver, from plain numbers.
//!
//! Server and device set up their runs with this one piece of code, so that equal numbers
//! give equal bits.

use super::state::Particle;
use super::{GasDynamics, Plain, Width};
use crate::domain::{Axis, Domain, Side};
use crate::error::Error;
use crate::material::IdealGas;
use crate::scalar::Scalar;

/// The smallest Ω that a tube accepts. Next to a jump of density it falls to about 0.4; at
/// 0 the density would not answer to ε at all.
const SMALLEST_OMEGA: f64 = 1.0 / 32.0;

/// A stretch of uniform gas, filled with particles of equal mass and spacing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Its lower end.
    pub lower: f64,
    /// Its upper end, > `lower`.
    pub upper: f64,
    /// How many particles it gets, > 0.
    pub particles: u32,
    /// The mass of each.
    pub mass: f64,
    /// Velocity.
    pub velocity: f64,
    /// Internal energy per mass.
    pub energy: f64,
}

impl Stretch {
    /// The particles, each in the middle of its part of the stretch, from the lower end up.
    /// `eta`: what ε is expected to be, in spacings.
    pub fn particles(self, eta: f64) -> impl Iterator<Item = Particle<f64, 1>> {
        let spacing = (self.upper - self.lower) / f64::from(self.particles);
        (0..self.particles).map(move |k| Particle {
            position: [self.lower + spacing * (f64::from(k) + 0.5)],
            velocity: [self.velocity],
            mass: self.mass,
            energy: self.energy,
            epsilon: eta * spacing,
            material: 0,
        })
    }
}

/// A tube in solver units, every number an `f64` that the run's scalar rounds once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube<'a> {
    /// The domain is from minus this to plus this.
    pub half_length: f64,
    /// What is at its ends.
    pub sides: [Side; 2],
    /// The gas at the start, from the lower end up.
    pub stretches: &'a [Stretch],
    /// Ratio of specific heats, > 1.
    pub gamma: f64,
    /// Width of the cut-off.
    pub width: Width<f64>,
    /// Factor of the time step, in (0, 1].
    pub courant: f64,
    /// Duration.
    pub end: f64,
}

impl Tube<'_> {
    /// The gas of the tube.
    pub fn material<S: Scalar>(&self) -> IdealGas<S> {
        IdealGas::new(self.gamma)
    }

    /// The solver, with the cut-off and viscosity of the caller's choice; `materials` is the
    /// [`Tube::material`], kept by the caller.
    pub fn solver<'m, S: Scalar, C, V>(
        &self,
        cut_off: C,
        viscosity: V,
        materials: &'m [IdealGas<S>; 1],
    ) -> GasDynamics<'m, S, C, V, IdealGas<S>, Plain<S, 1>, 1> {
        let half = S::from_f64(self.half_length);
        GasDynamics {
            domain: Domain {
                axes: [Axis {
                    lower: -half,
                    upper: half,
                    sides: self.sides,
                }],
            },
            cut_off,
            width: match self.width {
                Width::Constant { epsilon } => Width::Constant {
                    epsilon: S::from_f64(epsilon),
                },
                Width::Adaptive { eta, .. } => Width::adaptive(S::from_f64(eta)),
            },
            viscosity,
            materials,
            physics: Plain::DEFAULT,
            courant: S::from_f64(self.courant),
            smallest_omega: S::from_f64(SMALLEST_OMEGA),
        }
    }

    /// The particles of the first state: made in `f64`, then rounded to the scalar once.
    pub fn particles<S: Scalar>(&self) -> impl Iterator<Item = Particle<S, 1>> {
        let eta = match self.width {
            Width::Adaptive { eta, .. } => eta,
            Width::Constant { .. } => 1.0,
        };
        self.stretches
            .iter()
            .flat_map(move |stretch| stretch.particles(eta))
            .map(|particle| particle.rounded())
    }

    /// Puts the particles of the first state into a storage. Error: no room.
    pub fn fill<S: Scalar>(
        &self,
        mut push: impl FnMut(Particle<S, 1>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.particles().try_for_each(&mut push)
    }

    /// The duration of the run.
    pub fn duration<S: Scalar>(&self) -> S {
        S::from_f64(self.end)
    }
}
