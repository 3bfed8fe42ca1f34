//! Heat through layers: `du/dt = d_x(D d_x u)`, D constant in each layer, u and `D d_x u` continuous,
//! from u the same everywhere, with ends that change in time.
//!
//! Let g be what drives an end, for values less the initial one, W the steady state for g = 1
//! at this end and 0 at the other, and phi_n, lambda_n the `eigenmodes`. Green's formula gives
//! `W_n = -psi_n/lambda_n`, with `D dphi_n/dn`, `phi_n` or `-rate phi_n` at this end for psi_n where
//! it is a value, a flux or an exchange:
//!
//! - `u = u_0 + Σ_ends [g W + Σ_n a_n phi_n]`, `da_n/dt = -lambda_n a_n + (psi_n/lambda_n) dg/dt`
//!
//! which straight lines of g make a sum of exponentials. Two fluxes admit a steady state only with
//! a source; W then has `d_x(D d_x W) = -1/length` and mean 0, and the mean of u is that of its
//! balance. Carslaw and Jaeger, sections 1.14 and 3.1; M. D. Mikhailov and M. N. Ozisik, Unified
//! Analysis and Solutions of Heat and Mass Diffusion, 1984.
//!
//! There are `MODES` modes; of the faster ones, as long as `a_n = psi_n g'/lambda_n^2`, the sum is
//! `g' z` less what the known ones have of it, `d_x(D d_x z) = W`. u is then good to some 1e-14 of
//! the largest g but for a time `35/lambda_N = 2.2e-5 T^2`, `T = Σ thickness/sqrt(D)`, after t = 0
//! and after a corner of g. In that time u near the end is wrong by up to `g(0) e^-(lambda_N t)`, and
//! by 2e-7 `T^2` times the change of g'. The flux has one order less there.

pub mod drive;
mod driven;
mod eigenmodes;
mod layers;
#[cfg(test)]
mod tests;

use std::sync::{Mutex, PoisonError};

use super::super::linear::error::{SolutionError, check, finite, positive};
use crate::exact::solution::{Solution, fill};
use drive::Drive;
use driven::Driven;
use eigenmodes::{Eigenmode, eigenmodes};
use layers::{Layers, Profile};

/// How many modes.
const MODES: usize = 400;

/// The most layers: the modes take a time proportional to it, a tenth of a second for these.
const MOST_LAYERS: usize = 100;

/// Of `thickness/sqrt(D)`: the squares of its inverse and of 400 of these are numbers.
const SHORTEST: f64 = 1e-100;

/// A coefficient as a part of the largest from which on it is nothing.
const NOTHING: f64 = 1e-19;

/// A layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    /// Along x, > 0.
    pub thickness: f64,
    /// D, length^2 / time, > 0.
    pub diffusivity: f64,
}

impl Layer {
    /// `thickness/sqrt(D)`, whose square is the time that heat takes.
    fn duration(&self) -> f64 {
        self.thickness / libm::sqrt(self.diffusivity)
    }
}

/// What holds at an end.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// Nothing passes.
    NoFlux,
    /// u is given.
    Value(Drive),
    /// The flux outwards, `-D du/dn`, is given.
    Flux(Drive),
    /// The flux outwards is `rate (u - outside)`.
    Exchange {
        /// Length / time, > 0.
        rate: f64,
        /// What u would be without a flux.
        outside: Drive,
    },
}

/// Layers along x, and their ends.
#[derive(Debug, Clone, PartialEq)]
pub struct SlabProblem {
    /// Where the first layer begins.
    pub lower: f64,
    /// One after the other, 1 to 100.
    pub layers: Vec<Layer>,
    /// That below and that above.
    pub ends: [End; 2],
    /// u at t = 0.
    pub initial: f64,
}

/// The solution of [`SlabProblem`]. Beyond an end it is what it is there.
#[derive(Debug)]
pub struct Slab {
    initial: f64,
    /// Whether both ends are fluxes, so that the level follows the balance.
    open: bool,
    layers: Layers,
    modes: Vec<Eigenmode>,
    driven: Vec<Driven>,
    latest: Mutex<Snapshot>,
}

/// u at the last time asked for: points are asked for at the same time by the thousand.
#[derive(Debug)]
struct Snapshot {
    time: f64,
    profile: Profile,
    coefficients: Vec<f64>,
}

impl Snapshot {
    /// At t = 0, which no number of modes sums up to.
    fn initial(u: f64, count: usize) -> Self {
        Self {
            time: 0.0,
            profile: Profile::uniform(u, count),
            coefficients: Vec::new(),
        }
    }
}

impl End {
    fn check(&self) -> Result<(), SolutionError> {
        if let Self::Exchange { rate, .. } = self {
            check(&[positive("rate of exchange", *rate)])?;
        }
        self.drive().map_or(Ok(()), Drive::check)
    }

    fn drive(&self) -> Option<&Drive> {
        match self {
            Self::NoFlux => None,
            Self::Value(drive) | Self::Flux(drive) => Some(drive),
            Self::Exchange { outside, .. } => Some(outside),
        }
    }
}

impl SlabProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// Numbers out of range, no layer, drives without points or with times that do not ascend.
    pub fn solve(self) -> Result<Slab, SolutionError> {
        let count = self.layers.len();
        let holds = (1..=MOST_LAYERS).contains(&count);
        check(&[
            finite("lower", self.lower),
            finite("initial", self.initial),
            ("number of layers", count as f64, "1 to 100", holds),
        ])?;
        for layer in &self.layers {
            check(&[
                positive("thickness", layer.thickness),
                positive("diffusivity", layer.diffusivity),
            ])?;
            let duration = layer.duration();
            let holds = (SHORTEST..=1.0 / SHORTEST).contains(&duration);
            let name = "thickness / sqrt(diffusivity)";
            check(&[(name, duration, "1e-100 to 1e100", holds)])?;
        }
        for end in &self.ends {
            end.check()?;
        }
        let layers = Layers::new(self.lower, self.layers);
        let modes = eigenmodes(&layers, &self.ends, MODES);
        let driven =
            [0, 1].map(|side| Driven::new(&layers, &modes, &self.ends, side, self.initial));
        Ok(Slab {
            initial: self.initial,
            open: self.ends.iter().all(End::is_a_flux),
            latest: Mutex::new(Snapshot::initial(self.initial, count)),
            driven: driven.into_iter().flatten().collect(),
            layers,
            modes,
        })
    }
}

impl Slab {
    /// `u_0`, and what two fluxes have let in.
    fn level(&self, time: f64) -> f64 {
        if !self.open {
            return self.initial;
        }
        let left = self.driven.iter().map(|end| end.course.integral(time));
        self.initial - left.sum::<f64>() / self.layers.length()
    }

    fn snapshot(&self, time: f64) -> Snapshot {
        let count = self.layers.layers.len();
        if time == 0.0 {
            return Snapshot::initial(self.initial, count);
        }
        let mut profile = Profile::uniform(self.level(time), count);
        let mut coefficients = vec![0.0; self.modes.len()];
        let fastest = self.modes.last().map_or(0.0, Eigenmode::rate);
        for Driven {
            course,
            steady,
            late,
            weights,
        } in &self.driven
        {
            // The faster modes: `a_n = psi_n slope/lambda_n^2`, as if they were not faster than the
            // fastest known. With g' itself a line too short for that would do harm.
            let slope = course.slope(fastest, time);
            profile.add(course.at(time), steady);
            profile.add(slope, late);
            for ((sum, weight), mode) in coefficients.iter_mut().zip(weights).zip(&self.modes) {
                let rate = mode.rate();
                let jump = course.start(rate, time);
                *sum += weight * (jump + (course.slope(rate, time) - slope) / rate);
            }
        }
        let most = coefficients
            .iter()
            .fold(0.0_f64, |most, c| most.max(c.abs()));
        let there = |c: &f64| c.abs() > NOTHING * most;
        let count = coefficients
            .iter()
            .rposition(there)
            .map_or(0, |last| last + 1);
        coefficients.truncate(count);
        Snapshot {
            time,
            profile,
            coefficients,
        }
    }

    /// u and `D du/dx`.
    fn state(&self, x: f64, time: f64) -> [f64; 2] {
        let time = time.max(0.0);
        let place = self.layers.locate(x);
        let layer = &self.layers.layers[place.0];
        // A thread that panicked leaves values of one time or of the other, never of both.
        let mut latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner);
        if latest.time != time {
            *latest = self.snapshot(time);
        }
        let [u, slope] = latest.profile.at(place);
        let mut sum = [u, layer.diffusivity * slope];
        for (coefficient, mode) in latest.coefficients.iter().zip(&self.modes) {
            let [phi, flux] = mode.at(layer, place);
            sum[0] += coefficient * phi;
            sum[1] += coefficient * flux;
        }
        sum
    }

    /// `-D du/dx`, the flux along x.
    pub fn flux(&self, x: f64, time: f64) -> f64 {
        let [_, flux] = self.state(x, time);
        -flux
    }

    /// u at a place long after all drives have come to rest; none if two fluxes then do not
    /// cancel.
    pub fn steady(&self, x: f64) -> Option<f64> {
        let ends = self.driven.iter().map(|end| end.course.end());
        let last = ends.fold(0.0, f64::max);
        let left = self.driven.iter().map(|end| end.course.at(last));
        if self.open && left.sum::<f64>() != 0.0 {
            return None;
        }
        let place = self.layers.locate(x);
        let terms = self.driven.iter().map(|end| {
            let [w, _] = end.steady.at(place);
            end.course.at(last) * w
        });
        Some(self.level(last) + terms.sum::<f64>())
    }
}

impl Solution for Slab {
    fn components(&self) -> usize {
        1
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let [u, _] = self.state(position[0], time);
        fill(state, &[u]);
    }
}
