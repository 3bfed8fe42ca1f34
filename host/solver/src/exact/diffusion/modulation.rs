//! A diffusivity that swings in time.

#[cfg(test)]
mod tests;

use super::super::linear::error::{Number, finite};

/// `b(t) = b_0 (1 + amplitude sin(rate t))`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Modulation {
    /// -1 to 1, so that b is never negative.
    pub amplitude: f64,
    /// Radians / time.
    pub rate: f64,
}

impl Modulation {
    /// `1 + amplitude sin(rate t)`.
    pub fn factor(&self, time: f64) -> f64 {
        1.0 + self.amplitude * libm::sin(self.rate * time)
    }

    /// `tau(t) = ∫_0^t (1 + amplitude sin(rate t')) dt' = t + amplitude (1 - cos(rate t))/rate`:
    /// the time that a constant `b_0` takes for the same.
    pub fn elapsed(&self, time: f64) -> f64 {
        // 1 - cos(2 h) = 2 sin(h)^2: without cancellation, and with a limit for rate = 0.
        let half = 0.5 * self.rate * time;
        let sine = libm::sin(half);
        let part = if half == 0.0 { 1.0 } else { sine / half };
        time * (1.0 + self.amplitude * sine * part)
    }

    /// What must hold.
    pub(super) fn numbers(&self) -> [Number; 2] {
        let holds = self.amplitude.abs() <= 1.0;
        [
            (
                "amplitude of the modulation",
                self.amplitude,
                "-1 to 1",
                holds,
            ),
            finite("rate of the modulation", self.rate),
        ]
    }
}

/// [`Modulation::elapsed`], and t without one.
pub(super) fn elapsed(modulation: Option<Modulation>, time: f64) -> f64 {
    modulation.map_or(time, |modulation| modulation.elapsed(time))
}
