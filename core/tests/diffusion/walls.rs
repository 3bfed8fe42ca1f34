//! Conditions at walls.

use std::f64::consts::PI;

use motes_core::cutoff::Named;
use motes_core::equation::diffusion::{Condition, Form};
use motes_core::equation::linear::State;
use motes_core::integrator::SSP_RK3;
use motes_core::pairs::HalfLoop;

use crate::clouds::{Slab, fill, line, order, run, storage};

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
