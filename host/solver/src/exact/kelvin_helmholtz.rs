//! The Kelvin-Helmholtz problem with smooth layers, in the periodic unit square: the initial
//! state and the amplitude of its mode. There is no exact solution.
//!
//! C. P. McNally, W. Lyra and J.-C. Passy, Astrophysical Journal Supplement 201 (2012) 18:
//! density (1), velocity (2), seed (3), amplitude (6) to (13). Density 1 outside and 2 between
//! y = 0.25 and 0.75, speed +-1/2, layers of thickness 0.025, `v_y = 0.01 sin(4 pi x)`,
//! pressure 2.5, gamma 5/3. Units are those of these numbers.

mod reference;
#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use super::flow::FlowState;
pub use reference::{GROWTH_RATE, REFERENCE, Reference};

/// Ratio of the specific heats.
pub const GAMMA: f64 = 5.0 / 3.0;

/// Everywhere at t = 0.
pub const PRESSURE: f64 = 2.5;

/// Thickness L of the layers.
const THICKNESS: f64 = 0.025;

/// Density and velocity along x of the outer gas and of that between the layers.
const OUTER: (f64, f64) = (1.0, 0.5);
const INNER: (f64, f64) = (2.0, -0.5);

/// The state at t = 0; periodic in x and y with period 1.
pub fn initial(position: [f64; 3]) -> FlowState {
    let [x, y, _] = position;
    let [x, y] = [x, y].map(|c| c - libm::floor(c));
    // Half of the step from a layer, on this side of it.
    let nearest = (y - 0.25).abs().min((y - 0.75).abs());
    let step = 0.5 * libm::exp(-nearest / THICKNESS);
    let inside = (0.25..0.75).contains(&y);
    let (here, there) = if inside {
        (INNER, OUTER)
    } else {
        (OUTER, INNER)
    };
    let between = |here: f64, there: f64| here + (there - here) * step;
    let (density, u) = (between(here.0, there.0), between(here.1, there.1));
    let v = 0.01 * libm::sin(4.0 * PI * x);
    FlowState::ideal(density, [u, v, 0.0], PRESSURE, GAMMA)
}

/// A part of the gas, of which the amplitude of the mode is a mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeSample {
    /// In the unit square.
    pub position: [f64; 2],
    /// Velocity along y.
    pub velocity_y: f64,
    /// Area: of a cell, or mass / density of a particle.
    pub volume: f64,
}

/// The amplitude of the seeded mode: (13),
///
/// `M = 2 ((sum s / sum d)^2 + (sum c / sum d)^2)^(1/2)`,
/// `(s, c) = v_y V e^(-4 pi |y' - 1/4|) (sin, cos)(4 pi x)`, `d = V e^(-4 pi |y' - 1/4|)`,
/// `y' = y` below 1/2 and `1 - y` above. None without samples.
pub fn mode_amplitude(samples: impl IntoIterator<Item = ModeSample>) -> Option<f64> {
    let (mut s, mut c, mut d) = (0.0, 0.0, 0.0);
    for sample in samples {
        let [x, y] = sample.position;
        let from_layer = if y < 0.5 { y - 0.25 } else { (1.0 - y) - 0.25 };
        let weight = sample.volume * libm::exp(-4.0 * PI * from_layer.abs());
        let (sine, cosine) = libm::sincos(4.0 * PI * x);
        s += sample.velocity_y * weight * sine;
        c += sample.velocity_y * weight * cosine;
        d += weight;
    }
    (d > 0.0).then(|| 2.0 * ((s / d) * (s / d) + (c / d) * (c / d)).sqrt())
}
