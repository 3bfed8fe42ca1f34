//! The Riemann problem of gas dynamics in one dimension: two uniform gases meet at x = 0
//! when t = 0. The solution depends on `xi = x/t` alone: a shock or a fan to the left, a
//! contact, a shock or a fan to the right, or two fans with a vacuum between them.
//!
//! The gases are ideal or stiffened, `p = (gamma - 1) rho e - gamma p_inf`: a liquid, of
//! sound speed `(gamma (p + p_inf)/rho)^(1/2)`. With `p + p_inf` for p the relations of
//! shocks and fans are those of the ideal gas: R. Menikoff and B. J. Plohr, Reviews of Modern
//! Physics 61 (1989), section IV; B. J. Plohr, AIAA Journal 26 (1988).
//!
//! Or the density alone gives their pressure: `barotropic`. Any two may meet.
//!
//! E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd
//! edition 2009, chapter 4; equation numbers are his.
//! Differs from the book: each side has its own gamma (two gases that meet at
//! the contact); the right wave is the mirror image of a left one; Newton's
//! method works on ln(p + lower p_inf), which keeps that positive.

mod barotropic;
mod flow;
mod side;
mod state;
#[cfg(test)]
mod tests;
mod wave;

pub use flow::RiemannFlow;
pub use state::GasState;

use thiserror::Error;

use super::flow::Number;
use crate::scenario::EquationOfState;
use side::{Side, Wave};

/// Two gases, `p = (gamma - 1) rho e - gamma p_inf`, that meet at x = 0 when t = 0.
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
    /// `p_inf` of the left gas, >= 0; 0 for an ideal gas.
    pub left_pressure_at_infinity: f64,
    /// `p_inf` of the right gas, >= 0; 0 for an ideal gas.
    pub right_pressure_at_infinity: f64,
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
    /// Whether there is a vacuum between the waves.
    vacuum: bool,
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
    /// `p + p_inf` > 0, `p_inf` >= 0 and gammas > 1; the others only near the limits of `f64`.
    pub fn solve(&self) -> Result<RiemannSolution, RiemannError> {
        self.check()?;
        let (left_p_inf, right_p_inf) = (
            self.left_pressure_at_infinity,
            self.right_pressure_at_infinity,
        );
        let law = |gamma, pressure_at_infinity| EquationOfState::StiffenedGas {
            gamma,
            pressure_at_infinity,
        };
        meeting(
            (self.left, law(self.left_gamma, left_p_inf)),
            (self.right, law(self.right_gamma, right_p_inf)),
        )
    }

    fn check(&self) -> Result<(), RiemannError> {
        let (left, right) = (&self.left, &self.right);
        let gammas = (self.left_gamma, self.right_gamma);
        let (left_p_inf, right_p_inf) = (
            self.left_pressure_at_infinity,
            self.right_pressure_at_infinity,
        );
        let finite = "a finite number";
        let above = "> 0, or > -p_inf in a stiffened gas";
        let (left_total, right_total) = (left.pressure + left_p_inf, right.pressure + right_p_inf);
        let numbers: [Number; 10] = [
            ("left density", left.density, "> 0", left.density > 0.0),
            ("left velocity", left.velocity, finite, true),
            ("left pressure", left.pressure, above, left_total > 0.0),
            ("left gamma", gammas.0, "> 1", gammas.0 > 1.0),
            ("left p_inf", left_p_inf, ">= 0", left_p_inf >= 0.0),
            ("right density", right.density, "> 0", right.density > 0.0),
            ("right velocity", right.velocity, finite, true),
            ("right pressure", right.pressure, above, right_total > 0.0),
            ("right gamma", gammas.1, "> 1", gammas.1 > 1.0),
            ("right p_inf", right_p_inf, ">= 0", right_p_inf >= 0.0),
        ];
        check(&numbers)
    }
}

/// The exact solution for matter of any equation of state on either side, as
/// [`RiemannProblem::solve`].
///
/// # Errors
/// Those of [`RiemannProblem::solve`].
pub fn between(
    left: (GasState, EquationOfState),
    right: (GasState, EquationOfState),
) -> Result<RiemannSolution, RiemannError> {
    let finite = "a finite number";
    for (name, (state, law)) in [("left density", left), ("right density", right)] {
        let numbers: [Number; 3] = [
            (name, state.density, "> 0", state.density > 0.0),
            ("velocity", state.velocity, finite, true),
            (
                "pressure",
                state.pressure,
                "> 0, or > -p_inf in a stiffened gas, or > -B in a liquid",
                state.pressure + side::stiffness(&law) > 0.0,
            ),
        ];
        check(&numbers)?;
    }
    meeting(left, right)
}

/// The same of numbers that have been checked.
fn meeting(
    left: (GasState, EquationOfState),
    right: (GasState, EquationOfState),
) -> Result<RiemannSolution, RiemannError> {
    // Only p + p_inf counts, and no gas bears a pressure below -p_inf.
    let floor = -side::stiffness(&left.1).min(side::stiffness(&right.1));
    let velocities = (left.0.velocity, right.0.velocity);
    let left = Side::new(left.0, &left.1, floor);
    let right = Side::new(mirrored(right.0), &right.1, floor);
    let Some(level) = star_level(&left, &right)? else {
        let edges = [left.vacuum_edge(), right.vacuum_edge()];
        if !edges.iter().all(|edge| edge.is_finite()) {
            return Err(RiemannError::OutOfRange {
                quantity: "right velocity",
                value: velocities.1,
                need: "gases that part more slowly: an isothermal one leaves no vacuum",
            });
        }
        return Ok(RiemannSolution {
            left: left.wave(0.0, edges[0]),
            right: right.wave(0.0, edges[1]),
            vacuum: true,
        });
    };
    let ((f_left, _), (f_right, _)) = (left.f(level), right.f(level));
    // (4.9)
    let velocity = 0.5 * (velocities.0 + velocities.1) + 0.5 * (f_right - f_left);
    Ok(RiemannSolution {
        left: left.wave(level, velocity),
        right: right.wave(level, -velocity),
        vacuum: false,
    })
}

/// An error that names the first number that is not finite or not as it should be.
fn check(numbers: &[Number]) -> Result<(), RiemannError> {
    for &(quantity, value, need, holds) in numbers {
        if !value.is_finite() || !holds {
            return Err(RiemannError::OutOfRange {
                quantity,
                value,
                need,
            });
        }
    }
    Ok(())
}

impl RiemannSolution {
    /// The state at `xi = x/t`. In a vacuum the density is 0, the pressure the least that
    /// both gases bear (0 unless both are stiffened), and the velocity is `xi`, which joins
    /// those of its edges. On the contact: the left gas.
    pub fn sample(&self, xi: f64) -> GasState {
        self.state_and_wave(xi).0
    }

    /// The internal energy per mass at `xi = x/t`: `(p + gamma p_inf) / ((gamma - 1) rho)`,
    /// with the gamma and `p_inf` of the gas that is there; of barotropic matter what it has gained;
    /// 0 in a vacuum.
    pub fn internal_energy(&self, xi: f64) -> f64 {
        match self.state_and_wave(xi) {
            (state, Some((wave, xi))) if state.density > 0.0 => wave.internal_energy(state, xi),
            _ => 0.0,
        }
    }

    /// The state beside the contact; none if there is a vacuum between the waves.
    pub fn star(&self) -> Option<Star> {
        let (left, right) = (self.left.front.inside, self.right.front.inside);
        (!self.vacuum).then_some(Star {
            pressure: left.pressure,
            velocity: left.velocity,
            left_density: left.density,
            right_density: right.density,
        })
    }

    /// Where the left wave begins and ends, as x/t; the same twice for a shock.
    pub fn left_wave(&self) -> [f64; 2] {
        [self.left.front.head, self.left.front.tail]
    }

    /// Where the right wave begins and ends, as x/t; the same twice for a shock.
    pub fn right_wave(&self) -> [f64; 2] {
        [-self.right.front.tail, -self.right.front.head]
    }

    /// The state, and the wave that it belongs to with `xi` as that wave sees it.
    fn state_and_wave(&self, xi: f64) -> (GasState, Option<(&Wave, f64)>) {
        if xi <= self.left.front.inside.velocity {
            (self.left.sample(xi), Some((&self.left, xi)))
        } else if xi >= -self.right.front.inside.velocity {
            let state = mirrored(self.right.sample(-xi));
            (state, Some((&self.right, -xi)))
        } else {
            let vacuum = GasState {
                density: 0.0,
                velocity: xi,
                pressure: self.left.front.inside.pressure,
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

/// The root of (4.5), as the level of p above the least that both gases bear, both gases
/// given as if their waves ran to the left; none if they part so fast that a vacuum opens
/// between them: (4.40).
///
/// Newton's method on the logarithm between two bounds that close in; a step out of them
/// is replaced by their geometric mean, so the iteration always ends.
fn star_level(left: &Side, right: &Side) -> Result<Option<f64>, RiemannError> {
    let f = |p: f64| {
        let ((f_left, slope_left), (f_right, slope_right)) = (left.f(p), right.f(p));
        let parting = -right.state().velocity - left.state().velocity;
        (f_left + f_right + parting, slope_left + slope_right)
    };
    let levels = [left.level(), right.level()];
    let (least, greatest) = (levels[0].min(levels[1]), levels[0].max(levels[1]));
    // A stiffened gas beside an ideal one may be below 0; the other never is.
    let mut lower = if least > 0.0 { least } else { greatest };
    while f(lower).0 > 0.0 {
        lower *= 1e-4;
        // What is below the smallest pressure of full precision counts as vacuum.
        if lower < f64::MIN_POSITIVE {
            return Ok(None);
        }
    }
    let mut upper = greatest;
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
        let newton = p * step.exp();
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
