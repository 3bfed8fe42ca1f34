//! The Riemann problem of gas dynamics in one dimension: two uniform ideal
//! gases meet at x = 0 when t = 0. The solution depends on `xi = x/t` alone: a
//! shock or a fan to the left, a contact, a shock or a fan to the right, or two
//! fans with a vacuum between them.
//!
//! E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd
//! edition 2009, chapter 4; equation numbers are his.
//! Differs from the book: each side has its own gamma (two gases that meet at
//! the contact); the right wave is the mirror image of a left one; Newton's
//! method works on ln p, which keeps p positive.

#[cfg(test)]
mod tests;
mod wave;

use thiserror::Error;

use wave::{Gas, Wave};

/// Density, velocity and pressure at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GasState {
    /// Mass / length; 0 in a vacuum.
    pub density: f64,
    /// Length / time.
    pub velocity: f64,
    /// Density * velocity^2; 0 in a vacuum.
    pub pressure: f64,
}

/// Two ideal gases, `p = (gamma - 1) rho e`, that meet at x = 0 when t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RiemannProblem {
    /// The gas in x < 0.
    pub left: GasState,
    /// The gas in x > 0.
    pub right: GasState,
    /// Ratio of the specific heats of the left gas, > 1.
    pub left_gamma: f64,
    /// Ratio of the specific heats of the right gas, > 1.
    pub right_gamma: f64,
}

/// The state on both sides of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Star {
    /// Of both gases.
    pub pressure: f64,
    /// Of both gases: the speed of the contact.
    pub velocity: f64,
    /// Of the left gas.
    pub left_density: f64,
    /// Of the right gas.
    pub right_density: f64,
}

/// The solution for all x and t > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RiemannSolution {
    left: Wave,
    /// Mirrored, as if it ran to the left.
    right: Wave,
}

/// Why a Riemann problem has no solution here.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum RiemannError {
    /// A number of the problem is out of range.
    #[error("{quantity} = {value} is out of range: need {need}")]
    OutOfRange {
        /// Which number, with its side.
        quantity: &'static str,
        /// What it is.
        value: f64,
        /// What it should be.
        need: &'static str,
    },
    /// The pressure between the waves exceeds what an `f64` holds.
    #[error("the pressure between the waves overflows: need slower or thinner gases")]
    Overflow,
    /// The iteration for the pressure did not end.
    #[error("no pressure found between the waves after {iterations} iterations, last {pressure}")]
    NotConverged {
        /// Iterations made.
        iterations: u32,
        /// The last pressure tried.
        pressure: f64,
    },
}

impl RiemannProblem {
    /// The exact solution. The pressure between the waves is the root of
    ///
    /// `f_L(p) + f_R(p) + u_R - u_L = 0`    (4.5)
    ///
    /// to a few units in its last place, or as near as the rounding of the
    /// left-hand side allows (close to a vacuum that is far less).
    ///
    /// # Errors
    /// [`RiemannError::OutOfRange`] unless all numbers are finite, densities and
    /// pressures > 0 and gammas > 1; the others only near the limits of `f64`.
    pub fn solve(&self) -> Result<RiemannSolution, RiemannError> {
        self.check()?;
        let left = Gas::new(self.left, self.left_gamma);
        let right = Gas::new(mirrored(self.right), self.right_gamma);
        let Some(pressure) = star_pressure(&left, &right)? else {
            return Ok(RiemannSolution {
                left: left.wave(0.0, left.vacuum_edge()),
                right: right.wave(0.0, right.vacuum_edge()),
            });
        };
        let ((f_left, _), (f_right, _)) = (left.f(pressure), right.f(pressure));
        // (4.9)
        let velocity = 0.5 * (self.left.velocity + self.right.velocity) + 0.5 * (f_right - f_left);
        Ok(RiemannSolution {
            left: left.wave(pressure, velocity),
            right: right.wave(pressure, -velocity),
        })
    }

    fn check(&self) -> Result<(), RiemannError> {
        let positive = |value: f64| value > 0.0;
        let any = |_: f64| true;
        let above_1 = |value: f64| value > 1.0;
        let (left, right) = (&self.left, &self.right);
        type Number = (&'static str, f64, &'static str, fn(f64) -> bool);
        let numbers: [Number; 8] = [
            ("left density", left.density, "> 0", positive),
            ("left velocity", left.velocity, "a finite number", any),
            ("left pressure", left.pressure, "> 0", positive),
            ("left gamma", self.left_gamma, "> 1", above_1),
            ("right density", right.density, "> 0", positive),
            ("right velocity", right.velocity, "a finite number", any),
            ("right pressure", right.pressure, "> 0", positive),
            ("right gamma", self.right_gamma, "> 1", above_1),
        ];
        for (quantity, value, need, holds) in numbers {
            if !value.is_finite() || !holds(value) {
                return Err(RiemannError::OutOfRange {
                    quantity,
                    value,
                    need,
                });
            }
        }
        Ok(())
    }
}

impl RiemannSolution {
    /// The state at `xi = x/t`. In a vacuum density and pressure are 0 and the
    /// velocity is `xi`, which joins those of its edges. On the contact: the left gas.
    pub fn sample(&self, xi: f64) -> GasState {
        self.state_and_gamma(xi).0
    }

    /// The internal energy per mass at `xi = x/t`: `p / ((gamma - 1) rho)`, with the
    /// gamma of the gas that is there; 0 in a vacuum.
    pub fn internal_energy(&self, xi: f64) -> f64 {
        match self.state_and_gamma(xi) {
            (state, Some(gamma)) if state.density > 0.0 => {
                state.pressure / ((gamma - 1.0) * state.density)
            }
            _ => 0.0,
        }
    }

    /// The state beside the contact; none if there is a vacuum between the waves.
    pub fn star(&self) -> Option<Star> {
        let (left, right) = (self.left.inside, self.right.inside);
        (left.pressure > 0.0).then_some(Star {
            pressure: left.pressure,
            velocity: left.velocity,
            left_density: left.density,
            right_density: right.density,
        })
    }

    /// Where the left wave begins and ends, as x/t; the same twice for a shock.
    pub fn left_wave(&self) -> [f64; 2] {
        [self.left.head, self.left.tail]
    }

    /// Where the right wave begins and ends, as x/t; the same twice for a shock.
    pub fn right_wave(&self) -> [f64; 2] {
        [-self.right.tail, -self.right.head]
    }

    fn state_and_gamma(&self, xi: f64) -> (GasState, Option<f64>) {
        if xi <= self.left.inside.velocity {
            (self.left.sample(xi), Some(self.left.gas.gamma))
        } else if xi >= -self.right.inside.velocity {
            let state = mirrored(self.right.sample(-xi));
            (state, Some(self.right.gas.gamma))
        } else {
            let vacuum = GasState {
                density: 0.0,
                velocity: xi,
                pressure: 0.0,
            };
            (vacuum, None)
        }
    }
}

/// The same gas seen in a mirror at x = 0.
fn mirrored(state: GasState) -> GasState {
    let velocity = -state.velocity;
    GasState { velocity, ..state }
}

/// The root p of (4.5), both gases given as if their waves ran to the left; none
/// if the gases part so fast that a vacuum opens between them: (4.40).
///
/// Newton's method on ln p between two bounds that close in; a step out of them
/// is replaced by their geometric mean, so the iteration always ends.
fn star_pressure(left: &Gas, right: &Gas) -> Result<Option<f64>, RiemannError> {
    let f = |p: f64| {
        let ((f_left, slope_left), (f_right, slope_right)) = (left.f(p), right.f(p));
        let parting = -right.state.velocity - left.state.velocity;
        (f_left + f_right + parting, slope_left + slope_right)
    };
    let mut lower = left.state.pressure.min(right.state.pressure);
    while f(lower).0 > 0.0 {
        lower *= 1e-4;
        // What is below the smallest pressure of full precision counts as vacuum.
        if lower < f64::MIN_POSITIVE {
            return Ok(None);
        }
    }
    let mut upper = left.state.pressure.max(right.state.pressure);
    while f(upper).0 < 0.0 {
        upper *= 10.0;
    }
    if !(upper.is_finite() && f(upper).0.is_finite()) {
        return Err(RiemannError::Overflow);
    }
    let mut p = lower.sqrt() * upper.sqrt();
    for _ in 0..ITERATIONS {
        let (value, slope) = f(p);
        if value > 0.0 {
            upper = p;
        } else {
            lower = p;
        }
        let step = -value / (p * slope);
        let newton = p * libm::exp(step);
        let inside = lower < newton && newton < upper;
        let next = if inside {
            newton
        } else {
            lower.sqrt() * upper.sqrt()
        };
        if step.abs() <= CONVERGED || upper - lower <= CONVERGED * upper {
            return Ok(Some(p));
        }
        p = next;
    }
    Err(RiemannError::NotConverged {
        iterations: ITERATIONS,
        pressure: p,
    })
}

/// Iterations at most. Bisection of ln p alone, from the whole range of f64
/// (a factor e^1420), needs log2(1420 / 4e-16) = 62; Newton mostly 4 to 7.
const ITERATIONS: u32 = 200;

/// Relative change of p at which the iteration ends: two units in the last place.
const CONVERGED: f64 = 2.0 * f64::EPSILON;
