//! The equations, the starts, and the radial integrals.

use super::super::modes::tests::assert_is_a_mode;
use super::super::plane_wave::PlaneWave;
use super::super::residual::{Probe, assert_holds};
use super::plane::*;
use super::pulse::*;
use super::radial::*;
use super::*;
use crate::exact::solution::Solution;

const MEDIUM: Medium = Medium {
    density: 1.3,
    sound_speed: 0.8,
};

const PROBE: Probe = Probe {
    center: [0.2, -0.1, 0.3],
    size: 1.5,
    duration: 2.0,
    length: 0.3,
    pace: 0.4,
};

fn pulses() -> [Pulse; 3] {
    let gaussian = |period| Pulse::Gaussian {
        center: 0.3,
        width: 0.6,
        amplitude: -1.4,
        period,
    };
    let (length, lower) = (3.0, -0.4);
    [
        Pulse::ExpSine { length, lower },
        gaussian(None),
        gaussian(Some(2.0)),
    ]
}

fn pulse(pulse: Pulse) -> AcousticPulse {
    let problem = AcousticPulseProblem {
        medium: MEDIUM,
        pulse,
    };
    problem.solve().unwrap()
}

fn plane(dimension: usize) -> AcousticWave {
    let mut wave_vector = [1.2, -2.0, 0.9];
    wave_vector[dimension..].fill(0.0);
    let problem = AcousticWaveProblem {
        medium: MEDIUM,
        dimension,
        wave: PlaneWave {
            wave_vector,
            amplitude: 0.7,
        },
    };
    problem.solve().unwrap()
}

fn radial() -> RadialPulse {
    let problem = RadialPulseProblem {
        medium: MEDIUM,
        center: [0.1, -0.2],
        width: 0.7,
        amplitude: 1.4,
    };
    problem.solve().unwrap()
}

#[test]
fn the_equations_hold() {
    for shape in pulses() {
        let solution = pulse(shape);
        assert_holds(&solution.system(), &solution, PROBE);
    }
    for dimension in 1..=3 {
        let solution = plane(dimension);
        assert_holds(&solution.system(), &solution, PROBE);
    }
    assert_holds(&radial().system(), &radial(), PROBE);
}

#[test]
fn a_plane_wave_is_a_mode() {
    for (dimension, vector) in [
        (1, [1.2, 0.0, 0.0]),
        (2, [1.2, -2.0, 0.0]),
        (3, [1.2, -2.0, 0.9]),
    ] {
        let wave = plane(dimension);
        assert_is_a_mode(&wave, wave.system(), vector);
    }
}

#[test]
fn a_pulse_starts_as_its_shape_at_rest() {
    for shape in pulses() {
        for i in -10..10 {
            let x = 0.23 * f64::from(i);
            assert_eq!(pulse(shape).at([x, 0.0, 0.0], 0.0), [shape.at(x), 0.0]);
        }
    }
    let [sine, gaussian, _] = pulses();
    // Half way down the first length, and one width from the centre.
    assert!((sine.at(-0.4 + 0.75) - 1.0_f64.exp()).abs() < 1e-15);
    assert!((gaussian.at(0.9) + 1.4 * (-1.0_f64).exp()).abs() < 1e-15);
}

/// After the time `length / c` all is as it was.
#[test]
fn a_periodic_pulse_returns() {
    let [sine, _, gaussian] = pulses();
    for (shape, length) in [(sine, 3.0), (gaussian, 2.0)] {
        let solution = pulse(shape);
        for i in 0..20 {
            let x = 0.15 * f64::from(i);
            let [a, b] = [0.0, length / 0.8].map(|time| solution.at([x, 0.0, 0.0], time));
            assert!((a[0] - b[0]).abs() < 1e-14 && b[1].abs() < 1e-14, "{x}");
        }
    }
}

/// Rounding of sums of 16 terms a panel that cancel to at most 1: some 1e-15.
#[test]
fn a_ring_starts_as_the_gaussian_at_rest() {
    for i in 0..12 {
        let r = 0.3 * f64::from(i);
        let state = radial().at([0.1 - 0.6 * r, -0.2 + 0.8 * r, 0.0], 0.0);
        let expected = 1.4 * (-(r / 0.7) * (r / 0.7)).exp();
        assert!((state[0] - expected).abs() < 5e-15, "{r}: {state:?}");
        assert_eq!([state[1], state[2]], [0.0; 2]);
    }
}

/// In the centre `p = A (1 - 2 tau D(tau))`, D Dawson's integral,
/// `D = e^(-tau^2) Σ_n tau^(2n+1) / (n! (2n+1))`: up to 400 terms, all positive, of which those
/// count that are within `tau` of `n = tau^2`: some 200 roundings of 2 tau D, which is about 1.
#[test]
fn in_the_centre_a_ring_is_dawson_s_integral() {
    for tau in [0.1_f64, 0.5, 1.0, 2.0, 5.0, 10.0] {
        let (mut power, mut dawson) = (tau * (-tau * tau).exp(), 0.0);
        for n in 0..400 {
            let n = f64::from(n);
            dawson += power / (2.0 * n + 1.0);
            power *= tau * tau / (n + 1.0);
        }
        let expected = 1.4 * (1.0 - 2.0 * tau * dawson);
        let state = radial().at([0.1, -0.2, 0.0], tau * 0.7 / 0.8);
        assert!((state[0] - expected).abs() < 5e-14, "{tau}: {state:?}");
        assert_eq!([state[1], state[2]], [0.0; 2]);
    }
}

/// Panels of a third differ by rounding only: up to 17,000 terms, whose magnitudes sum to 1.
#[test]
fn the_integrals_are_good_to_1e_14() {
    let solution = radial();
    for rho in [0.0, 0.01, 1.0, 7.0, 40.0, 206.0] {
        for tau in [0.0, 0.01, 1.0, 7.0, 40.0, 200.0] {
            let coarse = solution.integrals(rho, tau, 7.0);
            let fine = solution.integrals(rho, tau, 7.0 / 3.0);
            for (a, b) in coarse.iter().zip(fine) {
                assert!((a - b).abs() < 1e-14, "rho {rho}, tau {tau}: {a} {b}");
            }
        }
    }
}

#[test]
fn ahead_of_the_ring_there_is_nothing() {
    for tau in [0.0, 3.0, 100.0] {
        let [p, v] = radial().integrals(tau + 6.49, tau, 7.0);
        assert!(p.abs() < 1e-14 && v.abs() < 1e-14, "{tau}: {p:e} {v:e}");
        assert_eq!(radial().integrals(tau + 6.51, tau, 7.0), [0.0; 2]);
    }
}

#[test]
fn numbers_out_of_range_are_named() {
    let medium = Medium {
        density: 0.0,
        ..MEDIUM
    };
    let [sine, ..] = pulses();
    let problem = AcousticPulseProblem {
        medium,
        pulse: sine,
    };
    let text = problem.solve().unwrap_err().to_string();
    assert_eq!(text, "density must be > 0, not 0");
    let problem = AcousticWaveProblem {
        medium: MEDIUM,
        dimension: 1,
        wave: PlaneWave {
            wave_vector: [1.0, -2.0, 0.0],
            amplitude: 1.0,
        },
    };
    let text = problem.solve().unwrap_err().to_string();
    assert_eq!(text, "wave_vector must be zero beyond the dimension, not 2");
    let wave = PlaneWave {
        amplitude: 1.0,
        ..PlaneWave::NONE
    };
    let text = AcousticWaveProblem { wave, ..problem };
    let text = text.solve().unwrap_err().to_string();
    assert_eq!(text, "wave_vector must be finite and not zero, not 0");
}
