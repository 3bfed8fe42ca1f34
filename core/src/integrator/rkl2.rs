//! The stabilised Runge-Kutta-Legendre method of order 2 (Meyer, Balsara & Aslam, J. Comput. Phys.
//! 257, 2014, 594): `s` stages reach `(s²+s-2)/4` times the step of Euler's method.
//!
//! `Y_1 = Y_0 + μ̃_1 dt L(Y_0)`,
//! `Y_j = μ_j Y_(j-1) + ν_j Y_(j-2) + (1-μ_j-ν_j) Y_0 + μ̃_j dt L(Y_(j-1)) + γ̃_j dt L(Y_0)`,
//!
//! here in increments `Z_j = Y_j - Y_0`, which are small: their rounding is that of a step, not
//! that of the state.

use crate::error::Error;
use crate::scalar::Scalar;

/// The most stages of a step: what bounds its work.
pub const MOST_STAGES: u32 = 255;

/// A system that keeps, beside its state, the rates of the first stage and two increments.
pub trait Stabilised<S: Scalar> {
    /// Remembers the state as the start of a step, with increments 0.
    fn start(&mut self) -> Result<(), Error>;
    /// Makes the rates of the present stage at that time: the last ones.
    fn rates(&mut self, time: S) -> Result<(), Error>;
    /// Keeps the last rates as those of the first stage.
    fn keep(&mut self);
    /// `Z := μ Z_before + ν Z_before_that + last rates * fresh + first rates * first`, and puts the
    /// state at the start plus `Z`.
    fn combine(&mut self, weights: [S; 2], fresh: S, first: S) -> Result<(), Error>;
}

/// The method with a number of stages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rkl2 {
    /// `s`, 3 to [`MOST_STAGES`], odd: even numbers damp the shortest waves less.
    stages: u32,
}

impl Rkl2 {
    /// The fewest stages that are stable with `|λ| dt <= product` on the negative real axis; as
    /// many as there may be where more are needed: [`Rkl2::reach`] tells.
    pub fn for_product<S: Scalar>(product: S) -> Self {
        let mut method = Self { stages: 3 };
        while method.stages < MOST_STAGES && !(product <= method.reach()) {
            method.stages += 2;
        }
        method
    }

    /// With that many stages, made odd and cut off at 3 and [`MOST_STAGES`].
    pub fn with_stages(stages: u32) -> Self {
        let stages = if stages < 3 { 3 } else { stages | 1 };
        Self {
            stages: if stages > MOST_STAGES {
                MOST_STAGES
            } else {
                stages
            },
        }
    }

    /// How many stages.
    pub fn stages(&self) -> u32 {
        self.stages
    }

    /// The largest stable `|λ| dt`: `(s²+s-2)/2`.
    pub fn reach<S: Scalar>(&self) -> S {
        let s = self.stages;
        S::count((s * s + s - 2) / 2)
    }

    /// Advances a system from `time` by `dt`.
    pub fn advance<S: Scalar>(
        &self,
        system: &mut impl Stabilised<S>,
        time: S,
        dt: S,
    ) -> Result<(), Error> {
        let s = f64::from(self.stages);
        let whole = s * s + s - 2.0;
        let w = 4.0 / whole;
        let number = S::from_f64;
        system.start()?;
        system.rates(time)?;
        system.keep();
        let first = dt * number(b(1) * w);
        system.combine([S::ZERO; 2], first, S::ZERO)?;
        // c_1 = c_2/4.
        let mut moment = dt * number(1.0 / whole);
        for j in 2..=self.stages {
            system.rates(time + moment)?;
            let n = f64::from(j);
            let mu = (2.0 * n - 1.0) / n * b(j) / b(j.wrapping_sub(1));
            let nu = -(n - 1.0) / n * b(j) / b(j.wrapping_sub(2));
            let fresh = mu * w;
            let first = -(1.0 - b(j.wrapping_sub(1))) * fresh;
            system.combine(
                [number(mu), number(nu)],
                dt * number(fresh),
                dt * number(first),
            )?;
            moment = dt * number((n * n + n - 2.0) / whole);
        }
        Ok(())
    }
}

/// `b_j = (j²+j-2)/(2j(j+1))`, `b_0 = b_1 = b_2 = 1/3`.
fn b(j: u32) -> f64 {
    if j < 3 {
        return 1.0 / 3.0;
    }
    let j = f64::from(j);
    (j * j + j - 2.0) / (2.0 * j * (j + 1.0))
}
