//! The Euler equations, uniform entropy, and the periodic box.

use super::super::residual::euler_residual;
use super::*;

fn vortex(gamma: f64, strength: f64, centre: MovingCentre) -> YeeVortex {
    let problem = YeeVortexProblem {
        gamma,
        strength,
        centre,
    };
    problem.solve().unwrap()
}

const MOVING: MovingCentre = MovingCentre {
    position: [0.5, -0.25],
    velocity: [1.0, 0.5],
    period: Some([16.0, 12.0]),
};

/// Differences of fourth order with a step of 7e-4: 2e-13 times a fifth derivative of
/// `x e^(-x^2)`, some hundred in the strongest vortex here.
#[test]
fn the_euler_equations_hold_at_rest_and_moving() {
    for centre in [MovingCentre::ORIGIN, MOVING] {
        for (gamma, strength) in [(1.4, 5.0), (5.0 / 3.0, -3.0), (2.0, 0.1)] {
            let flow = vortex(gamma, strength, centre);
            for [x, y] in [
                [0.0, 0.1],
                [0.7, 0.7],
                [-1.0, 0.4],
                [2.0, -1.0],
                [-9.0, 0.0],
            ] {
                let residual = euler_residual(&flow, [x, y, 0.3], 0.7, 1.0);
                assert!(residual < 1e-10, "{strength} at {x} {y}: {residual:e}");
            }
        }
    }
}

#[test]
fn the_entropy_is_uniform_and_the_temperature_that_of_the_paper() {
    let flow = vortex(1.4, 5.0, MovingCentre::ORIGIN);
    for i in 0..40 {
        let x = 0.1 * f64::from(i);
        let state = flow.at([x, 0.0, 0.0], 0.0);
        let entropy = state.pressure / state.density.powf(1.4);
        assert!((entropy - 1.0).abs() < 1e-14, "{x}");
        let t = 1.0 - 0.4 * 25.0 / (8.0 * 1.4 * PI * PI) * (1.0 - x * x).exp();
        assert!((state.pressure / state.density / t - 1.0).abs() < 1e-14);
    }
}

/// After one period of both axes it is back, to the rounding of places up to 100.
#[test]
fn it_returns_after_a_period() {
    // 16 / 1 and 12 / 0.5 divide 48.
    let flow = vortex(1.4, 5.0, MOVING);
    for place in [[0.3, 0.1, 0.0], [7.9, -5.0, 0.0], [-7.0, 5.7, 1.0]] {
        let (a, b) = (flow.at(place, 0.0), flow.at(place, 48.0));
        assert!((a.density - b.density).abs() < 1e-13, "{a:?} {b:?}");
        for (a, b) in a.velocity.into_iter().zip(b.velocity) {
            assert!((a - b).abs() < 1e-13, "{a} {b}");
        }
    }
}

#[test]
fn numbers_out_of_range_are_named() {
    let problem = |strength: f64, centre: MovingCentre| YeeVortexProblem {
        gamma: 1.4,
        strength,
        centre,
    };
    assert!(problem(10.08, MOVING).solve().is_ok());
    let error = problem(10.09, MOVING).solve().unwrap_err().to_string();
    assert!(error.starts_with("strength = 10.09 is out"), "{error}");
    let period = Some([1.0, 0.0]);
    let error = problem(5.0, MovingCentre { period, ..MOVING }).solve();
    let text = error.unwrap_err().to_string();
    assert_eq!(text, "period y = 0 is out of range: need > 0");
}
