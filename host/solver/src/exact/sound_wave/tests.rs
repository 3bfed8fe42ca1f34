//! The Euler equations, the linear limit, and the time of breaking.

use super::super::residual::euler_residual;
use super::*;

fn wave(gamma: f64, amplitude: f64) -> SoundWave {
    let problem = SoundWaveProblem {
        gamma,
        density: 1.2,
        pressure: 0.9,
        amplitude,
        wavelength: 0.5,
    };
    problem.solve().unwrap()
}

fn along(flow: &SoundWave, x: f64, time: f64) -> FlowState {
    flow.at([x, 0.3, -0.2], time)
}

/// Differences of fourth order with a step of 7e-4 / k: 2e-13 times derivatives of the fifth
/// order, which half-way to breaking are 2^9 of those at the start (a few tens of A); and
/// rounding, 1e-13 times the coefficients.
#[test]
fn the_euler_equations_hold_until_it_breaks() {
    for gamma in [1.4, 5.0 / 3.0, 3.0, 4.0] {
        for amplitude in [1e-3, 0.1, -0.5] {
            let flow = wave(gamma, amplitude);
            for part in [0.1, 0.5] {
                for i in 0..10 {
                    let (x, time) = (0.05 * f64::from(i), part * flow.breaking_time());
                    let residual = euler_residual(&flow, [x, 0.0, 0.0], time, 0.5 / (2.0 * PI));
                    assert!(
                        residual < 2e-10 + 4e-9 * amplitude.abs(),
                        "gamma = {gamma}, A = {amplitude}, x = {x}: {residual:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_initial_state_is_the_sine_in_the_density() {
    let flow = wave(1.4, 0.1);
    for i in -20..20 {
        let x = 0.037 * f64::from(i);
        let state = along(&flow, x, 0.0);
        let expected = 1.2 * (1.0 + 0.1 * (2.0 * PI * x / 0.5).sin());
        assert!((state.density / expected - 1.0).abs() < 2e-15, "{x}");
        let entropy = (state.pressure / 0.9) / (state.density / 1.2).powf(1.4);
        assert!((entropy - 1.0).abs() < 1e-15, "{x}");
    }
}

/// The difference from the linear wave is of order A^2: a tenth of A, a hundredth of it.
#[test]
fn a_small_wave_is_the_linear_one_to_first_order() {
    let difference = |amplitude: f64| {
        let flow = wave(1.4, amplitude);
        let (c, time) = (flow.sound_speed(), 0.5 / flow.sound_speed());
        (0..50).fold(0.0, |worst: f64, i| {
            let x = 0.01 * f64::from(i);
            let state = along(&flow, x, time);
            let sine = amplitude * (2.0 * PI * (x - c * time) / 0.5).sin();
            let errors = [
                state.density / 1.2 - 1.0 - sine,
                state.velocity[0] / c - sine,
                state.pressure / 0.9 - 1.0 - 1.4 * sine,
            ];
            errors.into_iter().fold(worst, |w, e| w.max(e.abs()))
        })
    };
    let [coarse, fine] = [1e-4, 1e-5].map(difference);
    let order = (coarse / fine).log10();
    assert!((order - 2.0).abs() < 0.01, "order {order}, {fine:e}");
}

/// At 0.999 of the breaking time xi -> x still rises everywhere, at 1.001 no longer.
#[test]
fn characteristics_first_meet_at_the_breaking_time() {
    for gamma in [1.4, 2.0, 4.0] {
        for amplitude in [0.01, -0.3, 0.8] {
            let flow = wave(gamma, amplitude);
            let rises = |time: f64| {
                let place = |i: i32| {
                    let xi = 0.5e-4 * f64::from(i);
                    xi + flow.characteristic(xi).2 * time
                };
                (0..10_000).all(|i| place(i + 1) > place(i))
            };
            let time = flow.breaking_time();
            assert!(rises(0.999 * time), "gamma = {gamma}, A = {amplitude}");
            assert!(!rises(1.001 * time), "gamma = {gamma}, A = {amplitude}");
        }
    }
    assert_eq!(wave(1.4, 0.0).breaking_time(), f64::INFINITY);
}

#[test]
fn it_is_periodic() {
    let flow = wave(1.4, 0.25);
    // 1 wavelength = 2^-1 and x in multiples of 2^-7, so that x + 2 is exact.
    for i in 0..64 {
        let x = f64::from(i) / 128.0;
        let (a, b) = (along(&flow, x, 0.05), along(&flow, x + 2.0, 0.05));
        assert!((a.density / b.density - 1.0).abs() < 1e-13, "{x}");
    }
}

#[test]
fn numbers_out_of_range_are_named() {
    let good = wave(1.4, 0.1).problem;
    let error = SoundWaveProblem {
        amplitude: 1.0,
        ..good
    };
    let text = error.solve().unwrap_err().to_string();
    assert_eq!(text, "amplitude = 1 is out of range: need > -1 and < 1");
}
