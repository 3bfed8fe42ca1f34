//! The equations, the modes it is made of, and the kinds of its waves.

use super::super::modes::tests::assert_is_a_mode;
use super::super::plane_wave::dot;
use super::super::residual::{Probe, assert_holds};
use super::*;

const PRESSURE: PlaneWave = PlaneWave {
    wave_vector: [1.2, -2.0, 0.0],
    amplitude: 0.7,
};

const SHEAR: PlaneWave = PlaneWave {
    wave_vector: [0.8, 1.9, 0.0],
    amplitude: -0.4,
};

fn solid(pressure_wave: PlaneWave, shear_wave: PlaneWave) -> Elastic {
    let problem = ElasticProblem {
        density: 1.3,
        lambda: 2.1,
        mu: 0.9,
        pressure_wave,
        shear_wave,
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
    let both = solid(PRESSURE, SHEAR);
    assert_holds(&both.system(), &both, probe);
}

#[test]
fn each_wave_is_a_mode() {
    let pressure = solid(PRESSURE, PlaneWave::NONE);
    assert_is_a_mode(&pressure, pressure.system(), PRESSURE.wave_vector);
    let shear = solid(PlaneWave::NONE, SHEAR);
    assert_is_a_mode(&shear, shear.system(), SHEAR.wave_vector);
}

#[test]
fn both_waves_are_the_sum_of_each() {
    let [both, pressure, shear] = [
        solid(PRESSURE, SHEAR),
        solid(PRESSURE, PlaneWave::NONE),
        solid(PlaneWave::NONE, SHEAR),
    ];
    for i in 0..20 {
        let (place, time) = ([0.3 * f64::from(i), -0.7, 0.0], 0.2 * f64::from(i));
        let parts = pressure
            .at(place, time)
            .into_iter()
            .zip(shear.at(place, time));
        for (sum, (a, b)) in both.at(place, time).iter().zip(parts) {
            assert!((sum - a - b).abs() < 1e-15);
        }
    }
}

/// Pressure waves move along k, shear waves across and without change of the pressure.
#[test]
fn the_waves_are_of_pressure_and_of_shear() {
    let both = solid(PRESSURE, SHEAR);
    let [p, s] = both.crests;
    assert!(dot([p[0], p[1], 0.0], PRESSURE.across()).abs() < 1e-15);
    assert!(dot([s[0], s[1], 0.0], SHEAR.wave_vector).abs() < 1e-15);
    assert!((s[2] + s[3]).abs() < 1e-15);
    let [c_p, c_s] = both.speeds();
    assert!((c_p * c_p * 1.3 - 3.9).abs() < 1e-15 * 8.0);
    assert!((c_s * c_s * 1.3 - 0.9).abs() < 1e-15);
}

#[test]
fn numbers_out_of_range_are_named() {
    let good = solid(PRESSURE, SHEAR).problem;
    let text = |problem: ElasticProblem| problem.solve().unwrap_err().to_string();
    let problem = ElasticProblem {
        lambda: -0.9,
        ..good
    };
    assert_eq!(text(problem), "lambda must be > -mu, not -0.9");
    let shear_wave = PlaneWave {
        amplitude: 1.0,
        ..PlaneWave::NONE
    };
    let problem = ElasticProblem { shear_wave, ..good };
    let expected = "wave_vector of the shear wave must be finite and not zero, not 0";
    assert_eq!(text(problem), expected);
}
