//! Flow of a viscous gas between two parallel walls that it sticks to, from a uniform start.
//!
//! The velocity along the walls, one component of it, obeys `∂u/∂t = ν ∂²u/∂y² + a`, `u(0) = u_0`,
//! `u(h) = u_1`. With `s = u_0 + (u_1 - u_0) y/h + a y (h - y)/(2 ν)`, the steady flow of Couette and
//! Poiseuille, and `k_n = n π/h`,
//!
//! `u = s + 2/h Σ_n [(u_s - u_0) (1 - (-1)^n)/k_n + (u_1 - u_0) (-1)^n/k_n - a/ν (1 - (-1)^n)/k_n³]
//! exp(-ν k_n² t) sin(k_n y)`,
//!
//! `u_s` the velocity at the start; Batchelor, An Introduction to Fluid Dynamics, 1967, section 4.3. Density
//! and pressure stay uniform. Heat is left out: the flow is that of a gas far below the speed of sound.

#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use super::flow::{Flow, FlowError, FlowState, check};

/// Flow between two walls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChannelProblem {
    /// The direction across the walls.
    pub axis: usize,
    /// Where they are.
    pub walls: [f64; 2],
    /// How they move.
    pub velocities: [[f64; 3]; 2],
    /// Of the gas, > 0.
    pub viscosity: f64,
    /// What acts on it.
    pub acceleration: [f64; 3],
    /// The gas at the start.
    pub start: FlowState,
}

/// The flow of [`ChannelProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChannelFlow(ChannelProblem);

/// The most terms of a sum: the first time steps of a run take some hundred.
const TERMS: u32 = 20_000;

impl ChannelProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<ChannelFlow, FlowError> {
        let height = self.walls[1] - self.walls[0];
        check(&[
            ("viscosity", self.viscosity, "> 0", self.viscosity > 0.0),
            ("the distance of the walls", height, "> 0", height > 0.0),
        ])?;
        Ok(ChannelFlow(self))
    }
}

impl ChannelFlow {
    /// A component of the velocity at a distance from the lower wall.
    fn velocity(&self, i: usize, y: f64, time: f64) -> f64 {
        let of = &self.0;
        if i == of.axis {
            return 0.0;
        }
        let height = of.walls[1] - of.walls[0];
        let [lower, upper] = of.velocities.map(|velocity| velocity[i]);
        let (start, pull) = (of.start.velocity[i], of.acceleration[i] / of.viscosity);
        if time <= 0.0 {
            return start;
        }
        let mut sum = lower + (upper - lower) * y / height + 0.5 * pull * y * (height - y);
        for n in 1..TERMS {
            let k = f64::from(n) * PI / height;
            let decay = libm::exp(-of.viscosity * k * k * time);
            if decay < 1e-18 {
                break;
            }
            let (even, odd) = if n % 2 == 0 { (1.0, 0.0) } else { (-1.0, 2.0) };
            let term = (start - lower) * odd + (upper - lower) * even - pull * odd / (k * k);
            sum += 2.0 * term / (k * height) * decay * libm::sin(k * y);
        }
        sum
    }
}

impl Flow for ChannelFlow {
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let y = position[self.0.axis] - self.0.walls[0];
        FlowState {
            velocity: std::array::from_fn(|i| self.velocity(i, y, time)),
            ..self.0.start
        }
    }
}
