//! Both forms in the plane.

use motes_core::equation::diffusion::Form;
use motes_core::equation::linear::Still;
use motes_core::integrator::SSP_RK3;
use motes_core::pairs::HalfLoop;

use crate::clouds::{distorted, plane, run, with_a_large_stack};

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
        let squared = 1.9 * 1.9;
        let rows = state.value.iter().zip(work.last.iter());
        let gained: f64 = rows
            .map(|(u, rates)| u[0] * rates.strength[0] / squared)
            .sum();
        let lost: f64 = work.mixed.nodes[..(n * n) as usize]
            .iter()
            .map(|node| {
                let [p] = node.flux;
                node.node.weight * (p[0] * p[0] + p[1] * p[1]) / squared / 0.7
            })
            .sum();
        assert!(
            lost > 1e-3 && ((gained + lost) / lost).abs() < 1e-12,
            "{gained} {lost}"
        );
    });
}
