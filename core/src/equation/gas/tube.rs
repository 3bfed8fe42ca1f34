//! A tube of gas in one dimension: its first state and its solver, from plain numbers.
//!
//! Server and device set up their runs with this one piece of code, so that equal numbers
//! give equal bits.

use super::state::Particle;
use super::{GasDynamics, Width};
use crate::domain::{Axis, Domain, Side};
use crate::material::IdealGas;
use crate::scalar::Scalar;

/// The smallest Ω that a tube accepts. Next to a jump of density it falls to about 0.4; at
/// 0 the density would not answer to ε at all.
const SMALLEST_OMEGA: f64 = 1.0 / 32.0;

/// A stretch of uniform gas, filled with particles of equal mass and spacing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch<S> {
    /// Its lower end.
    pub lower: S,
    /// Its upper end, > `lower`.
    pub upper: S,
    /// How many particles it gets, > 0.
    pub particles: u32,
    /// The mass of each.
    pub mass: S,
    /// Velocity.
    pub velocity: S,
    /// Internal energy per mass.
    pub energy: S,
}

impl<S: Scalar> Stretch<S> {
    /// The particles, each in the middle of its part of the stretch, from the lower end up.
    /// `eta`: what ε is expected to be, in spacings.
    pub fn particles(self, eta: S) -> impl Iterator<Item = Particle<S, 1>> {
        let spacing = (self.upper - self.lower) / S::count(self.particles);
        (0..self.particles).map(move |k| Particle {
            position: [self.lower + (spacing * S::count(k) + spacing.half())],
            velocity: [self.velocity],
            mass: self.mass,
            energy: self.energy,
            epsilon: eta * spacing,
        })
    }
}

impl Stretch<f64> {
    /// The stretch in the scalar of a run.
    fn rounded<S: Scalar>(&self) -> Stretch<S> {
        Stretch {
            lower: S::from_f64(self.lower),
            upper: S::from_f64(self.upper),
            particles: self.particles,
            mass: S::from_f64(self.mass),
            velocity: S::from_f64(self.velocity),
            energy: S::from_f64(self.energy),
        }
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
    pub stretches: &'a [Stretch<f64>],
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
    /// The solver, with the cut-off and viscosity of the caller's choice.
    pub fn solver<S: Scalar, C, V>(
        &self,
        cut_off: C,
        viscosity: V,
    ) -> GasDynamics<S, C, V, IdealGas<S>, 1> {
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
                Width::Adaptive { eta } => Width::Adaptive {
                    eta: S::from_f64(eta),
                },
            },
            viscosity,
            equation_of_state: IdealGas::new(self.gamma),
            courant: S::from_f64(self.courant),
            smallest_omega: S::from_f64(SMALLEST_OMEGA),
        }
    }

    /// The particles of the first state.
    pub fn particles<S: Scalar>(&self) -> impl Iterator<Item = Particle<S, 1>> {
        let eta = match self.width {
            Width::Adaptive { eta } => S::from_f64(eta),
            Width::Constant { .. } => S::ONE,
        };
        self.stretches
            .iter()
            .flat_map(move |stretch| stretch.rounded().particles(eta))
    }

    /// The duration of the run.
    pub fn duration<S: Scalar>(&self) -> S {
        S::from_f64(self.end)
    }
}
