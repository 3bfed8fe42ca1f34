//! The equations, and what rotation does.

use super::super::modes::tests::assert_is_a_mode;
use super::super::residual::{Probe, assert_holds};
use super::*;

const VECTOR: [f64; 3] = [1.2, -2.0, 0.0];

fn water(coriolis: f64) -> ShallowWater {
    let problem = ShallowWaterProblem {
        depth: 0.7,
        gravity: 2.0,
        coriolis,
        wave: PlaneWave {
            wave_vector: VECTOR,
            amplitude: 0.3,
        },
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
        pace: 0.3,
    };
    for coriolis in [0.0, 1.5, -4.0] {
        assert_holds(&water(coriolis).system(), &water(coriolis), probe);
    }
}

#[test]
fn it_is_a_mode() {
    for coriolis in [0.0, 1.5, -4.0] {
        assert_is_a_mode(&water(coriolis), water(coriolis).system(), VECTOR);
    }
}

/// `eta_t + H div v = 0` and of the curl `zeta_t + f div v = 0`, so that `zeta - f eta/H` stays
/// as it is: for a wave 0. Only the part of v across k has a curl, `|k| cos phi` times it.
#[test]
fn the_potential_vorticity_is_zero() {
    let wave = water(1.5);
    let k = wave.problem.wave.wave_number();
    let across = (wave.across[0] * wave.across[0] + wave.across[1] * wave.across[1]).sqrt();
    assert!((across * k / 0.3 - 1.5 / 0.7).abs() < 1e-14);
}

#[test]
fn rotation_makes_it_faster() {
    let k_squared = 1.2 * 1.2 + 2.0 * 2.0;
    for coriolis in [0.0, 1.5, -4.0] {
        let expected = coriolis * coriolis + 1.4 * k_squared;
        let frequency = water(coriolis).frequency();
        assert!((frequency * frequency / expected - 1.0).abs() < 1e-15);
    }
}

#[test]
fn numbers_out_of_range_are_named() {
    let good = water(1.5).problem;
    let text = |problem: ShallowWaterProblem| problem.solve().unwrap_err().to_string();
    let problem = ShallowWaterProblem {
        depth: -2.0,
        ..good
    };
    assert_eq!(text(problem), "depth must be > 0, not -2");
    let wave = PlaneWave::NONE;
    let problem = ShallowWaterProblem { wave, ..good };
    assert_eq!(text(problem), "wave number must be > 0, not 0");
}
