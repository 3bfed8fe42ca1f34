//! Exponentials known in closed form, the equation, and a check of the other solutions.

use super::super::residual::{Probe, assert_holds};
use super::*;

/// The mode that a wave of one wave vector is: u at k.x = 0 and at k.x = pi/2 at t = 0.
fn mode_of(solution: &dyn Solution, system: System, wave_vector: [f64; 3]) -> Mode {
    let square = dot(wave_vector, wave_vector);
    let quarter = wave_vector.map(|k| 0.5 * std::f64::consts::PI * k / square);
    let problem = ModeProblem {
        cosine: solution.at([0.0; 3], 0.0),
        sine: solution.at(quarter, 0.0),
        wave_vector,
        system,
    };
    problem.solve().unwrap()
}

/// That a wave of one wave vector is what the exponential makes of its start. The phases here are
/// below 60: both sides are good to 60 roundings of 2e-16, in each component as a part of the
/// largest of all.
pub(in super::super) fn assert_is_a_mode(
    solution: &dyn Solution,
    system: System,
    wave_vector: [f64; 3],
) {
    let mode = mode_of(solution, system, wave_vector);
    let (mut worst, mut size) = (0.0_f64, 0.0_f64);
    for i in 0..50 {
        let [x, y, z] = [0.31, -0.23, 0.17].map(|step| step * f64::from(i % 10));
        let place = [x, y, z];
        let beyond = |axis: usize| axis >= mode.problem.system.dimension();
        let place = std::array::from_fn(|axis| if beyond(axis) { 0.0 } else { place[axis] });
        let time = 0.4 * f64::from(i / 10);
        for (a, b) in solution.at(place, time).iter().zip(mode.at(place, time)) {
            worst = worst.max((a - b).abs());
            size = size.max(a.abs());
        }
    }
    assert!(worst < 2e-14 * size, "{worst:e} of {size}");
}

/// p = 3, two directions, nothing symmetric.
fn some_system() -> System {
    System {
        components: 3,
        fluxes: vec![
            vec![1.0, 2.0, 0.0, 0.5, -1.0, 0.3, 0.0, 0.3, 0.7],
            vec![0.2, 0.0, 1.0, 0.0, 0.9, 0.4, 1.0, 0.4, -0.6],
        ],
        reaction: vec![0.3, -0.5, 0.0, 0.5, 0.1, 0.0, 0.2, 0.0, 0.0],
    }
}

fn some_mode() -> ModeProblem {
    ModeProblem {
        system: some_system(),
        wave_vector: [1.3, -0.7, 0.0],
        cosine: vec![1.0, -0.4, 0.3],
        sine: vec![0.2, 0.8, -0.5],
    }
}

#[test]
fn the_equation_holds() {
    let probe = Probe {
        center: [0.0; 3],
        size: 3.0,
        duration: 3.0,
        length: 0.7,
        pace: 0.4,
    };
    assert_holds(&some_system(), &some_mode().solve().unwrap(), probe);
}

/// One number: `u = e^(-d t) cos(k (x - c t))`.
#[test]
fn transport_with_decay_is_what_it_should_be() {
    let (c, d, k) = (1.7, 0.3, 2.1);
    let system = System::zero(1, 1).flux(0, [0, 0], c).reaction([0, 0], d);
    let problem = ModeProblem {
        system,
        wave_vector: [k, 0.0, 0.0],
        cosine: vec![1.0],
        sine: vec![0.0],
    };
    let mode = problem.solve().unwrap();
    // Angles up to 360: rounding of 4e-14 in each.
    for i in 0..100 {
        let (x, t) = (0.3 * f64::from(i % 7), f64::from(i));
        let expected = (-d * t).exp() * (k * (x - c * t)).cos();
        let error = mode.at([x, 0.0, 0.0], t)[0] - expected;
        assert!(
            error.abs() < 1e-13 * (-d * t).exp() * (1.0 + t),
            "{t}: {error:e}"
        );
    }
}

/// A nilpotent matrix: `e^M = 1 + M + M^2/2` however large.
#[test]
fn the_exponential_of_a_nilpotent_matrix_is_a_polynomial() {
    let m = [0.0, 1e6, 3.0, 0.0, 0.0, -20.0, 0.0, 0.0, 0.0];
    let expected = [1.0, 1e6, 3.0 - 1e7, 0.0, 1.0, -20.0, 0.0, 0.0, 1.0];
    for (a, b) in exponential(&m, 3).iter().zip(expected) {
        assert!((a - b).abs() <= 1e-13 * b.abs(), "{a} {b}");
    }
}

/// e^M e^-M = 1: errors of 1e-16 |M| in factors of e^|M|.
#[test]
fn the_exponential_of_the_negative_is_the_inverse() {
    let m: Vec<f64> = (0..256)
        .map(|i| 0.2 * f64::from(i % 17 - 8))
        .map(f64::sin)
        .collect();
    let m: Vec<f64> = m.iter().map(|entry| 0.2 * entry).collect();
    let minus: Vec<f64> = m.iter().map(|entry| -entry).collect();
    let one = product(&exponential(&m, 16), &exponential(&minus, 16), 16);
    for (i, entry) in one.iter().enumerate() {
        let expected = if i % 17 == 0 { 1.0 } else { 0.0 };
        assert!((entry - expected).abs() < 1e-12, "{i}: {entry}");
    }
}

#[test]
fn times_in_any_order_give_the_same_bits() {
    let mode = some_mode().solve().unwrap();
    let x = [0.3, 0.4, 0.0];
    let first = mode.at(x, 1.5);
    let other = mode.at(x, 0.7);
    assert_ne!(first, other);
    assert_eq!(first, mode.at(x, 1.5));
    assert_eq!(first, some_mode().solve().unwrap().at(x, 1.5));
}

#[test]
fn what_is_wrong_is_named() {
    let text = |problem: ModeProblem| problem.solve().unwrap_err().to_string();
    let mut problem = some_mode();
    problem.sine.pop();
    assert_eq!(text(problem), "sine must have 3 numbers, not 2");
    let mut problem = some_mode();
    problem.system.fluxes[1].pop();
    assert_eq!(text(problem), "A^2 must have 9 numbers, not 8");
    let mut problem = some_mode();
    problem.system.reaction[3] = f64::NAN;
    assert_eq!(text(problem), "A^0 must be finite, not NaN");
    let mut problem = some_mode();
    problem.wave_vector[2] = 1.0;
    let expected = "wave_vector must be zero beyond the dimension, not 1";
    assert_eq!(text(problem), expected);
    let mut problem = some_mode();
    problem.system.components = 9;
    assert_eq!(text(problem), "components must be 1 to 8, not 9");
}
