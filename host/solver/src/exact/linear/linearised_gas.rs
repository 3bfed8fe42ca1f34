//! Small disturbances of a gas in uniform motion, density rho, velocity U, pressure p:
//! `rho'_t + U.grad rho' + rho div v' = 0`, `v'_t + U.grad v' + grad p'/rho = 0`,
//! `p'_t + U.grad p' + gamma p div v' = 0`; `u = (rho', v'_1 .. v'_D, p')`.
//!
//! A plane wave of each kind, with n = k/|k| and m across it: L. S. G. Kovasznay, Journal of
//! the Aeronautical Sciences 20 (1953). `c^2 = gamma p/rho`.
//!
//! - sound: `rho' = A cos phi`, `v' = n c/rho rho'`, `p' = c^2 rho'`,
//!   `phi = k.x - (U.k + c |k|) t`
//! - entropy: `rho' = A cos(k.x - U.k t)`, v' = 0, p' = 0
//! - vorticity: `v' = A m cos(k.x - U.k t)`, rho' = 0, p' = 0; not in one dimension

#[cfg(test)]
mod tests;

use super::error::{SolutionError, check, dimension_up_to, finite, positive};
use super::plane_wave::{PlaneWave, dot};
use super::system::System;
use crate::exact::solution::{Solution, fill};

/// A gas and the waves in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearisedGasProblem {
    /// D, 1 to 3.
    pub dimension: usize,
    /// rho, > 0.
    pub density: f64,
    /// U; zeros beyond the dimension.
    pub velocity: [f64; 3],
    /// p, > 0.
    pub pressure: f64,
    /// Ratio of the specific heats, > 1.
    pub gamma: f64,
    /// k, and A, a density. It runs along k faster than the gas.
    pub sound: PlaneWave,
    /// k, and A, a density.
    pub entropy: PlaneWave,
    /// k, and A, a velocity along [`PlaneWave::across`].
    pub vorticity: PlaneWave,
}

/// The solution of [`LinearisedGasProblem`]: rho', the D components of v', and p'.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearisedGas {
    problem: LinearisedGasProblem,
    sound_speed: f64,
}

impl LinearisedGasProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range; vorticity in one dimension.
    pub fn solve(self) -> Result<LinearisedGas, SolutionError> {
        let d = self.dimension;
        let amplitude = self.vorticity.amplitude;
        let turns = d > 1 || amplitude == 0.0;
        check(&[
            dimension_up_to(d, 3),
            positive("density", self.density),
            positive("pressure", self.pressure),
            ("gamma", self.gamma, "> 1", self.gamma > 1.0),
            ("vorticity", amplitude, "0 in one dimension", turns),
        ])?;
        for (axis, value) in self.velocity.into_iter().enumerate() {
            let holds = axis < d || value == 0.0;
            let need = "zero beyond the dimension";
            check(&[finite("velocity", value), ("velocity", value, need, holds)])?;
        }
        let names = ["wave_vector of sound", "amplitude of sound"];
        check(&self.sound.numbers(names, d))?;
        let names = ["wave_vector of entropy", "amplitude of entropy"];
        check(&self.entropy.numbers(names, d))?;
        let names = ["wave_vector of vorticity", "amplitude of vorticity"];
        check(&self.vorticity.numbers(names, d))?;
        Ok(LinearisedGas {
            problem: self,
            sound_speed: (self.gamma * self.pressure / self.density).sqrt(),
        })
    }
}

impl LinearisedGas {
    /// c.
    pub fn sound_speed(&self) -> f64 {
        self.sound_speed
    }

    /// The equations it solves.
    pub fn system(&self) -> System {
        let LinearisedGasProblem {
            dimension,
            density,
            velocity,
            pressure,
            gamma,
            ..
        } = self.problem;
        let last = 1 + dimension;
        (0..dimension).fold(System::zero(dimension, dimension + 2), |system, axis| {
            let carried = (0..=last).fold(system, |system, component| {
                system.flux(axis, [component, component], velocity[axis])
            });
            carried
                .flux(axis, [0, 1 + axis], density)
                .flux(axis, [1 + axis, last], 1.0 / density)
                .flux(axis, [last, 1 + axis], gamma * pressure)
        })
    }

    /// A wave that runs along its k at a speed over the gas.
    fn value(&self, wave: &PlaneWave, speed: f64, position: [f64; 3], time: f64) -> f64 {
        let carried = dot(self.problem.velocity, wave.wave_vector);
        let frequency = carried + speed * wave.wave_number();
        wave.amplitude * libm::cos(wave.phase(position, frequency, time))
    }
}

impl Solution for LinearisedGas {
    fn components(&self) -> usize {
        self.problem.dimension + 2
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let LinearisedGasProblem {
            dimension,
            density,
            sound,
            entropy,
            vorticity,
            ..
        } = self.problem;
        let c = self.sound_speed;
        let loud = self.value(&sound, c, position, time);
        let hot = self.value(&entropy, 0.0, position, time);
        let turning = self.value(&vorticity, 0.0, position, time);
        let (along, across) = (sound.direction(), vorticity.across());
        let mut values = [0.0; 5];
        values[0] = loud + hot;
        for axis in 0..dimension {
            values[1 + axis] = along[axis] * (c / density * loud) + across[axis] * turning;
        }
        values[1 + dimension] = c * c * loud;
        fill(state, &values);
    }
}
