//! The Euler equations, the jump conditions and the published densities.

use super::super::residual::euler_residual;
use super::*;

fn noh(dimension: usize, gamma: f64, pressure: f64) -> Noh {
    let problem = NohProblem {
        dimension,
        gamma,
        density: 1.5,
        speed: 0.8,
        pressure,
    };
    problem.solve().unwrap()
}

#[test]
fn the_density_behind_the_shock_is_4_16_and_64_times_the_first() {
    for (dimension, times) in [(1, 4.0), (2, 16.0), (3, 64.0)] {
        let inside = noh(dimension, 5.0 / 3.0, 0.0).at([1e-3, 0.0, 0.0], 0.6);
        let error = (inside.density / (1.5 * times) - 1.0).abs();
        assert!(error < 1e-14, "{dimension}: {inside:?}");
        assert_eq!(inside.velocity, [0.0; 3]);
    }
}

/// Across the shock the fluxes of mass, momentum and energy agree. Rounding: some ten
/// operations of 1e-16 each.
#[test]
fn the_jump_conditions_hold() {
    for dimension in 1..=3 {
        for gamma in [1.4, 5.0 / 3.0, 2.0] {
            let flow = noh(dimension, gamma, 0.0);
            let (time, speed) = (0.7, flow.shock_radius(1.0));
            let r = flow.shock_radius(time);
            let flux = |place: f64| {
                let state = flow.at([-place, 0.0, 0.0], time);
                let u = -state.velocity[0] - speed;
                let mass = state.density * u;
                let enthalpy = state.energy + state.pressure / state.density;
                [
                    mass,
                    mass * u + state.pressure,
                    mass * (enthalpy + 0.5 * u * u),
                ]
            };
            let (inside, outside) = (flux(r * (1.0 - 1e-15)), flux(r * (1.0 + 1e-15)));
            for (a, b) in inside.into_iter().zip(outside) {
                let error = (a / b - 1.0).abs();
                assert!(error < 1e-13, "D = {dimension}: {inside:?} {outside:?}");
            }
        }
    }
}

/// Differences of fourth order with a step of 7e-4: 2e-13, times derivatives of a few.
#[test]
fn the_inflow_satisfies_the_euler_equations() {
    let places = [[0.5, 0.0, 0.0], [-0.4, 0.3, 0.0], [0.3, -0.4, 0.5]];
    for (dimension, place) in (1..=3).zip(places) {
        let residual = euler_residual(&noh(dimension, 1.4, 0.0), place, 0.3, 0.5);
        assert!(residual < 1e-10, "D = {dimension}: {residual:e}");
    }
}

#[test]
fn the_inflow_has_its_speed_from_both_sides_and_its_pressure() {
    let flow = noh(1, 1.4, 1e-6);
    for (x, u) in [(-2.0, 0.8), (2.0, -0.8)] {
        let state = flow.at([x, 7.0, 7.0], 0.1);
        assert_eq!(state.velocity, [u, 0.0, 0.0]);
        assert_eq!((state.density, state.pressure), (1.5, 1e-6));
    }
    let centre = noh(3, 1.4, 1e-6).at([0.0; 3], 0.0);
    assert_eq!((centre.density, centre.velocity), (1.5, [0.0; 3]));
}

#[test]
fn numbers_out_of_range_are_named() {
    let good = noh(3, 1.4, 0.0).problem;
    let error = NohProblem {
        dimension: 4,
        ..good
    };
    let text = error.solve().unwrap_err().to_string();
    assert_eq!(text, "dimension = 4 is out of range: need 1, 2 or 3");
    let error = NohProblem {
        speed: f64::NAN,
        ..good
    };
    assert!(error.solve().unwrap_err().to_string().starts_with("speed"));
}
