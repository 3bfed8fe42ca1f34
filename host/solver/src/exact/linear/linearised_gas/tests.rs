//! The equations, the modes it is made of, and the limit of the nonlinear wave.

use super::super::super::flow::Flow;
use super::super::super::sound_wave::SoundWaveProblem;
use super::super::modes::tests::assert_is_a_mode;
use super::super::residual::{Probe, assert_holds};
use super::*;

fn wave(dimension: usize, mut wave_vector: [f64; 3], amplitude: f64) -> PlaneWave {
    wave_vector[dimension..].fill(0.0);
    PlaneWave {
        wave_vector,
        amplitude,
    }
}

/// Sound, entropy and vorticity.
fn waves(dimension: usize) -> [PlaneWave; 3] {
    let turning = if dimension > 1 { 0.6 } else { 0.0 };
    [
        wave(dimension, [1.2, -2.0, 0.5], 0.7),
        wave(dimension, [0.8, 1.9, -1.0], -0.4),
        wave(dimension, [-1.1, 0.6, 1.4], turning),
    ]
}

fn gas(dimension: usize, [sound, entropy, vorticity]: [PlaneWave; 3]) -> LinearisedGas {
    let mut velocity = [0.5, -0.3, 0.2];
    velocity[dimension..].fill(0.0);
    let problem = LinearisedGasProblem {
        dimension,
        density: 1.3,
        velocity,
        pressure: 0.9,
        gamma: 1.4,
        sound,
        entropy,
        vorticity,
    };
    problem.solve().unwrap()
}

#[test]
fn the_equations_hold() {
    let probe = Probe {
        center: [0.0; 3],
        size: 2.0,
        duration: 3.0,
        length: 0.4,
        pace: 0.25,
    };
    for dimension in 1..=3 {
        let gas = gas(dimension, waves(dimension));
        assert_holds(&gas.system(), &gas, probe);
    }
}

#[test]
fn each_wave_is_a_mode() {
    for dimension in 1..=3 {
        for kind in 0..3 {
            let wave = waves(dimension)[kind];
            if wave.amplitude == 0.0 {
                continue;
            }
            let mut only = [PlaneWave::NONE; 3];
            only[kind] = wave;
            let gas = gas(dimension, only);
            assert_is_a_mode(&gas, gas.system(), wave.wave_vector);
        }
    }
}

/// The sound wave of finite amplitude differs by the square of its amplitude, 1e-6 relative.
#[test]
fn sound_is_the_limit_of_the_nonlinear_wave() {
    let amplitude = 1e-6;
    let nonlinear = SoundWaveProblem {
        gamma: 1.4,
        density: 1.3,
        pressure: 0.9,
        amplitude,
        wavelength: 2.0,
    };
    let nonlinear = nonlinear.solve().unwrap();
    let sound = wave(1, [std::f64::consts::PI, 0.0, 0.0], 1.3 * amplitude);
    let mut problem = gas(1, [sound, PlaneWave::NONE, PlaneWave::NONE]).problem;
    problem.velocity = [0.0; 3];
    let linear = problem.solve().unwrap();
    for i in 0..20 {
        let (x, time) = (0.1 * f64::from(i), 0.7);
        // A quarter of a wave from cos to sin.
        let flow = nonlinear.at([x + 0.5, 0.0, 0.0], time);
        let state = linear.at([x, 0.0, 0.0], time);
        let errors = [
            flow.density - 1.3 - state[0],
            flow.velocity[0] - state[1],
            flow.pressure - 0.9 - state[2],
        ];
        for error in errors {
            assert!(error.abs() < 20.0 * amplitude * amplitude, "{error:e}");
        }
    }
}

/// Sound has no vorticity, vorticity no divergence, and both are carried along.
#[test]
fn without_sound_nothing_happens_to_the_moving_gas() {
    for dimension in 1..=3 {
        let [_, entropy, vorticity] = waves(dimension);
        let gas = gas(dimension, [PlaneWave::NONE, entropy, vorticity]);
        let velocity = gas.problem.velocity;
        for i in 0..10 {
            let x = [0.3 * f64::from(i), 0.0, 0.0];
            let moved = std::array::from_fn(|axis| x[axis] + 2.0 * velocity[axis]);
            for (a, b) in gas.at(x, 0.0).iter().zip(gas.at(moved, 2.0)) {
                assert!((a - b).abs() < 1e-14);
            }
            assert_eq!(gas.at(x, 0.0)[1 + dimension], 0.0);
        }
    }
}

#[test]
fn numbers_out_of_range_are_named() {
    let good = gas(1, waves(1)).problem;
    let text = |problem: LinearisedGasProblem| problem.solve().unwrap_err().to_string();
    let vorticity = wave(1, [1.0; 3], 0.5);
    let problem = LinearisedGasProblem { vorticity, ..good };
    assert_eq!(
        text(problem),
        "vorticity must be 0 in one dimension, not 0.5"
    );
    let velocity = [0.0, 2.0, 0.0];
    let problem = LinearisedGasProblem { velocity, ..good };
    assert_eq!(
        text(problem),
        "velocity must be zero beyond the dimension, not 2"
    );
    let problem = LinearisedGasProblem { gamma: 1.0, ..good };
    assert_eq!(text(problem), "gamma must be > 1, not 1");
}
