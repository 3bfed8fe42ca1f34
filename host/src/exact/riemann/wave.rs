//! One wave of a Riemann problem: a shock or a fan into a uniform gas.

use super::GasState;

/// A uniform gas with a wave running to the left into it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gas {
    pub state: GasState,
    pub gamma: f64,
    pub sound_speed: f64,
}

/// A shock or fan running to the left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wave {
    pub gas: Gas,
    /// Behind the wave, at the contact or at the edge of the vacuum.
    pub inside: GasState,
    /// Speed of the front; of a shock.
    pub head: f64,
    /// Speed of the end; equal to `head` for a shock.
    pub tail: f64,
}

impl Gas {
    pub fn new(state: GasState, gamma: f64) -> Self {
        let sound_speed = (gamma * state.pressure / state.density).sqrt();
        Self {
            state,
            gamma,
            sound_speed,
        }
    }

    /// How much slower the gas is behind the wave if the pressure there is `p`,
    /// and the derivative by p: (4.6), (4.7), (4.37).
    pub fn f(&self, p: f64) -> (f64, f64) {
        let GasState {
            density, pressure, ..
        } = self.state;
        let (gamma, a) = (self.gamma, self.sound_speed);
        if p > pressure {
            let b = (gamma - 1.0) / (gamma + 1.0) * pressure;
            let root = (2.0 / ((gamma + 1.0) * density) / (p + b)).sqrt();
            let rise = p - pressure;
            (rise * root, root * (1.0 - 0.5 * rise / (p + b)))
        } else {
            let ratio = p / pressure;
            let z = 0.5 * (gamma - 1.0) / gamma;
            let f = 2.0 * a / (gamma - 1.0) * (libm::pow(ratio, z) - 1.0);
            (f, libm::pow(ratio, z - 1.0) / (density * a))
        }
    }

    /// The speed at which the gas expands into a vacuum: section 4.6.
    pub fn vacuum_edge(&self) -> f64 {
        self.state.velocity + 2.0 * self.sound_speed / (self.gamma - 1.0)
    }

    /// The wave behind which pressure and velocity are as given: section 4.5.
    pub fn wave(self, pressure: f64, velocity: f64) -> Wave {
        let (gamma, a, outside) = (self.gamma, self.sound_speed, self.state);
        let ratio = pressure / outside.pressure;
        let (density, head, tail) = if ratio > 1.0 {
            let m = (gamma - 1.0) / (gamma + 1.0);
            let density = outside.density * (ratio + m) / (m * ratio + 1.0);
            let mach = (0.5 * ((gamma + 1.0) * ratio + (gamma - 1.0)) / gamma).sqrt();
            let shock = outside.velocity - a * mach;
            (density, shock, shock)
        } else {
            let density = outside.density * libm::pow(ratio, 1.0 / gamma);
            let sound_speed = a * libm::pow(ratio, 0.5 * (gamma - 1.0) / gamma);
            (density, outside.velocity - a, velocity - sound_speed)
        };
        let inside = GasState {
            density,
            velocity,
            pressure,
        };
        Wave {
            gas: self,
            inside,
            head,
            tail,
        }
    }
}

impl Wave {
    /// The state at `xi`, left of the contact; inside a fan (4.56).
    pub fn sample(&self, xi: f64) -> GasState {
        if xi <= self.head {
            return self.gas.state;
        }
        if xi >= self.tail {
            return self.inside;
        }
        let (gamma, a, outside) = (self.gas.gamma, self.gas.sound_speed, self.gas.state);
        // Sound speed here / outside; rounding may take it below 0 beside a vacuum.
        let c = (2.0 + (gamma - 1.0) * (outside.velocity - xi) / a) / (gamma + 1.0);
        let c = c.max(0.0);
        GasState {
            density: outside.density * libm::pow(c, 2.0 / (gamma - 1.0)),
            velocity: xi + a * c,
            pressure: outside.pressure * libm::pow(c, 2.0 * gamma / (gamma - 1.0)),
        }
    }
}
