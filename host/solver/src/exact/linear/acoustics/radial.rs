//! A Gaussian of pressure released at rest in the plane: rings that run outwards.
//!
//! With r the distance from the centre and w the width, the Hankel transform of
//! `p(r, 0) = A exp(-r^2/w^2)` is `A w^2/2 exp(-k^2 w^2/4)`, and every k oscillates by itself:
//!
//! - `p = A/2 ∫_0^inf s e^(-s^2/4) cos(s tau) J_0(s rho) ds`
//! - `v_r = A/(2 rho_0 c) ∫_0^inf s e^(-s^2/4) sin(s tau) J_1(s rho) ds`
//!
//! where `s = k w`, `tau = c t/w`, `rho = r/w`. G. B. Whitham, Linear and Nonlinear Waves, 1974,
//! section 7.4. The integrals are taken by Gauss and Legendre's rule of 16 points on panels
//! short enough for the oscillations: error below 1e-14 A, at a cost proportional to
//! `tau + rho + 2`, 14 evaluations of both Bessel functions for each.

mod quadrature;

use super::super::error::{SolutionError, check, finite, positive};
use super::super::system::System;
use super::Medium;
use crate::exact::solution::{Solution, fill};
use quadrature::{RULE, gauss_legendre};

/// A pulse in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadialPulseProblem {
    /// What it runs through.
    pub medium: Medium,
    /// Where the pressure is largest at t = 0.
    pub center: [f64; 2],
    /// w, > 0.
    pub width: f64,
    /// A, the largest pressure.
    pub amplitude: f64,
}

/// The solution of [`RadialPulseProblem`]: p, v_x and v_y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadialPulse {
    problem: RadialPulseProblem,
    rule: [(f64, f64); RULE],
}

/// Where the integrals end: `e^(-12^2/4) = 2e-16` is left of p.
const END: f64 = 12.0;

/// Half a panel times the fastest oscillation, `tau + rho`, and 2 for the Gaussian: the error
/// of the rule is `3e-45 HALF^32 = 3e-18`.
const HALF: f64 = 7.0;

/// Widths ahead of the ring beyond which there is nothing: `exp(-6.5^2) = 4e-19`.
const AHEAD: f64 = 6.5;

impl RadialPulseProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<RadialPulse, SolutionError> {
        check(&self.medium.numbers())?;
        check(&[
            finite("center", self.center[0]),
            finite("center", self.center[1]),
            positive("width", self.width),
            finite("amplitude", self.amplitude),
        ])?;
        Ok(RadialPulse {
            problem: self,
            rule: gauss_legendre(),
        })
    }
}

impl RadialPulse {
    /// The equations it solves.
    pub fn system(&self) -> System {
        self.problem.medium.system(2)
    }

    /// Both integrals, halved, with panels as short as `half` says.
    pub(super) fn integrals(&self, rho: f64, tau: f64, half: f64) -> [f64; 2] {
        if rho - tau.abs() > AHEAD {
            return [0.0; 2];
        }
        let panels = libm::ceil(0.5 * END * (rho + tau.abs() + 2.0) / half) as usize;
        let reach = 0.5 * END / panels as f64;
        let [mut pressure, mut velocity] = [0.0; 2];
        for panel in 0..panels {
            let middle = (2 * panel + 1) as f64 * reach;
            for (node, weight) in self.rule {
                let s = middle + reach * node;
                let part = weight * s * libm::exp(-0.25 * s * s);
                pressure += part * libm::cos(s * tau) * libm::j0(s * rho);
                velocity += part * libm::sin(s * tau) * libm::j1(s * rho);
            }
        }
        [0.5 * reach * pressure, 0.5 * reach * velocity]
    }
}

impl Solution for RadialPulse {
    fn components(&self) -> usize {
        3
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let RadialPulseProblem {
            medium,
            center,
            width,
            amplitude,
        } = self.problem;
        let (x, y) = (position[0] - center[0], position[1] - center[1]);
        let r = (x * x + y * y).sqrt();
        let tau = medium.sound_speed * time / width;
        let [p, v] = self.integrals(r / width, tau, HALF);
        let speed = amplitude / medium.impedance() * v;
        // v_r is 0 in the centre, where there is no direction.
        let [cosine, sine] = if r > 0.0 { [x / r, y / r] } else { [0.0; 2] };
        fill(state, &[amplitude * p, speed * cosine, speed * sine]);
    }
}
