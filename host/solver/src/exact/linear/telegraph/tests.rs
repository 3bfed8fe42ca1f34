//! The equations in all three cases, and the passage from one to the other.

use super::super::modes::tests::assert_is_a_mode;
use super::super::residual::{Probe, assert_holds};
use super::*;

/// k = 2 pi / 2 and L C = 0.8: w vanishes for |d| = 3.5.
fn line(resistance: f64, conductance: f64) -> Telegraph {
    let problem = TelegraphProblem {
        inductance: 2.0,
        capacitance: 0.4,
        resistance,
        conductance,
        wavelength: 2.0,
        amplitude: 1.3,
    };
    problem.solve().unwrap()
}

/// `R` for which `w^2` is 0 up to rounding, with G = 0: `R = 2 L d`, `d = k/sqrt(L C)`.
fn critical() -> f64 {
    4.0 * PI / 0.8_f64.sqrt()
}

fn cases() -> [Telegraph; 6] {
    [
        line(0.0, 0.0),
        line(1.0, 0.3),
        line(critical(), 0.0),
        line(30.0, 0.0),
        line(30.0, 0.2),
        line(0.1, 6.0),
    ]
}

#[test]
fn the_equations_hold() {
    let probe = Probe {
        center: [0.0; 3],
        size: 1.0,
        duration: 1.0,
        length: 0.3,
        pace: 0.07,
    };
    for telegraph in cases() {
        assert_holds(&telegraph.system(), &telegraph, probe);
    }
}

#[test]
fn it_is_a_mode_in_all_three_cases() {
    for telegraph in cases() {
        assert_is_a_mode(&telegraph, telegraph.system(), [PI, 0.0, 0.0]);
    }
    let signs = cases().map(|telegraph| telegraph.squared_frequency());
    assert!(signs[1] > 0.1 && signs[2].abs() < 1e-13 && signs[3] < -0.1);
}

/// The solution is smooth in R where the formula changes: on both sides of it the values differ
/// by what R differs.
#[test]
fn the_cases_pass_into_each_other() {
    for part in [1e-3, 1e-6, 1e-9, 1e-12] {
        let [under, over] = [1.0 - part, 1.0 + part].map(|f| line(f * critical(), 0.0));
        for i in 1..20 {
            let time = 0.1 * f64::from(i);
            let pairs = under.damped(time).into_iter().zip(over.damped(time));
            for (a, b) in pairs {
                assert!((a - b).abs() < 10.0 * part + 1e-14, "{part}: {a} {b}");
            }
        }
    }
    let (exactly, time) = (
        Telegraph {
            square: 0.0,
            ..line(critical(), 0.0)
        },
        0.7,
    );
    let fade = libm::exp(-exactly.mean * time);
    for (a, b) in exactly.damped(time).iter().zip([fade, fade * time]) {
        assert!((a - b).abs() < 1e-15, "{a} {b}");
    }
}

#[test]
fn it_starts_as_a_cosine_without_current() {
    let telegraph = line(1.0, 0.3);
    for i in 0..10 {
        let x = 0.37 * f64::from(i);
        let state = telegraph.at([x, 0.0, 0.0], 0.0);
        assert!((state[0] - 1.3 * (PI * x).cos()).abs() < 5e-15 && state[1] == 0.0);
    }
}

/// R/L = G/C: `V = A e^(-R t/L) cos(k x) cos(k t/sqrt(L C))`, Heaviside's line without distortion.
#[test]
fn a_line_without_distortion_only_fades() {
    let telegraph = line(1.0, 0.2);
    for i in 0..20 {
        let time = 0.2 * f64::from(i);
        let expected = 1.3 * (-0.5 * time).exp() * (PI * time / 0.8_f64.sqrt()).cos();
        let state = telegraph.at([0.0; 3], time);
        assert!((state[0] - expected).abs() < 1e-14, "{time}");
    }
}

#[test]
fn late_times_are_finite() {
    for telegraph in cases() {
        let state = telegraph.at([0.3, 0.0, 0.0], 1e4);
        assert!(state.iter().all(|u| u.abs() < 2.0), "{state:?}");
    }
}

#[test]
fn numbers_out_of_range_are_named() {
    let good = line(1.0, 0.3).problem;
    let text = |problem: TelegraphProblem| problem.solve().unwrap_err().to_string();
    let problem = TelegraphProblem {
        wavelength: -1.0,
        ..good
    };
    assert_eq!(text(problem), "wavelength must be > 0, not -1");
    let problem = TelegraphProblem {
        conductance: -0.1,
        ..good
    };
    assert_eq!(text(problem), "conductance must be >= 0, not -0.1");
}
