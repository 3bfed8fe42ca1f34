//! One wave of a Riemann problem: a shock or a fan into a uniform gas.
//!
//! Powers are std's, not libm's as in the other solutions: `embedded/src/tube.rs` holds their
//! bits. The states outside the waves, all that there is at t = 0, need none.

use super::state::{Front, GasState};

/// A uniform gas with a wave running to the left into it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gas {
    pub state: GasState,
    pub gamma: f64,
    pub pressure_at_infinity: f64,
    /// `p - floor` outside.
    pub level: f64,
    /// Least pressure that both gases of the problem bear: minus the lower p_inf.
    floor: f64,
    /// `p_inf + floor`: what the level lacks to `p + p_inf`.
    stiffness: f64,
    /// `p + p_inf` outside.
    total: f64,
    sound_speed: f64,
}

impl Gas {
    pub fn new(state: GasState, gamma: f64, pressure_at_infinity: f64, floor: f64) -> Self {
        let level = state.pressure - floor;
        let stiffness = pressure_at_infinity + floor;
        let total = level + stiffness;
        Self {
            state,
            gamma,
            pressure_at_infinity,
            level,
            floor,
            stiffness,
            total,
            sound_speed: (gamma * total / state.density).sqrt(),
        }
    }

    /// How much slower the gas is behind the wave if the pressure there is `floor + level`,
    /// and the derivative by it: (4.6), (4.7), (4.37).
    pub fn f(&self, level: f64) -> (f64, f64) {
        let density = self.state.density;
        let total = level + self.stiffness;
        let (gamma, a) = (self.gamma, self.sound_speed);
        if level > self.level {
            let b = (gamma - 1.0) / (gamma + 1.0) * self.total;
            let root = (2.0 / ((gamma + 1.0) * density) / (total + b)).sqrt();
            let rise = level - self.level;
            (rise * root, root * (1.0 - 0.5 * rise / (total + b)))
        } else {
            let ratio = total / self.total;
            let z = 0.5 * (gamma - 1.0) / gamma;
            let f = 2.0 * a / (gamma - 1.0) * (ratio.powf(z) - 1.0);
            (f, ratio.powf(z - 1.0) / (density * a))
        }
    }

    /// The speed of the gas, or of its surface if it is stiffer than the other, beside a
    /// vacuum: section 4.6.
    pub fn vacuum_edge(&self) -> f64 {
        self.state.velocity - self.f(0.0).0
    }

    /// The wave behind which the pressure is `floor + level` and the velocity as given:
    /// section 4.5.
    pub fn front(&self, level: f64, velocity: f64) -> Front {
        let (gamma, a, outside) = (self.gamma, self.sound_speed, self.state);
        let ratio = (level + self.stiffness) / self.total;
        let (density, head, tail) = if ratio > 1.0 {
            let m = (gamma - 1.0) / (gamma + 1.0);
            let density = outside.density * (ratio + m) / (m * ratio + 1.0);
            let mach = (0.5 * ((gamma + 1.0) * ratio + (gamma - 1.0)) / gamma).sqrt();
            let shock = outside.velocity - a * mach;
            (density, shock, shock)
        } else {
            let density = outside.density * ratio.powf(1.0 / gamma);
            let sound_speed = a * ratio.powf(0.5 * (gamma - 1.0) / gamma);
            (density, outside.velocity - a, velocity - sound_speed)
        };
        let inside = GasState {
            density,
            velocity,
            pressure: self.floor + level,
        };
        Front { inside, head, tail }
    }

    /// The state at `xi` in a fan (4.56).
    pub fn fan(&self, xi: f64) -> GasState {
        let (gamma, a, outside) = (self.gamma, self.sound_speed, self.state);
        // Sound speed here / outside; rounding may take it below 0 beside a vacuum.
        let c = (2.0 + (gamma - 1.0) * (outside.velocity - xi) / a) / (gamma + 1.0);
        let c = c.max(0.0);
        let total = self.total * c.powf(2.0 * gamma / (gamma - 1.0));
        GasState {
            density: outside.density * c.powf(2.0 / (gamma - 1.0)),
            velocity: xi + a * c,
            pressure: total - self.pressure_at_infinity,
        }
    }
}
