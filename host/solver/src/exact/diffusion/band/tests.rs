//! The equation, the start, the mass, and the images.

use super::super::super::linear::residual::Probe;
use super::super::residual::{Equation, assert_holds, scaled};
use super::super::tensor::IDENTITY;
use super::*;

const GOOD: BandProblem = BandProblem {
    center: 0.2,
    length: 0.7,
    width: 0.3,
    amplitude: 1.3,
    diffusivity: 0.05,
    velocity: [0.4, -0.6, 0.0],
    period: None,
};

impl Equation for BandProblem {
    fn dimension(&self) -> usize {
        2
    }

    fn velocity(&self, _: [f64; 3]) -> [f64; 3] {
        self.velocity
    }

    fn diffusion(&self, _: [f64; 3], _: f64, _: usize) -> [[f64; 3]; 3] {
        scaled(IDENTITY, self.diffusivity)
    }
}

/// Later than `s = 0.35 P` for a period of 1.
#[test]
fn the_equation_holds() {
    for (period, duration) in [(None, 1.0), (Some(1.0), 1.0), (Some(1.0), 5.0)] {
        let probe = Probe {
            center: [0.2, 0.0, 0.0],
            size: 0.8,
            duration,
            length: 0.2,
            pace: 0.2,
        };
        let problem = BandProblem { period, ..GOOD };
        assert_holds(&problem, &problem.solve().unwrap(), probe);
    }
}

/// `u = A ∫_l^r exp(-(x - y)^2/w^2) dy/(sqrt(pi) w)`, by Simpson's rule: error `h^4/180` times the
/// fourth derivative, below 12 `(0.7/1000)^4/180/0.3^4 < 1e-11`.
#[test]
fn it_starts_as_a_smoothed_band_and_keeps_so_without_diffusion() {
    let mut problem = GOOD;
    problem.diffusivity = 0.0;
    let band = problem.solve().unwrap();
    for i in -10..20 {
        let x = 0.11 * f64::from(i);
        let kernel = |j: i32| {
            let part = (x - (-0.15 + 0.7e-3 * f64::from(j))) / 0.3;
            (-part * part).exp() / (PI.sqrt() * 0.3)
        };
        let weight = |j: i32| if j % 2 == 1 { 4.0 } else { 2.0 };
        let inner = (1..1000).map(|j| weight(j) * kernel(j)).sum::<f64>();
        let expected = 1.3 * (kernel(0) + inner + kernel(1000)) * 0.7e-3 / 3.0;
        for time in [0.0, 0.75] {
            let u = band.at([x + 0.4 * time, 0.3, 0.0], time)[0];
            assert!((u - expected).abs() < 1e-11, "{x} {time}: {u} {expected}");
        }
    }
}

/// The trapezoidal rule on a period, or far beyond the band, is exact up to `e^(-(pi w/h)^2)`.
#[test]
fn the_mass_stays() {
    for (period, time) in [(None, 1.0), (Some(1.0), 0.0), (Some(1.0), 9.0)] {
        let band = BandProblem { period, ..GOOD }.solve().unwrap();
        let range = if period.is_some() { 0..50 } else { -500..500 };
        let sum = range.map(|i| band.at([0.02 * f64::from(i), 0.0, 0.0], time)[0]);
        let mass = 0.02 * sum.sum::<f64>();
        assert!(
            (mass / (1.3 * 0.7) - 1.0).abs() < 1e-13,
            "{period:?}: {mass}"
        );
    }
}

/// Where both formulas serve they agree.
#[test]
fn waves_are_the_sum_of_images() {
    for length in [0.2, 0.7, 1.0] {
        let band = BandProblem { length, ..GOOD }.solve().unwrap();
        for scale in [0.3, 0.5, 0.8, 3.0] {
            for i in -10..10 {
                let x = 0.13 * f64::from(i);
                let [a, b] = [band.images(x, scale, 1.0), band.waves(x, scale, 1.0)];
                assert!((a - b).abs() < 3e-15, "{length} {scale} {x}: {a} {b}");
            }
        }
    }
}

/// Places are differences of 500 and good to 6e-14, a front has the slope 1.3.
#[test]
fn a_long_band_is_one_front() {
    let mut problem = GOOD;
    (problem.length, problem.center) = (1000.0, 500.0);
    let band = problem.solve().unwrap();
    for i in -10..10 {
        let x = 0.1 * f64::from(i);
        let scale = (0.09 + 4.0 * 0.05 * 0.5_f64).sqrt();
        let expected = 1.3 * 0.5 * libm::erfc(-(x - 0.2) / scale);
        let error = band.at([x, 0.0, 0.0], 0.5)[0] - expected;
        assert!(error.abs() < 1e-13, "{x}: {error:e}");
    }
}

#[test]
fn what_is_wrong_is_named() {
    let text = |problem: BandProblem| problem.solve().unwrap_err().to_string();
    let (mut width, mut length, mut velocity, mut b) = (GOOD, GOOD, GOOD, GOOD);
    width.width = 0.0;
    assert_eq!(text(width), "width must be > 0, not 0");
    length.period = Some(0.5);
    assert_eq!(text(length), "length must be at most the period, not 0.7");
    velocity.velocity[1] = f64::INFINITY;
    assert_eq!(text(velocity), "velocity must be finite, not inf");
    b.diffusivity = -0.1;
    assert_eq!(text(b), "diffusivity must be >= 0, not -0.1");
}
