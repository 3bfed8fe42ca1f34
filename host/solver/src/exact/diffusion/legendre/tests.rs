//! The equation, the polynomials, and what passes the ends.

use super::super::super::linear::residual::Probe;
use super::super::residual::{Equation, assert_holds, scaled};
use super::super::tensor::IDENTITY;
use super::*;

const GOOD: LegendreProblem = LegendreProblem {
    center: 0.3,
    radius: 1.2,
    degree: 3,
    amplitude: 0.8,
    diffusivity: 0.1,
    modulation: None,
};

const SWING: Modulation = Modulation {
    amplitude: -0.9,
    rate: 4.0,
};

impl Equation for LegendreProblem {
    fn dimension(&self) -> usize {
        1
    }

    fn diffusion(&self, [x, ..]: [f64; 3], time: f64, _: usize) -> [[f64; 3]; 3] {
        scaled(IDENTITY, LegendreProblem::diffusivity(self, x, time))
    }
}

#[test]
fn the_equation_holds() {
    for (degree, length) in [(1, 0.4), (3, 0.4), (8, 0.1)] {
        for modulation in [None, Some(SWING)] {
            let probe = Probe {
                center: [0.3, 0.0, 0.0],
                size: 1.15,
                duration: 1.0,
                length,
                pace: length,
            };
            let problem = LegendreProblem {
                degree,
                modulation,
                ..GOOD
            };
            assert_holds(&problem, &problem.solve().unwrap(), probe);
        }
    }
}

#[test]
fn the_polynomials_are_those_of_the_tables() {
    for i in -10..=10 {
        let x = 0.1 * f64::from(i);
        let expected = [
            1.0,
            x,
            1.5 * x * x - 0.5,
            2.5 * x * x * x - 1.5 * x,
            (35.0 * x.powi(4) - 30.0 * x * x + 3.0) / 8.0,
        ];
        for (degree, expected) in (0..).zip(expected) {
            assert!((legendre(degree, x) - expected).abs() < 1e-15);
        }
        assert!(legendre(32, x).abs() <= 1.0);
    }
    assert_eq!(legendre(32, 1.0), 1.0);
    assert_eq!(legendre(31, -1.0), -1.0);
}

/// What is there fades but its mean does not: no flux passes the ends. By Simpson's rule, exact
/// for degree 3; of degree 0 all stays.
#[test]
fn the_mass_stays() {
    for degree in [0, 1, 2, 3] {
        let problem = LegendreProblem {
            degree,
            modulation: Some(SWING),
            ..GOOD
        };
        let solution = problem.solve().unwrap();
        let u = |x: f64| solution.at([0.3 + 1.2 * x, 0.0, 0.0], 2.0)[0];
        let mass = (u(-1.0) + 4.0 * u(0.0) + u(1.0)) / 6.0;
        let expected = if degree == 0 { 0.8 } else { 0.0 };
        assert!((mass - expected).abs() < 1e-15, "{degree}: {mass}");
    }
}

#[test]
fn without_diffusion_nothing_happens() {
    let problem = LegendreProblem {
        diffusivity: 0.0,
        ..GOOD
    };
    let solution = problem.solve().unwrap();
    let x = [0.7, 0.0, 0.0];
    assert_eq!(solution.at(x, 5.0), solution.at(x, 0.0));
    assert_eq!(solution.at([1.5, 0.0, 0.0], 5.0), [0.8]);
}

#[test]
fn what_is_wrong_is_named() {
    let text = |problem: LegendreProblem| problem.solve().unwrap_err().to_string();
    let degree = LegendreProblem { degree: 33, ..GOOD };
    assert_eq!(text(degree), "degree must be 0 to 32, not 33");
    let radius = LegendreProblem {
        radius: -1.0,
        ..GOOD
    };
    assert_eq!(text(radius), "radius must be > 0, not -1");
    let rate = f64::NAN;
    let modulation = Some(Modulation { rate, ..SWING });
    let problem = LegendreProblem { modulation, ..GOOD };
    assert_eq!(
        text(problem),
        "rate of the modulation must be finite, not NaN"
    );
}
