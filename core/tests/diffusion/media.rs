//! Tensors, jumps, and what changes in time.

use std::f64::consts::TAU;

use motes_core::equation::diffusion::{
    Conductor, DiffusionDynamics, Drive, DrivenCondition, Form, Mean, Modulation, NamedProblem,
    Reaction,
};
use motes_core::equation::linear::Still;
use motes_core::integrator::{Rkl2, SSP_RK3};
use motes_core::pairs::HalfLoop;

use crate::clouds::{Line, distorted, fill, line, order, plane, run, storage, with_a_large_stack};

const TENSOR: [[f64; 2]; 2] = [[1.0, 0.4], [0.4, 0.5]];

/// Two waves of the square across each other.
fn waves(x: f64, y: f64) -> f64 {
    (TAU * (x + y)).sin() + (TAU * (x - y)).cos()
}

/// `div(T ∇u)` of them.
fn spread(x: f64, y: f64) -> f64 {
    let [[along, mixed], [_, across]] = TENSOR;
    let (same, opposite) = (along + 2.0 * mixed + across, along - 2.0 * mixed + across);
    let sum = same * (TAU * (x + y)).sin() + opposite * (TAU * (x - y)).cos();
    -TAU * TAU * sum
}

/// `div(T ∇u)` has the order of the cut-off, `r θ = 1.5`, on a smoothly distorted lattice.
#[test]
fn a_tensor_keeps_the_order_in_both_forms() {
    with_a_large_stack(|| {
        for form in [Form::Direct, Form::Mixed] {
            let errors = [28u32, 40, 57].map(|n| {
                let size = f64::from(n);
                let epsilon = 0.8 * size.powf(0.25);
                let mut storage = distorted::<4096>(n, 0.02, waves);
                let heat = plane(n, Still, form, 1.0, epsilon);
                let solver = DiffusionDynamics {
                    problem: NamedProblem {
                        tensor: Some(TENSOR),
                        ..NamedProblem::heat([1.0])
                    },
                    domain: heat.domain,
                    cut_off: heat.cut_off,
                    epsilon,
                    field: Still,
                    form,
                    mean: Mean::Arithmetic,
                    courant: 0.5,
                };
                let (mut state, mut work) = storage.parts();
                solver
                    .prepare(&mut HalfLoop, &mut state, &mut work)
                    .unwrap();
                let factor = size * size / (epsilon * epsilon);
                let rows = state.position.iter().zip(state.weight.iter());
                let squares: f64 = rows
                    .zip(work.last.iter())
                    .map(|((x, w), rates)| {
                        let exact = spread(x[0] / size, x[1] / size);
                        let off = factor * rates.strength[0] / w - exact;
                        w * off * off
                    })
                    .sum();
                squares.sqrt() / size
            });
            let observed = (errors[0] / errors[2]).ln() / (57.0f64 / 28.0).ln();
            assert!(
                (observed - 1.5).abs() < 0.2,
                "{form:?}: {errors:?}, order {observed}"
            );
        }
    });
}

type Slab<'a> = Line<f64, NamedProblem<'a, f64, 1, 1>>;

/// The steady profile of a slab of 40 spacings held at 1 and 0, with a jump of `b` by 10 in its middle;
/// how far the worst particle is off.
fn layered_error(mean: Mean) -> f64 {
    let bounds = [0.0];
    let factors = [1.0, 10.0];
    let mut problem = NamedProblem::heat([1.0]);
    problem.conductor = Conductor::Layers {
        bounds: &bounds,
        factors: &factors,
    };
    problem.walls = [[
        [DrivenCondition::Value(Drive::Constant(1.0))],
        [DrivenCondition::Value(Drive::Constant(0.0))],
    ]];
    let mut solver: Slab = line(40, problem, Form::Direct, 1.0);
    solver.mean = mean;
    // Flux j through the resistances 20/1 and 20/10: u falls by 20 j, then by 2 j.
    let flux = 1.0 / 22.0;
    let exact = |x: f64| match x < 0.0 {
        true => 1.0 - flux * (x + 20.0),
        false => flux * (20.0 - x) / 10.0,
    };
    let mut storage = storage::<f64, 1, 64>();
    fill(&mut storage, 40, exact);
    let (mut state, mut work) = storage.parts();
    let engine = &mut HalfLoop;
    solver.prepare(engine, &mut state, &mut work).unwrap();
    let dt = 50.0;
    for i in 0..200 {
        let time = f64::from(i) * dt;
        let method = Rkl2::for_product(dt * solver.radius(&state, &work).unwrap());
        solver
            .advance_split(method, engine, &mut state, &mut work, (time, dt))
            .unwrap();
    }
    let rows = state.position.iter().zip(state.value.iter());
    rows.fold(0.0, |worst, (x, u)| worst.max((u[0] - exact(x[0])).abs()))
}

/// Across a jump the layer between two particles is two resistances in a row: with the harmonic mean
/// the profile is exact to a few thousandths, with the arithmetic one ten times worse.
#[test]
fn the_harmonic_mean_keeps_the_flux_through_a_jump() {
    let [harmonic, arithmetic] = [Mean::Harmonic, Mean::Arithmetic].map(layered_error);
    assert!(
        harmonic < 3e-3 && arithmetic > 3.0 * harmonic,
        "harmonic {harmonic}, arithmetic {arithmetic}"
    );
}

/// Legendre's operator with a swinging factor, `P_2((x - c)/R)` between walls:
/// `u = P_2 exp(-6 b/R² ∫ (1 + sin))`, of second order in the spacing.
#[test]
fn a_diffusivity_that_varies_in_space_and_time_has_its_modes() {
    let errors = [20u32, 40, 80].map(|n| {
        let half = 0.5 * f64::from(n);
        let mode = |x: f64| 0.5 * (3.0 * (x / half) * (x / half) - 1.0);
        let mut problem = NamedProblem::heat([half * half]);
        problem.conductor = Conductor::Parabola {
            center: 0.0,
            radius: half,
        };
        problem.modulation = Modulation {
            amplitude: 0.8,
            frequency: 2.0,
        };
        let solver: Slab = line(n, problem, Form::Direct, 1.2);
        let mut storage = storage::<f64, 1, 128>();
        fill(&mut storage, n, mode);
        let (mut state, mut work) = storage.parts();
        let end = 0.2;
        run(&solver, &SSP_RK3, &mut state, &mut work, end);
        let turn = TAU * 2.0;
        let elapsed = end + 0.8 / turn * (1.0 - (turn * end).cos());
        let decayed = (-6.0 * elapsed).exp();
        let rows = state.position.iter().zip(state.value.iter());
        rows.fold(0.0f64, |worst, (x, u)| {
            worst.max((u[0] - decayed * mode(x[0])).abs())
        })
    });
    for pair in errors.windows(2) {
        let observed = order(pair[0], pair[1]);
        assert!(observed > 1.5, "{errors:?}: order {observed}");
    }
    assert!(errors[2] < 1e-3, "{errors:?}");
}

/// The last stage of a stabilised step lies before its end: where `b` swings fast, what it is at the one
/// time says nothing of the other. The bound of a step is that of the largest `b` all the same.
#[test]
fn the_bound_of_the_step_is_that_of_the_largest_diffusivity() {
    let mut problem = NamedProblem::heat([1.0]);
    problem.modulation = Modulation {
        amplitude: 0.9,
        frequency: 3.7,
    };
    for form in [Form::Direct, Form::Mixed] {
        let solver: Slab = line(40, problem, form, 1.2);
        let mut storage = storage::<f64, 1, 64>();
        fill(&mut storage, 40, f64::sin);
        let (mut state, mut work) = storage.parts();
        let engine = &mut HalfLoop;
        solver.prepare(engine, &mut state, &mut work).unwrap();
        let first = solver.radius(&state, &work).unwrap();
        for i in 0..20 {
            let step = (0.1 * f64::from(i), 0.1);
            solver
                .advance_split(Rkl2::with_stages(5), engine, &mut state, &mut work, step)
                .unwrap();
            let radius = solver.radius(&state, &work).unwrap();
            assert!(
                (radius / first - 1.0).abs() < 1e-12,
                "{form:?}, step {i}: {radius}, {first} at the start"
            );
        }
    }
}

#[test]
fn a_series_is_linear_between_its_points_and_constant_beyond() {
    let points = [(1.0, 10.0), (2.0, 20.0), (4.0, 0.0)];
    let drive = Drive::Series(&points);
    for (time, value) in [
        (0.0, 10.0),
        (1.0, 10.0),
        (1.5, 15.0),
        (2.0, 20.0),
        (3.0, 10.0),
    ] {
        assert_eq!(drive.at(time), value, "at {time}");
    }
    assert_eq!(drive.at(9.0), 0.0);
    assert_eq!(Drive::<f64>::Series(&[]).at(1.0), 0.0);
}

#[test]
fn named_reactions_are_what_their_formulas_say() {
    let chain = Reaction::Linear {
        matrix: [[-2.0, 0.0], [2.0, -0.5]],
        source: [0.25, 0.0],
    };
    assert_eq!(chain.rate(&[1.0, 4.0]), [-1.75, 0.0]);
    assert_eq!(chain.bound(), 2.5);
    let logistic = Reaction::Logistic {
        rate: 0.5,
        capacity: 4.0,
    };
    assert_eq!(logistic.rate(&[1.0, 4.0]), [0.375, 0.0]);
    let spots = Reaction::GrayScott {
        feed: 0.25,
        kill: 0.5,
        unit: 2.0,
    };
    // -u v² + F (1-u) = -0.125 + 0.125; u v² - (F+k) v = 0.125 - 0.375.
    assert_eq!(spots.rate(&[0.5, 0.5]), [0.0, -0.5]);
}
