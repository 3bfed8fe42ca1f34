//! The equations, the modes it is made of, and what it keeps.

use super::super::modes::tests::assert_is_a_mode;
use super::super::modes::{Mode, ModeProblem};
use super::super::residual::{Probe, assert_holds};
use super::*;

fn cavity(modes: [u32; 2]) -> Maxwell {
    let problem = MaxwellProblem {
        permittivity: 1.5,
        permeability: 0.8,
        lengths: [3.0, 2.0],
        modes,
        amplitude: 0.7,
    };
    problem.solve().unwrap()
}

#[test]
fn the_equations_hold() {
    let probe = Probe {
        center: [0.0; 3],
        size: 2.0,
        duration: 3.0,
        length: 0.2,
        pace: 0.2,
    };
    let wave = cavity([1, 2]);
    assert_holds(&wave.system(), &wave, probe);
}

#[test]
fn along_an_axis_it_is_a_mode() {
    let [x, y] = [cavity([2, 0]), cavity([0, 1])];
    assert_is_a_mode(&x, x.system(), [4.0 * PI / 3.0, 0.0, 0.0]);
    assert_is_a_mode(&y, y.system(), [0.0, PI, 0.0]);
}

/// `cos(k_x x) cos(k_y y)` is half the sum of the cosines of `k_x x + k_y y` and `k_x x - k_y y`.
/// Phases below 40, hence errors below 40 roundings of some 3e-16.
#[test]
fn it_is_the_sum_of_two_modes() {
    let wave = cavity([1, 2]);
    let mode = |sign: f64| -> Mode {
        let problem = ModeProblem {
            system: wave.system(),
            wave_vector: [2.0 * PI / 3.0, sign * 2.0 * PI, 0.0],
            cosine: vec![0.0, 0.0, 0.35],
            sine: vec![0.0; 3],
        };
        problem.solve().unwrap()
    };
    let (one, other) = (mode(1.0), mode(-1.0));
    for i in 0..40 {
        let place = [0.17 * f64::from(i % 10), 0.23 * f64::from(i % 9), 0.0];
        let time = 0.7 * f64::from(i / 10);
        let sum = one.at(place, time).into_iter().zip(other.at(place, time));
        for (a, (b, c)) in wave.at(place, time).iter().zip(sum) {
            assert!((a - b - c).abs() < 3e-14, "{place:?} {time}: {a} {b} {c}");
        }
    }
}

/// `∫ (eps E^2 + mu H^2)/2`, by the trapezoidal rule on a period, exact for trigonometric
/// polynomials.
#[test]
fn the_energy_stays() {
    let wave = cavity([1, 2]);
    let energy = |time: f64| {
        (0..400).fold(0.0, |sum, i| {
            let place = [0.15 * f64::from(i % 20), 0.1 * f64::from(i / 20), 0.0];
            let u = wave.at(place, time);
            sum + 0.5 * (1.5 * (u[0] * u[0] + u[1] * u[1]) + 0.8 * u[2] * u[2])
        })
    };
    for time in [0.1, 0.4, 1.7] {
        assert!((energy(time) / energy(0.0) - 1.0).abs() < 1e-13, "{time}");
    }
}

#[test]
fn numbers_out_of_range_are_named() {
    let good = cavity([1, 2]).problem;
    let text = |problem: MaxwellProblem| problem.solve().unwrap_err().to_string();
    let modes = [0, 0];
    let problem = MaxwellProblem { modes, ..good };
    assert_eq!(text(problem), "sum of modes must be > 0, not 0");
    let lengths = [1.0, -2.0];
    let problem = MaxwellProblem { lengths, ..good };
    assert_eq!(text(problem), "length along y must be > 0, not -2");
}
