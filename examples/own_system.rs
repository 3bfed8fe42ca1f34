//! A system of your own on particles that move: waves with a mass (Klein-Gordon), against the exact
//! wave. `docs/own-system.md` explains each part. `cargo run --release --example own_system`
use std::f64::consts::TAU;

use motes_core::cloud::{Particle, Place, Wave};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::linear::{FirstOrderSystem, LinearDynamics, LinearStorage};
use motes_core::integrator::{RK4, Stepper};
use motes_core::pairs::{HalfLoop, Nothing};
use motes_core::{cutoff::Named, error::Error, neighbours::cell_bound, scalar::Number};

const CELLS: usize = cell_bound(256) as usize + 1;

/// `φ_tt = φ_xx - m² φ` as `∂a/∂t + ∂b/∂x + m c = 0`, `∂b/∂t + ∂a/∂x = 0`, `∂c/∂t - m a = 0` for
/// `a = φ_t`, `b = -φ_x`, `c = m φ`. `A` is symmetric and `A⁰` antisymmetric: nothing grows.
struct KleinGordon(f64);

impl FirstOrderSystem<f64, 1, 3> for KleinGordon {
    type Medium = Nothing;
    const IS_UNIFORM: bool = true;
    fn medium(&self, _: &Place<f64, 1>) -> Nothing {
        Nothing
    }
    fn flux<M: Number<Scalar = f64>>(&self, _: &Nothing, n: &[M; 1], u: &[M; 3]) -> [M; 3] {
        [n[0] * u[1], n[0] * u[0], M::zero()]
    }
    fn decay(&self, _: &Place<f64, 1>, u: &[f64; 3]) -> [f64; 3] {
        [self.0 * u[2], 0.0, -self.0 * u[0]]
    }
    fn speed(&self, _: &Nothing) -> f64 {
        1.0
    }
    fn damping(&self) -> f64 {
        self.0
    }
}

#[rustfmt::skip]
fn main() -> Result<(), Error> {
    for n in [64, 128, 256] {
        // The spacing is 1; two wavelengths in the box, `m = k`, `φ = cos(kx - ωt)`, `ω² = k² + m²`.
        let (length, k) = (f64::from(n), 2.0 * TAU / f64::from(n));
        let exact = |x: f64, t: f64| {
            let (sine, cosine) = (k * x - 2f64.sqrt() * k * t).sin_cos();
            [2f64.sqrt() * sine, sine, cosine]
        };
        let mut storage = LinearStorage::<f64, Nothing, 1, 3, 256, CELLS>::new();
        for i in 0..n {
            let x = f64::from(i) + 0.5;
            storage.push(Particle { position: [x], weight: 1.0, value: exact(x, 0.0) })?;
        }
        let domain = Domain { axes: [Axis::periodic(0.0, length)] };
        let motion = Wave { amplitude: 0.2, length, phase: 0.5 };
        let width = (Named::SmoothFour, length.powf(0.25)); // eps = h^0.75 in boxes
        let dynamics = LinearDynamics::new(domain, width, KleinGordon(k), motion, 0.5);
        let mut run = Stepper::new(dynamics, RK4, HalfLoop, storage)?;
        run.advance_to(0.25 * length)?;
        let state = run.state();
        let errors = state.position.iter().zip(state.value.iter()).map(|(x, u)| {
            let exact = exact(x[0], 0.25 * length);
            (0..3).map(|i| (u[i] - exact[i]).abs()).fold(0.0, f64::max)
        });
        println!("{n:4} particles: largest error {:.2e}", errors.fold(0.0, f64::max));
    }
    Ok(())
}
