//! Conditions at walls.

use motes_core::equation::diffusion::{Condition, Form};
use motes_core::error::Error;
use motes_core::integrator::SSP_RK3;
use motes_core::pairs::HalfLoop;

use crate::clouds::{Slab, fill, line, run, storage};

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
            // That is refused.
            if form == Form::Mixed && ends[1] == exchange {
                continue;
            }
            let mut storage = storage::<f64, 1, 64>();
            fill(&mut storage, n, u);
            let solver = line(n, Slab { ends }, form, 1.5);
            let (mut state, mut work) = storage.parts();
            solver
                .prepare(&mut HalfLoop, &mut state, &mut work)
                .unwrap();
            for (k, rates) in work.last.iter().take(n as usize).enumerate() {
                let rate = rates.strength[0];
                // The direct form is exact. The mixed one's own flux is off by its quadrature,
                // a thousandth, beside the exact one of the wall.
                let bound = match form {
                    Form::Direct => 1e-14,
                    Form::Mixed => 3e-5,
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

/// In the mixed form an exchange feeds waves of two spacings at any step.
#[test]
fn the_mixed_form_is_refused_between_walls_that_exchange() {
    let exchange = Condition::Exchange {
        rate: 0.2,
        outside: 1.0,
    };
    for (form, answer) in [
        (Form::Direct, Ok(())),
        (Form::Mixed, Err(Error::MixedExchange)),
    ] {
        let mut storage = storage::<f64, 1, 64>();
        fill(&mut storage, 40, |_| 0.0);
        let ends = [Condition::NoFlux, exchange];
        let solver = line(40, Slab { ends }, form, 1.5);
        let (mut state, mut work) = storage.parts();
        let prepared = solver.prepare(&mut HalfLoop, &mut state, &mut work);
        assert_eq!(prepared, answer);
    }
}
