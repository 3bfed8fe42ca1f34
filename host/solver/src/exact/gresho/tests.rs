//! The Euler equations, the seams of the three rings, and the Mach number.

use super::super::residual::euler_residual;
use super::*;

fn gresho(central_pressure: f64, velocity: [f64; 2]) -> Gresho {
    let centre = MovingCentre {
        position: [0.5, 0.5],
        velocity,
        period: Some([1.0; 2]),
    };
    let problem = GreshoProblem {
        gamma: 1.4,
        central_pressure,
        centre,
    };
    problem.solve().unwrap()
}

/// Differences of fourth order with a step of 7e-5 inside each ring: 2e-13 times the fifth
/// derivative of ln r at 0.22 in units of 0.1, about one; the energy, dominated by the
/// pressure, loses some digits.
#[test]
fn the_euler_equations_hold_at_rest_and_moving() {
    for velocity in [[0.0; 2], [1.0, -0.5]] {
        let flow = gresho(5.0, velocity);
        for [x, y] in [
            [0.01, 0.02],
            [0.1, -0.1],
            [0.22, 0.1],
            [-0.3, 0.1],
            [0.4, 0.4],
        ] {
            let place = [
                0.5 + x + velocity[0] * 2.3,
                0.5 + y + velocity[1] * 2.3,
                0.0,
            ];
            let residual = euler_residual(&flow, place, 2.3, 0.1);
            assert!(residual < 1e-10, "{velocity:?} at {x} {y}: {residual:e}");
        }
    }
}

/// Speed, and pressure with its slope `rho u^2/r`, are continuous at the seams.
#[test]
fn the_rings_join() {
    let flow = gresho(5.0, [0.0; 2]);
    let at = |r: f64| flow.at([0.5 + r, 0.5, 0.0], 0.0);
    for (r, speed, pressure) in [
        (0.2, 1.0, 5.5),
        (0.4, 0.0, 3.0 + 4.0 * std::f64::consts::LN_2),
    ] {
        for state in [at(r - 1e-12), at(r + 1e-12)] {
            assert!((state.velocity[1] - speed).abs() < 1e-11, "{state:?}");
            assert!((state.pressure - pressure).abs() < 1e-11, "{state:?}");
            assert_eq!(state.density, 1.0);
        }
    }
}

#[test]
fn the_central_pressure_of_a_mach_number_gives_it_to_the_fastest_gas() {
    for mach in [0.01, 0.1, 0.36, 1.0] {
        let p = GreshoProblem::central_pressure_of_mach(mach, 1.4);
        let fastest = gresho(p, [0.0; 2]).at([0.7, 0.5, 0.0], 0.0);
        let sound = (1.4 * fastest.pressure / fastest.density).sqrt();
        let measured = fastest.velocity[1] / sound;
        assert!((measured / mach - 1.0).abs() < 1e-14, "{measured}");
    }
}

#[test]
fn after_one_crossing_of_the_box_it_is_back() {
    let flow = gresho(5.0, [1.0, -0.5]);
    for place in [[0.6, 0.55, 0.0], [0.9, 0.4, 0.0], [0.31, 0.77, 0.0]] {
        let (a, b) = (flow.at(place, 0.0), flow.at(place, 2.0));
        assert!((a.pressure - b.pressure).abs() < 1e-14, "{a:?} {b:?}");
        assert!((a.velocity[0] - b.velocity[0]).abs() < 1e-14);
    }
}

#[test]
fn numbers_out_of_range_are_named() {
    let problem = GreshoProblem {
        gamma: 1.4,
        central_pressure: GreshoProblem::central_pressure_of_mach(1.2, 1.4),
        centre: MovingCentre::ORIGIN,
    };
    let text = problem.solve().unwrap_err().to_string();
    assert!(text.starts_with("central pressure = -0.00"), "{text}");
}
