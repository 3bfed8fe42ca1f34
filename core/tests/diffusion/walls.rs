//! Conditions at walls.

use std::f64::consts::PI;

use motes_core::cutoff::Named;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::diffusion::{
    Condition, DiffusionDynamics, Drive, DrivenCondition, Form, Mean, NamedProblem, Reaction,
};
use motes_core::equation::linear::{State, Still};
use motes_core::integrator::SSP_RK3;
use motes_core::pairs::HalfLoop;

use crate::clouds::{Slab, distorted, fill, line, order, plane, run, storage, with_a_large_stack};

/// Under every condition the straight line that meets it does not change, in either form.
#[test]
fn straight_profiles_are_steady_under_every_condition() {
    let (n, slope, b) = (40, 0.03, 0.5);
    let u = |x: f64| 2.0 + slope * x;
    // Outwards at the upper wall the flux is -b slope, at the lower one b slope.
    let upper = u(20.0);
    let exchange = Condition::Exchange {
        rate: 0.2,
        outside: upper + b * slope / 0.2,
    };
    for form in [Form::Direct, Form::Mixed] {
        for ends in [
            [Condition::Value(u(-20.0)), Condition::Value(upper)],
            [Condition::Flux(b * slope), Condition::Flux(-b * slope)],
            [Condition::Value(u(-20.0)), exchange],
        ] {
            let mut storage = storage::<f64, 1, 64>();
            fill(&mut storage, n, u);
            let solver = line(n, Slab { ends }, form, 1.5);
            let (mut state, mut work) = storage.parts();
            solver
                .prepare(&mut HalfLoop, &mut state, &mut work)
                .unwrap();
            for (k, rates) in work.last.iter().take(n as usize).enumerate() {
                let rate = rates.strength[0];
                // The direct form is exact. The mixed one's own flux is off by its quadrature, a
                // thousandth, beside the exact one of the wall; what each particle pays is an
                // integral over what lies behind the wall in place of the sum, a hundredth.
                let bound = match (form, ends[1] == exchange) {
                    (Form::Direct, _) => 1e-14,
                    (Form::Mixed, false) => 3e-5,
                    (Form::Mixed, true) => 8e-4,
                };
                assert!(rate.abs() < bound, "{form:?} {ends:?} at {k}: {rate}");
            }
        }
    }
}

/// A slab heats up as `erfc` says: the wall is held at 1, the rest starts at 0.
#[test]
fn a_wall_held_at_a_value_heats_the_slab() {
    let n = 100;
    let mut storage = storage::<f64, 1, 128>();
    fill(&mut storage, n, |_| 0.0);
    let ends = [Condition::Value(1.0), Condition::NoFlux];
    let solver = line(n, Slab { ends }, Form::Direct, 1.5);
    let (mut state, mut work) = storage.parts();
    let end = 200.0;
    run(&solver, &SSP_RK3, &mut state, &mut work, end);
    for (x, u) in state.position.iter().zip(state.value.iter()) {
        let depth = x[0] + 50.0;
        let exact = libm::erfc(depth / (2.0 * (0.5 * end).sqrt()));
        assert!((u[0] - exact).abs() < 4e-3, "{depth}: {} {exact}", u[0]);
    }
}

/// Between walls that exchange, the sum of `w (u - u_out)²` falls in every step, whatever the state: also a
/// wave of two spacings, and also where the wall resists nothing. With the image's own flux behind the
/// wall the mixed form would feed it.
#[test]
fn walls_that_exchange_only_take() {
    for (form, cut_off) in [
        (Form::Direct, Named::QuinticSpline),
        (Form::Mixed, Named::QuinticSpline),
        (Form::Mixed, Named::WendlandC2),
        (Form::Mixed, Named::SmoothFour),
        (Form::Mixed, Named::QuinticSplineFour),
    ] {
        for rate in [0.02, 0.2, 1e3] {
            let exchange = Condition::Exchange { rate, outside: 1.0 };
            let mut storage = storage::<f64, 1, 64>();
            fill(&mut storage, 40, |x| {
                1.0 + (2.9 * x).sin() * (0.3 * x).cos()
            });
            let mut solver = line(
                40,
                Slab {
                    ends: [exchange; 2],
                },
                form,
                1.2,
            );
            solver.courant = 1.0;
            solver.cut_off = cut_off;
            let (mut state, mut work) = storage.parts();
            let engine = &mut HalfLoop;
            solver.prepare(engine, &mut state, &mut work).unwrap();
            let sum = |state: &State<'_, f64, 1, 1>| {
                let squares = state.value.iter().map(|u| (u[0] - 1.0) * (u[0] - 1.0));
                squares
                    .zip(state.weight.iter())
                    .map(|(u, w)| w * u)
                    .sum::<f64>()
            };
            let (mut before, mut time) = (sum(&state), 0.0);
            let first = before;
            for i in 0..400 {
                let radius = solver.radius(&state, &work).unwrap();
                let dt = solver.time_step(radius, SSP_RK3.real, 1e9).unwrap();
                let step = (time, dt);
                solver
                    .advance(&SSP_RK3, engine, &mut state, &mut work, step)
                    .unwrap();
                time += dt;
                let now = sum(&state);
                assert!(
                    now < before,
                    "{form:?}, {cut_off:?}, rate {rate}, step {i}: {now} after {before}"
                );
                before = now;
            }
            assert!(
                before < 0.5 * first,
                "{form:?}, rate {rate}: {before} of {first}"
            );
        }
    }
}

/// Heat through a rod that is held at one end: what a source in all of it, or a flux at the other
/// end, makes in the long run. In the mixed form nothing damps waves of two spacings but the share
/// of the direct one, and the jump of the source at the held wall feeds them.
#[test]
fn a_source_beside_a_held_wall_ends_in_the_steady_state() {
    for n in [20, 21] {
        let size = f64::from(n);
        for form in [Form::Direct, Form::Mixed] {
            for (source, flux) in [(1.0, 0.0), (0.0, -1.0), (0.5, -0.5)] {
                let mut problem = NamedProblem::heat([size]);
                problem.reaction = Reaction::Linear {
                    matrix: [[0.0]],
                    source: [source / size],
                };
                let driven = |value| Drive::Constant(value);
                problem.walls = [[
                    [DrivenCondition::Flux(driven(flux))],
                    [DrivenCondition::Value(driven(0.0))],
                ]];
                let mut storage = storage::<f64, 1, 64>();
                fill(&mut storage, n, |_| 0.3);
                let solver = line(n, problem, form, 0.7 * size.powf(0.25));
                let (mut state, mut work) = storage.parts();
                run(&solver, &SSP_RK3, &mut state, &mut work, 8.0 * size);
                for (x, u) in state.position.iter().zip(state.value.iter()) {
                    let s = x[0] / size + 0.5;
                    let exact = source * 0.5 * (1.0 - s * s) - flux * (1.0 - s);
                    assert!(
                        (u[0] - exact).abs() < 0.02,
                        "{form:?} at {s}: {u:?} {exact}"
                    );
                }
            }
        }
    }
}

/// In the plane: a flux through one wall beside a wall that is held at 0, `u = 0.3` at the start.
/// Steady in the end, and between 0 and what the flux can drive over the length of the square.
#[test]
fn a_flux_beside_a_held_wall_stays_within_its_data() {
    with_a_large_stack(|| {
        let n = 16;
        let size = f64::from(n);
        for axis in [0, 1] {
            let states = [Form::Direct, Form::Mixed].map(|form| {
                let mut problem = NamedProblem::<f64, 2, 1>::heat([size * size]);
                let flux = DrivenCondition::Flux(Drive::Constant(-0.5 * size));
                problem.walls[axis][0] = [flux];
                problem.walls[1 - axis][1] = [DrivenCondition::Value(Drive::Constant(0.0))];
                let mut storage = distorted::<1024>(n, 0.0, |_, _| 0.3);
                let of_heat = plane(n, Still, form, 1.0, 0.7 * size.powf(0.25));
                let solver = DiffusionDynamics {
                    domain: Domain {
                        axes: [Axis::walls(-0.5 * size, 0.5 * size); 2],
                    },
                    problem,
                    cut_off: of_heat.cut_off,
                    epsilon: of_heat.epsilon,
                    field: Still,
                    form,
                    mean: Mean::Arithmetic,
                    courant: 1.0,
                };
                let (mut state, mut work) = storage.parts();
                run(&solver, &SSP_RK3, &mut state, &mut work, 2.0);
                state.value.to_vec()
            });
            let [direct, mixed] = states;
            for (direct, mixed) in direct.iter().zip(&mixed) {
                assert!((-0.01..0.5).contains(&mixed[0]), "{axis}: {mixed:?}");
                assert!((direct[0] - mixed[0]).abs() < 0.03, "{direct:?} {mixed:?}");
            }
        }
    });
}

/// Roots of `m tan m = h`, one in each `(iπ, iπ + π/2)`.
fn roots(h: f64) -> impl Iterator<Item = f64> {
    (0..60).map(move |i| {
        let mut ends = [0.0, 0.5].map(|part| PI * (f64::from(i) + part));
        for _ in 0..60 {
            let middle = 0.5 * (ends[0] + ends[1]);
            let below = middle * middle.tan() < h;
            ends[usize::from(!below)] = middle;
        }
        ends[0]
    })
}

/// The L2 error of a slab of n particles that has cooled from 1 by exchange at its upper end for a while,
/// the lower one closed: `Σ 2 sin m/(m + sin m cos m) cos(m x/n) exp(-b m² t/n²)`, where `m tan m = rate
/// n/b`.
fn cooled(n: u32, form: Form) -> f64 {
    let size = f64::from(n);
    // Biot's number is 2.
    let (b, rate) = (0.5, 1.0 / size);
    let exact = |x: f64, time: f64| -> f64 {
        let terms = roots(rate * size / b).map(|m| {
            let part = 2.0 * m.sin() / (m + m.sin() * m.cos());
            part * (m * (x / size + 0.5)).cos() * (-b * m * m * time).exp()
        });
        terms.sum()
    };
    let (start, end) = (0.05, 0.4);
    let exchange = Condition::Exchange { rate, outside: 0.0 };
    let ends = [Condition::NoFlux, exchange];
    let mut storage = storage::<f64, 1, 256>();
    fill(&mut storage, n, |x| exact(x, start));
    let solver = line(n, Slab { ends }, form, 0.7 * size.powf(0.25));
    let (mut state, mut work) = storage.parts();
    let lasts = (end - start) * size * size;
    run(&solver, &SSP_RK3, &mut state, &mut work, lasts);
    let values = state.position.iter().zip(state.value.iter());
    let squares = values.map(|(x, u)| (u[0] - exact(x[0], end)).powi(2));
    (squares.sum::<f64>() / size).sqrt()
}

/// The direct form has the order of its cut-off, `r θ = 1.5`; the mixed form's integral for a sum costs
/// it a part of that, and a factor.
#[test]
fn a_slab_cools_by_exchange_in_both_forms() {
    for (form, least, most) in [(Form::Direct, 1.4, 2.3e-5), (Form::Mixed, 0.85, 3.5e-4)] {
        let errors = [50, 100, 200].map(|n| cooled(n, form));
        println!("{form:?}: {errors:?}");
        let order = 0.5 * order(errors[0], errors[2]);
        assert!(order > least, "{form:?} {errors:?}: order {order}");
        assert!(errors[2] < most, "{form:?}: {errors:?}");
    }
}
