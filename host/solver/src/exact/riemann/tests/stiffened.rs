//! The stiffened gas: water beside air and beside water; and solutions laid in space.

use super::super::super::residual::euler_residual;
use super::*;
use crate::exact::flow::Flow;

/// Water of Cocchi and Saurel: gamma 4.4, p_inf 6e8 Pa.
const WATER: (f64, f64) = (4.4, 6e8);
const GAS: (f64, f64) = (1.4, 0.0);

type Side = ([f64; 3], (f64, f64));

fn tube((left, a): Side, (right, b): Side) -> RiemannProblem {
    stiffened_problem(left, right, [a.0, b.0], [a.1, b.1])
}

const TUBES: [(Side, Side); 5] = [
    // Water at 1e9 Pa bursts into air.
    (([1000.0, 0.0, 1e9], WATER), ([50.0, 0.0, 1e5], GAS)),
    // Air at 100 bar on water; a hammer of water on air; water on water; the weak one.
    (([120.0, 0.0, 1e7], GAS), ([1000.0, 0.0, 1e5], WATER)),
    (([1000.0, 100.0, 1e5], WATER), ([1.2, 0.0, 1e5], GAS)),
    (
        ([1000.0, 300.0, 1e5], WATER),
        ([900.0, -200.0, 1e6], (3.0, 2e8)),
    ),
    (([1000.0, 0.0, 2e5], WATER), ([1.2, 0.0, 1e5], GAS)),
];

/// The pressure has a rounding of 2e-16 p_inf, up to some 1e-12 of a jump of 1e5 Pa in the
/// water; the gas's own relations hold to a few hundred of that.
#[test]
fn tubes_of_water_and_air_satisfy_the_jump_conditions_and_the_fan_relations() {
    for (left, right) in TUBES {
        let problem = tube(left, right);
        assert_is_a_solution(&problem, 1e-12);
        // The momentum flux across each wave, in units of the jump and not of the flux.
        let solution = problem.solve().unwrap();
        let star = solution.star().unwrap();
        let shock = |wave: [f64; 2]| (wave[0] == wave[1]).then_some(wave[0]);
        for (s, out, density) in [
            (shock(solution.left_wave()), problem.left, star.left_density),
            (
                shock(solution.right_wave()),
                problem.right,
                star.right_density,
            ),
        ] {
            let Some(s) = s else { continue };
            let jump = star.pressure - out.pressure;
            let flux = out.density * (s - out.velocity) * (star.velocity - out.velocity);
            assert_near(flux, jump, 1e-9 * jump, "momentum");
            let behind = density * (s - star.velocity);
            let before = out.density * (s - out.velocity);
            assert_near(behind, before, 1e-12 * before.abs(), "mass");
        }
    }
}

/// The speeds behind a fan in water and a shock in air, written out, agree with each other.
#[test]
fn the_star_pressure_is_the_root_of_the_velocity_jumps() {
    let (water, air) = TUBES[0];
    let star = tube(water, air).solve().unwrap().star().unwrap();
    let (p, rho) = (1e9 + 6e8, 1000.0);
    let ratio: f64 = (star.pressure + 6e8) / p;
    // Fan in the water, shock in the air.
    let c = (4.4_f64 * p / rho).sqrt();
    let water_u = 2.0 * c / 3.4 * (1.0 - ratio.powf(3.4 / 8.8));
    let rise = star.pressure - 1e5;
    let air_u = rise * (2.0 / 50.0 / (2.4 * star.pressure + 0.4 * 1e5)).sqrt();
    assert_near(water_u, star.velocity, 1e-13 * c, "water");
    assert_near(air_u, star.velocity, 1e-13 * c, "air");
}

#[test]
fn the_energy_is_that_of_the_equation_of_state() {
    let (left, right) = TUBES[0];
    let solution = tube(left, right).solve().unwrap();
    let contact = solution.star().unwrap().velocity;
    for (xi, (gamma, p_inf)) in [(contact - 1.0, WATER), (contact + 1.0, GAS)] {
        let state = solution.sample(xi);
        let pressure = (gamma - 1.0) * state.density * solution.internal_energy(xi) - gamma * p_inf;
        let scale = gamma * p_inf + state.pressure;
        assert_near(pressure, state.pressure, ROUNDING * scale, "pressure");
    }
}

/// Only p + p_inf counts: shifting p and p_inf against each other shifts the solution.
#[test]
fn a_stiffened_gas_is_an_ideal_one_with_its_pressure_shifted() {
    let ideal = problem(SOD[0], SOD[1], AIR).solve().unwrap();
    let lower = |[density, velocity, pressure]: [f64; 3]| [density, velocity, pressure - 0.5];
    let shifted = stiffened_problem(lower(SOD[0]), lower(SOD[1]), AIR, [0.5; 2]);
    let shifted = shifted.solve().unwrap();
    for i in -200..=200 {
        let xi = 0.01 * f64::from(i);
        let (a, b) = (ideal.sample(xi), shifted.sample(xi));
        assert_near(b.pressure + 0.5, a.pressure, ROUNDING, "pressure");
        assert_near(b.density, a.density, ROUNDING, "density");
        assert_near(b.velocity, a.velocity, 10.0 * ROUNDING, "velocity");
    }
}

/// Air expands into the vacuum, the water's surface follows at p = 0 with its own speed:
/// no gas is stretched below the least pressure that both bear.
#[test]
fn water_torn_from_air_keeps_a_surface_at_pressure_0() {
    let air_edge = 5.0 * (1.4_f64 * 1e5 / 1.2).sqrt();
    let problem = tube(
        ([1000.0, 0.0, 1e5], WATER),
        ([1.2, air_edge + 10.0, 1e5], GAS),
    );
    let solution = problem.solve().unwrap();
    assert_eq!(solution.star(), None);
    let surface = 1e5 / (1000.0 * (4.4_f64 * 6.001e8 / 1000.0).sqrt());
    let [_, tail] = solution.left_wave();
    let water = solution.sample(tail);
    assert_eq!(water.pressure, 0.0);
    // Acoustics: the second order is (p/p_inf) times that.
    assert_near(water.velocity, surface, 1e-3 * surface, "surface");
    assert_near(water.density, 1000.0, 0.1, "density");
    let between = solution.sample(5.0);
    assert_eq!((between.density, between.pressure), (0.0, 0.0));
    assert_is_a_solution(&problem, 1e-12);
}

#[test]
fn two_waters_part_at_minus_p_inf() {
    let side = |u: f64| ([1000.0, u, 1e5], WATER);
    let solution = tube(side(-1000.0), side(1000.0)).solve().unwrap();
    assert_eq!(solution.star(), None);
    assert_eq!(solution.sample(0.0).pressure, -6e8);
}

/// Water under tension, which its p_inf bears, beside air.
#[test]
fn water_may_be_below_pressure_0() {
    let problem = tube(([1000.0, 0.0, -1e7], WATER), ([1.2, 0.0, 1e5], GAS));
    assert_is_a_solution(&problem, 1e-12);
    let broken = tube(([1000.0, 0.0, -6e8], WATER), ([1.2, 0.0, 1e5], GAS));
    let text = broken.solve().unwrap_err().to_string();
    assert!(text.starts_with("left pressure = -600000000"), "{text}");
    let soft = tube(([1.0, 0.0, 1.0], (1.4, -1.0)), ([1.2, 0.0, 1e5], GAS));
    let text = soft.solve().unwrap_err().to_string();
    assert!(text.starts_with("left p"), "{text}");
}

#[test]
fn a_solution_laid_along_a_normal_is_that_of_the_line() {
    let solution = problem(SOD[0], SOD[1], AIR).solve().unwrap();
    let normal = [0.48, -0.6, 0.64];
    let flow = RiemannFlow::new(solution, 0.25, normal).unwrap();
    for i in -10..=10 {
        let (x, time) = (0.1 * f64::from(i), 0.3);
        // Aside by a vector orthogonal to the normal: 0.48 * 0.6 = 0.6 * 0.48.
        let place = [0, 1, 2].map(|k| normal[k] * (0.25 + x) + 0.7 * [0.6, 0.48, 0.0][k]);
        let state = flow.at(place, time);
        let line = solution.sample(x / time);
        assert_near(state.density, line.density, 1e-13, "density");
        for k in 0..3 {
            assert_near(
                state.velocity[k],
                normal[k] * line.velocity,
                1e-13,
                "velocity",
            );
        }
        let energy = solution.internal_energy(x / time);
        assert_near(state.energy, energy, 1e-12, "energy");
    }
    let start = |x: f64| flow.at(normal.map(|n| n * x), 0.0).density;
    assert_eq!((start(0.24), start(0.26)), (1.0, 0.125));
    assert!(RiemannFlow::new(solution, 0.0, [1.0, 1.0, 0.0]).is_err());
}

/// Inside the fan of the water tube: fourth-order differences, 1e-10 of the flux, on p that is
/// a part of p_inf.
#[test]
fn a_fan_in_water_satisfies_the_euler_equations() {
    let (left, right) = TUBES[0];
    let solution = tube(left, right).solve().unwrap();
    let flow = RiemannFlow::new(solution, 0.0, [0.0, 0.6, 0.8]).unwrap();
    let [head, tail] = solution.left_wave();
    let time = 1e-3;
    for part in [0.25, 0.5, 0.75] {
        let x = (head + part * (tail - head)) * time;
        let length = 0.1 * (tail - head) * time;
        let residual = euler_residual(&flow, [0.1, 0.6 * x, 0.8 * x], time, length);
        assert!(residual < 1e-10, "{part}: {residual:e}");
    }
}

proptest! {
    /// Bound: the rounding of p_inf, up to 1e4 of p, in relations of the flux.
    #[test]
    fn any_water_and_any_air_get_a_solution(
        water in (2.5..3.2, -50.0..50.0, -1.0..9.5),
        air in (-1.0..2.0, -100.0..100.0, 3.0..8.0),
        gamma in 1.1..5.0,
        p_inf in 7.0..9.5,
    ) {
        let state = |(density, velocity, pressure): (f64, f64, f64)| {
            [10_f64.powf(density), velocity, 10_f64.powf(pressure)]
        };
        let problem = tube(
            (state(water), (gamma, 10_f64.powf(p_inf))),
            (state(air), GAS),
        );
        assert_is_a_solution(&problem, 1e-9);
    }
}
