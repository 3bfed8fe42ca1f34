//! Waves in an isotropic elastic plane: `rho v_t = div s`,
//! `s_t = lambda (div v) 1 + mu (grad v + grad v^T)`; `u = (v_x, v_y, s_xx, s_yy, s_xy)`.
//!
//! A plane wave each of pressure and of shear, with n = k/|k|, m across it to the left and
//! `phi = k.x - c |k| t`: L. D. Landau and E. M. Lifshitz, Theory of Elasticity, 3rd edition
//! 1986, section 22.
//!
//! - pressure: `v = A n cos phi`, `s = -(A/c) (lambda 1 + 2 mu n n) cos phi`,
//!   `c^2 = (lambda + 2 mu)/rho`
//! - shear: `v = A m cos phi`, `s = -(A/c) mu (n m + m n) cos phi`, `c^2 = mu/rho`

#[cfg(test)]
mod tests;

use super::error::{SolutionError, check, finite, positive};
use super::plane_wave::PlaneWave;
use super::system::System;
use crate::exact::solution::{Solution, fill};

/// A solid and the waves in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticProblem {
    /// rho, > 0.
    pub density: f64,
    /// Lame's first parameter, > -mu.
    pub lambda: f64,
    /// The shear modulus, > 0.
    pub mu: f64,
    /// k in the plane, and A, the largest velocity.
    pub pressure_wave: PlaneWave,
    /// k in the plane, and A, the largest velocity.
    pub shear_wave: PlaneWave,
}

/// The solution of [`ElasticProblem`]: v_x, v_y, s_xx, s_yy and s_xy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    problem: ElasticProblem,
    /// Of the pressure and the shear wave.
    speeds: [f64; 2],
    /// u where their cosines are 1.
    crests: [[f64; 5]; 2],
}

impl ElasticProblem {
    /// The exact solution.
    ///
    /// # Errors
    /// A number out of range.
    pub fn solve(self) -> Result<Elastic, SolutionError> {
        let Self {
            density,
            lambda,
            mu,
            pressure_wave,
            shear_wave,
        } = self;
        check(&[
            positive("density", density),
            positive("mu", mu),
            ("lambda", lambda, "> -mu", lambda > -mu),
            finite("lambda + 2 mu", lambda + 2.0 * mu),
        ])?;
        let names = [
            "wave_vector of the pressure wave",
            "amplitude of the pressure wave",
        ];
        check(&pressure_wave.numbers(names, 2))?;
        let names = [
            "wave_vector of the shear wave",
            "amplitude of the shear wave",
        ];
        check(&shear_wave.numbers(names, 2))?;
        let speeds = [lambda + 2.0 * mu, mu].map(|stiffness| (stiffness / density).sqrt());
        Ok(Elastic {
            problem: self,
            speeds,
            crests: [
                crest(
                    &pressure_wave,
                    pressure_wave.direction(),
                    speeds[0],
                    lambda,
                    mu,
                ),
                crest(&shear_wave, shear_wave.across(), speeds[1], lambda, mu),
            ],
        })
    }
}

/// u where the velocity is A in a direction e:
/// `s = -(A/c) (lambda (n.e) 1 + mu (n e + e n))`.
fn crest(wave: &PlaneWave, [a, b, _]: [f64; 3], c: f64, lambda: f64, mu: f64) -> [f64; 5] {
    let ([x, y, _], stress) = (wave.direction(), -wave.amplitude / c);
    let pressure = lambda * (x * a + y * b);
    [
        wave.amplitude * a,
        wave.amplitude * b,
        stress * (pressure + 2.0 * mu * x * a),
        stress * (pressure + 2.0 * mu * y * b),
        stress * mu * (x * b + y * a),
    ]
}

impl Elastic {
    /// Of pressure waves, then of shear waves.
    pub fn speeds(&self) -> [f64; 2] {
        self.speeds
    }

    /// The equations it solves.
    pub fn system(&self) -> System {
        let ElasticProblem {
            density,
            lambda,
            mu,
            ..
        } = self.problem;
        let (lightness, stiff) = (-1.0 / density, -(lambda + 2.0 * mu));
        System::zero(2, 5)
            .flux(0, [0, 2], lightness)
            .flux(0, [1, 4], lightness)
            .flux(0, [2, 0], stiff)
            .flux(0, [3, 0], -lambda)
            .flux(0, [4, 1], -mu)
            .flux(1, [0, 4], lightness)
            .flux(1, [1, 3], lightness)
            .flux(1, [2, 1], -lambda)
            .flux(1, [3, 1], stiff)
            .flux(1, [4, 0], -mu)
    }
}

impl Solution for Elastic {
    fn components(&self) -> usize {
        5
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let waves = [self.problem.pressure_wave, self.problem.shear_wave];
        let cosine = |i: usize| {
            let frequency = self.speeds[i] * waves[i].wave_number();
            libm::cos(waves[i].phase(position, frequency, time))
        };
        let ([p, s], [a, b]) = (self.crests, [cosine(0), cosine(1)]);
        let sum: [f64; 5] = std::array::from_fn(|i| p[i] * a + s[i] * b);
        fill(state, &sum);
    }
}
