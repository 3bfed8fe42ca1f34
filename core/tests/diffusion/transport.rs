//! Transport with hardly any diffusion.

use motes_core::domain::Domain;
use motes_core::equation::diffusion::Form;
use motes_core::equation::linear::{Rotation, State};
use motes_core::integrator::SSP_RK3;

use crate::clouds::{distorted, plane, run, with_a_large_stack};
use crate::upwind::Grid;

/// A Gaussian through a full turn at a Peclet number of 10^6, 64 x 64 particles: the peak is kept
/// within 1 %; what is lost is lost to the diffusion that is there. On a grid a second-order upwind
/// scheme loses more than a tenth, and makes wiggles.
#[test]
fn a_gaussian_survives_a_turn_at_a_peclet_number_of_a_million() {
    with_a_large_stack(|| {
        use std::f64::consts::TAU;
        let n = 64;
        let size = f64::from(n);
        let u = |x: f64, y: f64| (-((x - 0.2) * (x - 0.2) + y * y) / 0.005).exp();
        let mut storage = distorted::<4096>(n, 0.0, u);
        let rotation = Rotation {
            rate: TAU / 1000.0,
            center: [0.0; 2],
        };
        // Peclet: speed times radius over b, in spacings.
        let radius = 0.2 * size;
        let diffusivity = (TAU / 1000.0) * radius * radius / 1e6;
        let mut solver = plane(n, rotation, Form::Direct, diffusivity, 2.0);
        solver.domain = Domain::FREE;
        let (mut state, mut work) = storage.parts();
        let peak =
            |state: &State<'_, f64, 2, 1>| state.value.iter().map(|u| u[0]).fold(0.0, f64::max);
        let lowest =
            |state: &State<'_, f64, 2, 1>| state.value.iter().map(|u| u[0]).fold(0.0, f64::min);
        let first = peak(&state);
        run(&solver, &SSP_RK3, &mut state, &mut work, 1000.0);
        let kept = peak(&state) / first;
        assert!((0.99..1.0).contains(&kept), "{kept}");
        assert!(lowest(&state) > -1e-6, "wiggles: {}", lowest(&state));

        // The grid has the same cells, and steps within its own limit.
        let mut grid = Grid::new(64, |x, y| u(x / size, y / size));
        let whole = grid.range().0;
        assert!((whole - first).abs() < 1e-12, "{whole} {first}");
        for _ in 0..2000 {
            grid.advance(0.5, TAU / 1000.0, diffusivity);
        }
        let (left, wiggle) = (grid.range().0 / whole, grid.range().1);
        println!(
            "peak after a turn: particles {kept:.6}, lowest {:.1e}; upwind grid {left:.6}, lowest \
             {wiggle:.1e}",
            lowest(&state)
        );
        assert!(left < 0.9 && wiggle < -0.01, "{left} {wiggle}");
    });
}
