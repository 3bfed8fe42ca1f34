//! The Euler equations without viscosity, the balance of energy with it, and numbers out of range.

use super::super::residual::euler_residual;
use super::*;

fn vortices(viscosity: f64, lengths: [f64; 2]) -> TaylorGreen {
    let problem = TaylorGreenProblem {
        gamma: 1.4,
        density: 1.2,
        speed: 0.7,
        pressure: 9.0,
        viscosity,
        corner: [-0.3, 0.2],
        lengths,
    };
    problem.solve().unwrap()
}

/// Momentum and mass hold exactly; the energy is that of a gas whose density does not follow the pressure:
/// its flux misses by the square of the Mach number, 0.7²/(1.4 · 9/1.2) = 0.05, of `ρ c³/L`.
#[test]
fn the_euler_equations_hold_to_the_square_of_the_mach_number() {
    let residual = |speed: f64| {
        let problem = TaylorGreenProblem {
            speed,
            ..vortices(0.0, [1.0, 0.5]).problem
        };
        let flow = problem.solve().unwrap();
        let places = [[0.1, 0.3], [0.45, 0.1], [-0.2, 0.6]];
        let all = places.map(|[x, y]| euler_residual(&flow, [x, y, 0.0], 0.0, 0.5 / (2.0 * PI)));
        all.into_iter().fold(0.0, f64::max)
    };
    let [fast, slow] = [0.1, 0.01].map(residual);
    // The cube of the speed: u times the gradient of a pressure of order u².
    let order = (fast / slow).log10();
    assert!(
        (order - 3.0).abs() < 0.1,
        "order {order}: {fast:e}, {slow:e}"
    );
}

/// The mean over the rectangle of kinetic and internal energy stays, while the kinetic one falls by
/// `e^(-2 nu (k_x² + k_y²) t)`: by `e^(-16 pi² nu t)` in a unit square.
#[test]
fn what_the_vortices_lose_is_heat() {
    let means = |flow: &TaylorGreen, time: f64| {
        let n = 32;
        let mut sums = [0.0; 2];
        for cell in 0..n * n {
            let part = [cell % n, cell / n].map(|i| (f64::from(i) + 0.5) / f64::from(n));
            let place = |i: usize| flow.problem.corner[i] + part[i] * flow.problem.lengths[i];
            let state = flow.at([place(0), place(1), 0.0], time);
            let [u, v, _] = state.velocity;
            sums[0] += 0.5 * (u * u + v * v) / f64::from(n * n);
            sums[1] += state.energy / f64::from(n * n);
        }
        sums
    };
    for lengths in [[1.0, 1.0], [1.0, 0.5]] {
        let flow = vortices(0.01, lengths);
        let [start, end] = [0.0, 0.6].map(|time| means(&flow, time));
        let total = |[kinetic, internal]: [f64; 2]| kinetic + internal;
        assert!((total(end) - total(start)).abs() < 1e-13 * total(start));
        let waves = 1.0 / (lengths[0] * lengths[0]) + 1.0 / (lengths[1] * lengths[1]);
        let left = (-2.0 * 0.01 * 4.0 * PI * PI * waves * 0.6).exp();
        assert!((end[0] / start[0] - left).abs() < 1e-13, "{lengths:?}");
    }
}

#[test]
fn numbers_out_of_range_are_named() {
    let problem = TaylorGreenProblem {
        // 1.2 · 0.49/4 · 2 = 0.294.
        pressure: 0.29,
        ..vortices(0.01, [1.0, 1.0]).problem
    };
    let error = problem.solve().unwrap_err().to_string();
    assert!(
        error.starts_with("pressure = 0.29 is out of range: need above"),
        "{error}"
    );
    let pressure = 0.30;
    assert!(
        TaylorGreenProblem {
            pressure,
            ..problem
        }
        .solve()
        .is_ok()
    );
}
