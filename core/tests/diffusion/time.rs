//! The stabilised method.

use motes_core::cutoff::Named;
use motes_core::equation::diffusion::{DiffusionDynamics, Form, Heat};
use motes_core::equation::linear::State;
use motes_core::integrator::{Rkl2, SSP_RK3};
use motes_core::pairs::HalfLoop;

use crate::clouds::{Line, Work, fill, line, order, run, storage};

/// A stiff slab: the shortest wave decays some thousand times faster than the one that is asked for.
fn stiff(
    method: impl Fn(&Line<f64, Heat<f64>>, &mut State<'_, f64, 1, 1>, &mut Work<'_, f64, 1>, f64) -> u32,
) -> (f64, u32) {
    use std::f64::consts::PI;
    let n = 200;
    let wave = |x: f64| (PI * (x / 200.0 + 0.5)).cos();
    let mut storage = storage::<f64, 1, 256>();
    fill(&mut storage, n, wave);
    let solver = line(n, Heat { diffusivity: 1.0 }, Form::Direct, 2.0);
    let (mut state, mut work) = storage.parts();
    solver
        .prepare(&mut HalfLoop, &mut state, &mut work)
        .unwrap();
    // What the operator makes of the wave, which it only scales: the error is that of time alone.
    let rate = work.last[10].strength[0] / 4.0 / state.value[10][0];
    let end = 8000.0;
    let sides = method(&solver, &mut state, &mut work, end);
    let exact = (rate * end).exp();
    let worst = state
        .position
        .iter()
        .zip(state.value.iter())
        .fold(0.0f64, |worst, (x, u)| {
            worst.max((u[0] - exact * wave(x[0])).abs())
        });
    (worst, sides)
}

/// Steps of the stabilised method.
fn stabilised(steps: u32) -> (f64, u32) {
    stiff(|solver, state, work, end| {
        let dt = end / f64::from(steps);
        let method = Rkl2::for_product(dt * solver.radius(state, work).unwrap());
        for i in 0..steps {
            let step = (f64::from(i) * dt, dt);
            solver
                .advance_split(method, &mut HalfLoop, state, work, step)
                .unwrap();
        }
        steps * method.stages()
    })
}

#[test]
fn the_stabilised_method_is_of_second_order() {
    let errors = [8, 16, 32].map(|steps| stabilised(steps).0);
    for pair in errors.windows(2) {
        let order = order(pair[0], pair[1]);
        assert!((order - 2.0).abs() < 0.3, "{errors:?}: order {order}");
    }
}

/// At the same error, 1e-4 of the first amplitude, it needs less than a tenth of the right-hand
/// sides of SSP-RK3, which is bound by stability.
#[test]
fn the_stabilised_method_saves_nine_tenths_of_the_work() {
    let (error, sides) = stabilised(28);
    assert!(error < 1e-4, "{error}");
    let (_, explicit) = stiff(|solver, state, work, end| {
        let fast = DiffusionDynamics {
            courant: 1.0,
            ..*solver
        };
        run(&fast, &SSP_RK3, state, work, end)
    });
    println!(
        "right-hand sides: {sides} of RKL2 with an error of {error:.1e}, {explicit} of SSP-RK3"
    );
    assert!(10 * sides <= explicit, "{sides} against {explicit}");
}

/// The largest `|λ|` of the right-hand side of the direct form, by power iteration.
fn largest_eigenvalue(
    solver: &Line<f64, Heat<f64>>,
    state: &mut State<'_, f64, 1, 1>,
    work: &mut Work<'_, f64, 1>,
) -> f64 {
    let mut largest = 0.0;
    for _ in 0..400 {
        solver.prepare(&mut HalfLoop, state, work).unwrap();
        let squared = solver.epsilon * solver.epsilon;
        let rates = (0..state.len()).map(|k| work.last[k].strength[0] / state.weight[k] / squared);
        let rates: Vec<f64> = rates.collect();
        largest = rates.iter().map(|rate| rate * rate).sum::<f64>().sqrt();
        for (value, rate) in state.value.iter_mut().zip(rates) {
            value[0] = rate / largest;
        }
    }
    largest
}

/// An explicit step needs the bound, and every stage that it asks for too many is paid for. The
/// second cut-off has both signs.
#[test]
fn the_bound_of_the_step_is_above_the_spectral_radius_and_close() {
    for (cut_off, epsilon, close) in [
        (Named::QuinticSpline, 1.0, 1.1),
        (Named::SmoothFour, 2.0, 1.5),
    ] {
        let mut solver = line(60, Heat { diffusivity: 0.7 }, Form::Direct, epsilon);
        solver.cut_off = cut_off;
        let mut storage = storage::<f64, 1, 64>();
        fill(&mut storage, 60, |x| (1e3 * x).sin());
        let (mut state, mut work) = storage.parts();
        let largest = largest_eigenvalue(&solver, &mut state, &mut work);
        let ratio = solver.radius(&state, &work).unwrap() / largest;
        assert!((1.0..close).contains(&ratio), "{cut_off:?}: {ratio}");
    }
}

/// In a strong expansion partners come to the edge of the support and weights grow: what is left of
/// the sum is the term of a particle on itself, which moves nothing and must not shorten the step.
#[test]
fn a_particle_with_faint_partners_bounds_no_step() {
    // The support is 1.02 spacings.
    let solver = line(60, Heat { diffusivity: 0.7 }, Form::Direct, 0.34);
    let mut storage = storage::<f64, 1, 64>();
    fill(&mut storage, 60, f64::sin);
    let (mut state, mut work) = storage.parts();
    let engine = &mut HalfLoop;
    solver.prepare(engine, &mut state, &mut work).unwrap();
    let radius = solver.radius(&state, &work).unwrap();
    assert!((1e-9..1e-3).contains(&radius), "{radius}");
}
