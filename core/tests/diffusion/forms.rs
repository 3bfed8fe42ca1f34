//! Both forms in the plane.

use motes_core::domain::{Axis, Domain};
use motes_core::equation::diffusion::{
    DiffusionDynamics, Drive, DrivenCondition, Form, Mean, NamedProblem,
};
use motes_core::equation::linear::Still;
use motes_core::integrator::SSP_RK3;
use motes_core::pairs::HalfLoop;

use crate::clouds::{Work, distorted, plane, run, with_a_large_stack};

/// A Gaussian of width `w` under heat: `w² -> w² + 4 t`, in units of the square.
fn kernel(x: f64, y: f64, time: f64) -> f64 {
    let squared = 0.02;
    let wider = squared + 4.0 * time;
    squared / wider * (-(x * x + y * y) / wider).exp()
}

/// Heat kernel on a smoothly distorted lattice, ε = 0.8 h^0.75 (h in units of the square, times
/// 64^0.25 of its own to begin at 2.3 spacings): order r θ = 1.5.
#[test]
fn both_forms_have_the_predicted_order_on_the_heat_kernel() {
    with_a_large_stack(|| {
        for form in [Form::Direct, Form::Mixed] {
            let errors = [24u32, 36, 54].map(|n| {
                let size = f64::from(n);
                let epsilon = 0.8 * size.powf(0.25);
                let mut storage = distorted::<4096>(n, 0.03, |x, y| kernel(x, y, 0.0));
                // In spacings: b = n² per unit of time of the square.
                let solver = plane(n, Still, form, 1.0, epsilon);
                let (mut state, mut work) = storage.parts();
                let time = 0.005;
                run(&solver, &SSP_RK3, &mut state, &mut work, time * size * size);
                let (mut sum, mut total) = (0.0, 0.0);
                for (x, (u, w)) in state
                    .position
                    .iter()
                    .zip(state.value.iter().zip(state.weight.iter()))
                {
                    let off = u[0] - kernel(x[0] / size, x[1] / size, time);
                    (sum, total) = (sum + w * off * off, total + w);
                }
                (sum / total).sqrt()
            });
            let order = (errors[0] / errors[2]).ln() / (54.0f64 / 24.0).ln();
            assert!(
                (order - 1.5).abs() < 0.2,
                "{form:?}: {errors:?}, order {order}"
            );
        }
    });
}

/// Mixed form on a fixed cloud: `d/dt Σ w u²/2 = -Σ w |p|²/b`, to rounding.
#[test]
fn the_mixed_form_loses_what_its_fluxes_dissipate() {
    with_a_large_stack(|| {
        let n = 24;
        let mut storage = distorted::<1024>(n, 0.05, |x, y| kernel(x, y, 0.0));
        let solver = plane(n, Still, Form::Mixed, 0.7, 1.9);
        let (mut state, mut work) = storage.parts();
        solver
            .prepare(&mut HalfLoop, &mut state, &mut work)
            .unwrap();
        let u = state.value.iter().map(|u| u[0]);
        let (gained, lost) = energy(u, &work, (1.9, 0.7));
        assert!(
            lost > 1e-3 && ((gained + lost) / lost).abs() < 1e-12,
            "{gained} {lost}"
        );
    });
}

/// `d/dt Σ w u²/2` by the rates, and `Σ w |p|²/b` by the fluxes, with ε and b.
fn energy(
    u: impl ExactSizeIterator<Item = f64>,
    work: &Work<'_, f64, 2>,
    (epsilon, b): (f64, f64),
) -> (f64, f64) {
    let (squared, n) = (epsilon * epsilon, u.len());
    let gained: f64 = u
        .zip(work.last.iter())
        .map(|(u, rates)| u * rates.strength[0] / squared)
        .sum();
    let lost: f64 = work.mixed.nodes[..n]
        .iter()
        .map(|node| {
            let [p] = node.flux;
            node.node.weight * (p[0] * p[0] + p[1] * p[1]) / squared / b
        })
        .sum();
    (gained, lost)
}

/// The same between walls that let nothing through, on a state that is no smoother than the cloud:
/// what is seen behind a wall neither feeds the state nor drains it. Beside one that is held at 0
/// three fourths of it are the least that is lost; the rest is what the direct form takes.
#[test]
fn walls_add_nothing_to_what_the_mixed_form_dissipates() {
    with_a_large_stack(|| {
        let n = 24;
        let held = DrivenCondition::Value(Drive::Constant(0.0));
        for walls in [
            [[[DrivenCondition::NoFlux]; 2]; 2],
            [[[held]; 2]; 2],
            [[[held]; 2], [[DrivenCondition::NoFlux], [held]]],
        ] {
            let mut problem = NamedProblem::heat([0.7]);
            problem.walls = walls;
            let solver = DiffusionDynamics {
                domain: Domain {
                    axes: [Axis::walls(-12.0, 12.0); 2],
                },
                problem,
                cut_off: plane(n, Still, Form::Mixed, 0.7, 1.9).cut_off,
                epsilon: 1.9,
                field: Still,
                form: Form::Mixed,
                mean: Mean::Arithmetic,
                courant: 0.5,
            };
            let rough = |x: f64, y: f64| (400.0 * x * y + 90.0 * x).sin() + (70.0 * y).cos();
            let mut storage = distorted::<1024>(n, 0.05, rough);
            let (mut state, mut work) = storage.parts();
            solver
                .prepare(&mut HalfLoop, &mut state, &mut work)
                .unwrap();
            let u = state.value.iter().map(|u| u[0]);
            let (gained, lost) = energy(u, &work, (1.9, 0.7));
            // The fluxes of a state beside a held wall are 3/4 of theirs.
            let (lost, is_held) = match walls.iter().flatten().flatten().any(|wall| *wall == held) {
                true => (lost / 0.75, true),
                false => (lost, false),
            };
            let beyond = -(gained + lost) / lost;
            let fits = match is_held {
                true => beyond > 1e-3,
                false => beyond.abs() < 1e-12,
            };
            assert!(lost > 1e-3 && fits, "{walls:?}: {gained} {lost}");
        }
    });
}
