//! Runge-Kutta methods in increment form, for any semi-discrete system.
//!
//! A stage is `y = y⁰ + dt/m K`, `K` the rates that were made last, or the weighted sum of all so
//! far; the step is `y¹ = y⁰ + dt/6 Σ_i b_i K_i` with whole numbers `b_i`. So there are three
//! registers whatever the number of stages, and in fixed point no weight of a method is ever
//! rounded: where the rates sum to 0 over the particles, so does what a step adds.

use crate::error::Error;
use crate::scalar::Scalar;

/// A system of ordinary differential equations with its three registers.
pub trait SemiDiscrete<S: Scalar> {
    /// Remembers the state as the start of a step and empties the sum.
    fn start(&mut self) -> Result<(), Error>;
    /// Makes the rates of the present stage at that time: the last ones.
    fn rates(&mut self, time: S) -> Result<(), Error>;
    /// Adds `n` times the last rates to the sum.
    fn accumulate(&mut self, n: u32);
    /// Puts the state at the start plus `dt` times the rates that are named.
    fn stage(&mut self, dt: S, from: From) -> Result<(), Error>;
}

/// Which rates a stage is made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum From {
    /// Those that were made last.
    Last,
    /// The weighted sum of all of the step so far.
    Sum,
}

/// A stage after the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stage {
    /// Its rates.
    pub from: From,
    /// `m`: it is made with `dt/m`.
    pub part: u32,
    /// Its time is `t + dt/n`, with this `n`.
    pub time: u32,
    /// `b`: how often its rates count.
    pub weight: u32,
}

/// An explicit method of `1 + stages.len()` stages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RungeKutta {
    /// Its name in scenario files.
    pub name: &'static str,
    /// `p`: the error of a run is O(dt^p).
    pub order: u32,
    /// `b` of the first stage.
    pub first: u32,
    /// The others.
    pub stages: &'static [Stage],
    /// The sum of all `b`.
    pub divisor: u32,
    /// The largest stable `|λ dt|` on the imaginary axis.
    pub imaginary: f64,
    /// The largest stable `-λ dt` on the real axis.
    pub real: f64,
}

/// The strong-stability-preserving method of order 3 (Shu & Osher 1988).
pub const SSP_RK3: RungeKutta = RungeKutta {
    name: "ssp-rk3",
    order: 3,
    first: 1,
    stages: &[
        Stage {
            from: From::Last,
            part: 1,
            time: 1,
            weight: 1,
        },
        Stage {
            from: From::Sum,
            part: 4,
            time: 2,
            weight: 4,
        },
    ],
    divisor: 6,
    imaginary: 1.732_050_8,
    real: 2.512_745_3,
};

/// The classical method of order 4 (Kutta 1901).
pub const RK4: RungeKutta = RungeKutta {
    name: "rk4",
    order: 4,
    first: 1,
    stages: &[
        Stage {
            from: From::Last,
            part: 2,
            time: 2,
            weight: 2,
        },
        Stage {
            from: From::Last,
            part: 2,
            time: 2,
            weight: 2,
        },
        Stage {
            from: From::Last,
            part: 1,
            time: 1,
            weight: 1,
        },
    ],
    divisor: 6,
    imaginary: 2.828_427_1,
    real: 2.785_293_5,
};

impl RungeKutta {
    /// How many right-hand sides a step takes.
    pub fn sides(&self) -> u32 {
        (self.stages.len() as u32).saturating_add(1)
    }

    /// The methods, by name.
    pub const ALL: [Self; 2] = [RK4, SSP_RK3];

    /// Advances a system from `time` by `dt`. On an error its state is between two steps and must
    /// not be used further.
    pub fn advance<S: Scalar>(
        &self,
        system: &mut impl SemiDiscrete<S>,
        time: S,
        dt: S,
    ) -> Result<(), Error> {
        system.start()?;
        system.rates(time)?;
        system.accumulate(self.first);
        for stage in self.stages {
            system.stage(dt / S::count(stage.part), stage.from)?;
            system.rates(time + dt / S::count(stage.time))?;
            system.accumulate(stage.weight);
        }
        system.stage(dt / S::count(self.divisor), From::Sum)
    }
}
