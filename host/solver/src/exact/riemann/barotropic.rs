//! One wave into an isothermal gas or a liquid after Tait: `p + B = K ρ^n`, the energy plays no part.
//!
//! With n = 1 and B = 0 the isothermal gas. Fans are those of the ideal gas with n for gamma and
//! `p + B` for p, and at n = 1 their limits; shocks keep mass and momentum, not the entropy (R. J.
//! LeVeque, Finite Volume Methods for Hyperbolic Problems, 2002, sections 13.7 and 13.8):
//!
//! `(u_0 - u)² = (p - p_0) (1/ρ_0 - 1/ρ)`.
//!
//! The energy that is kept account of follows from them: `de = p dρ/ρ²` in a fan, and `e - e_0 =
//! (p + p_0) (1/ρ_0 - 1/ρ)/2` across a shock, which keeps the total. It is 0 outside.

use super::state::{Front, GasState};

/// Barotropic matter with a wave running to the left into it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Barotropic {
    pub state: GasState,
    exponent: f64,
    /// `B`.
    stiffness: f64,
    /// `p - floor` outside.
    pub level: f64,
    /// Least pressure that both sides of the problem bear.
    floor: f64,
    /// `p + B` outside.
    total: f64,
    sound_speed: f64,
}

impl Barotropic {
    pub fn new(state: GasState, exponent: f64, stiffness: f64, floor: f64) -> Self {
        let total = state.pressure + stiffness;
        Self {
            state,
            exponent,
            stiffness,
            level: state.pressure - floor,
            floor,
            total,
            sound_speed: (exponent * total / state.density).sqrt(),
        }
    }

    fn total(&self, level: f64) -> f64 {
        level + (self.floor + self.stiffness)
    }

    /// `ln (ρ/ρ_0)` where the pressure is `floor + level`; near 0 without cancellation.
    fn compression(&self, level: f64) -> f64 {
        let rise = (level - self.level) / self.total;
        let logarithm = match rise.abs() < 0.5 {
            true => libm::log1p(rise),
            // Near a vacuum the rise is -1 but for what matters.
            false => libm::log(self.total(level) / self.total),
        };
        logarithm / self.exponent
    }

    /// How much slower the matter is behind the wave if the pressure there is `floor + level`, and
    /// the derivative by it.
    pub fn f(&self, level: f64) -> (f64, f64) {
        let (n, a, density) = (self.exponent, self.sound_speed, self.state.density);
        let compression = self.compression(level);
        let rise = level - self.level;
        if rise > 0.0 {
            // 1 - ρ_0/ρ, and its derivative.
            let part = -libm::expm1(-compression);
            let slope = libm::exp(-compression) / (n * self.total(level));
            let f = (rise * part / density).sqrt();
            return (f, (part + rise * slope) / (2.0 * density * f));
        }
        // a ((ρ/ρ_0)^z - 1)/z with z = (n-1)/2, a ln (ρ/ρ_0) at 0.
        let z = 0.5 * (n - 1.0);
        let f = match z > 0.0 {
            true => a * libm::expm1(z * compression) / z,
            false => a * compression,
        };
        // c/(n (p + B)), c the sound speed behind.
        let sound_speed = a * libm::exp(z * compression);
        (f, sound_speed / (n * self.total(level)))
    }

    /// The speed beside a vacuum; infinite where no vacuum can open.
    pub fn vacuum_edge(&self) -> f64 {
        self.state.velocity - self.f(0.0).0
    }

    /// The wave behind which the pressure is `floor + level` and the velocity as given.
    pub fn front(&self, level: f64, velocity: f64) -> Front {
        let (a, outside) = (self.sound_speed, self.state);
        let compression = self.compression(level);
        let rise = level - self.level;
        let (head, tail) = if rise > 0.0 {
            // The flux of mass is the rise over what the matter loses in speed.
            let shock = outside.velocity - rise / (self.f(level).0 * outside.density);
            (shock, shock)
        } else {
            let sound_speed = a * libm::exp(0.5 * (self.exponent - 1.0) * compression);
            (outside.velocity - a, velocity - sound_speed)
        };
        Front {
            inside: GasState {
                density: outside.density * libm::exp(compression),
                velocity,
                pressure: self.floor + level,
            },
            head,
            tail,
        }
    }

    /// The state at `xi` in a fan.
    pub fn fan(&self, xi: f64) -> GasState {
        let (n, a, outside) = (self.exponent, self.sound_speed, self.state);
        // Sound speed here / outside; rounding may take it below 0 beside a vacuum.
        let c = (2.0 + (n - 1.0) * (outside.velocity - xi) / a) / (n + 1.0);
        let c = c.max(0.0);
        let compression = match n > 1.0 {
            true => 2.0 / (n - 1.0) * libm::log(c),
            false => (outside.velocity - xi) / a - 1.0,
        };
        GasState {
            density: outside.density * libm::exp(compression),
            velocity: xi + a * c,
            pressure: self.total * libm::exp(n * compression) - self.stiffness,
        }
    }

    /// The internal energy per mass of a state behind a shock or in a fan.
    pub fn internal_energy(&self, state: GasState, is_shock: bool) -> f64 {
        let (n, outside) = (self.exponent, self.state);
        let expansion = 1.0 / state.density - 1.0 / outside.density;
        if is_shock {
            return -0.5 * (state.pressure + outside.pressure) * expansion;
        }
        let compression = libm::log(state.density / outside.density);
        let specific = self.total / outside.density;
        let compressed = match n > 1.0 {
            true => specific * libm::expm1((n - 1.0) * compression) / (n - 1.0),
            false => specific * compression,
        };
        compressed + self.stiffness * expansion
    }
}
