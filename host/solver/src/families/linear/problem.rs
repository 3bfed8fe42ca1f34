//! The system of a plan in the scalar of a run.

use motes_core::equation::linear::systems::{
    Acoustics, ElasticWaves, LinearisedGas, Matrices, MaxwellTe, ShallowWater, Telegraph, Transport,
};
use motes_core::scalar::Scalar;

use crate::families::strengths::{Plan, RunField, row_sum};
use crate::scenario::linear::System;

impl Plan {
    /// The system of transport; `None` for another one, as of all below.
    pub fn transport<S: Scalar, const D: usize>(&self) -> Option<Transport<S, RunField<S, D>>> {
        let System::Transport {
            velocity,
            decay,
            source,
        } = &self.system
        else {
            return None;
        };
        Some(Transport {
            velocity: self.field.with(velocity, self.duration).run(),
            decay: S::from_f64(decay * self.unit_of_time()),
            source: S::from_f64(source * self.unit_of_time()),
        })
    }

    /// The system of acoustics.
    pub(in crate::families) fn acoustics<S: Scalar>(&self) -> Option<Acoustics<S>> {
        match self.system {
            System::Acoustics {
                density,
                sound_speed,
            } => Some(Acoustics::new(density, sound_speed, self.units)),
            _ => None,
        }
    }

    /// The telegraph line.
    pub(in crate::families) fn telegraph<S: Scalar>(&self) -> Option<Telegraph<S>> {
        match self.system {
            System::Telegraph {
                inductance,
                capacitance,
                resistance,
                conductance,
            } => Some(Telegraph::new(
                [capacitance, inductance],
                [conductance, resistance],
                self.units,
            )),
            _ => None,
        }
    }

    /// Linear shallow water.
    pub(in crate::families) fn shallow_water<S: Scalar>(&self) -> Option<ShallowWater<S>> {
        match self.system {
            System::ShallowWater {
                gravity,
                depth,
                coriolis,
            } => Some(ShallowWater::new(gravity, depth, coriolis, self.units)),
            _ => None,
        }
    }

    /// Maxwell's equations.
    pub(in crate::families) fn maxwell<S: Scalar>(&self) -> Option<MaxwellTe<S>> {
        match self.system {
            System::MaxwellTe {
                permittivity,
                permeability,
            } => Some(MaxwellTe::new(permittivity, permeability, self.units)),
            _ => None,
        }
    }

    /// Elastic waves.
    pub(in crate::families) fn elastic_waves<S: Scalar>(&self) -> Option<ElasticWaves<S>> {
        match self.system {
            System::ElasticWaves {
                density,
                lambda,
                mu,
            } => Some(ElasticWaves::new(density, [lambda, mu], self.units)),
            _ => None,
        }
    }

    /// The linearised gas.
    pub(in crate::families) fn linearised_gas<S: Scalar, const D: usize>(
        &self,
    ) -> Option<LinearisedGas<S, D>> {
        match &self.system {
            System::LinearisedGas {
                density,
                pressure,
                gamma,
                velocity,
            } => Some(LinearisedGas::new(
                *density,
                (gamma * pressure / density).sqrt(),
                std::array::from_fn(|i| velocity[i]),
                self.units,
            )),
            _ => None,
        }
    }

    /// A system given by its matrices, with zeros beyond their size.
    pub fn matrices<S: Scalar, const D: usize, const P: usize>(&self) -> Option<Matrices<S, D, P>> {
        let System::Matrices {
            components,
            flux,
            decay,
            ..
        } = &self.system
        else {
            return None;
        };
        let symmetriser = self.symmetriser.as_ref()?;
        let square = |matrix: &[f64], factor: f64| -> [[S; P]; P] {
            std::array::from_fn(|i| {
                std::array::from_fn(|j| match i.max(j) < *components {
                    true => S::from_f64(factor * matrix[i * components + j]),
                    false => S::ZERO,
                })
            })
        };
        let time = self.unit_of_time();
        Some(Matrices {
            flux: std::array::from_fn(|i| square(&flux[i], 1.0 / self.units.velocity)),
            decay: square(decay, time),
            symmetriser: square(&symmetriser.matrix, 1.0),
            speed: S::from_f64(symmetriser.speed / self.units.velocity),
            damping: S::from_f64(time * row_sum(decay, *components)),
            growth: S::from_f64(time * symmetriser.growth(decay)),
        })
    }
}
