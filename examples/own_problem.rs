//! A convection-diffusion problem of your own: a rod that is hot at one end and loses heat along its way,
//! against its exact steady state. `docs/own-system.md` explains each part.
//! `cargo run --release --example own_problem`
use motes_core::cloud::{Particle, Place, Still};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::diffusion::{
    Condition, DiffusionDynamics, DiffusionProblem, DirectStorage, Form, Mean,
};
use motes_core::integrator::{DiffusionMethod, Scheme, Stepper};
use motes_core::{cutoff::QuinticSpline, error::Error, neighbours::cell_bound, pairs::HalfLoop};

const CELLS: usize = cell_bound(64) as usize + 1;

/// `∂u/∂t - ∂/∂x(b ∂u/∂x) = -loss u`, `u = hot` at the lower end, no flux through the upper one.
struct Rod {
    diffusivity: f64,
    loss: f64,
    hot: f64,
}

impl DiffusionProblem<f64, 1, 1> for Rod {
    // b(x,t) of each species
    fn diffusivity(&self, _: &Place<f64, 1>) -> [f64; 1] {
        [self.diffusivity]
    }
    // f(x,t,u)
    fn reaction(&self, _: &Place<f64, 1>, u: &[f64; 1]) -> [f64; 1] {
        [-self.loss * u[0]]
    }
    // A bound of the eigenvalues of ∂f/∂u: it limits the step.
    fn reaction_rate(&self) -> f64 {
        self.loss
    }
    // What holds at the lower (0) and the upper (1) wall.
    fn wall(&self, _: usize, end: usize, _: f64) -> [Condition<f64>; 1] {
        match end {
            0 => [Condition::Value(self.hot)],
            _ => [Condition::NoFlux],
        }
    }
}

#[rustfmt::skip]
fn main() -> Result<(), Error> {
    for n in [16, 32, 64] {
        // The spacing is 1, and the diffusivity.
        let length = f64::from(n);
        let rod = Rod { diffusivity: 1.0, loss: (2.0 / length).powi(2), hot: 100.0 };
        let mut memory = Box::new(DirectStorage::<f64, 1, 1, 64, CELLS>::new());
        for k in 0..n {
            memory.push(Particle { position: [f64::from(k) + 0.5], weight: 1.0, value: [0.0] })?;
        }
        let dynamics = DiffusionDynamics {
            domain: Domain { axes: [Axis::walls(0.0, length)] },
            problem: rod, field: Still, cut_off: QuinticSpline, epsilon: 0.7 * length.powf(0.25),
            form: Form::Direct, mean: Mean::Arithmetic, courant: 0.8,
        };
        let method = DiffusionMethod { scheme: Scheme::Stabilised(9), longest: f64::INFINITY };
        let mut run = Stepper::new(dynamics, method, HalfLoop, &mut *memory)?;
        run.advance_to(10.0 * length * length)?;
        // hot cosh(m (L - x))/cosh(m L), m² = loss/b.
        let exact = |x: f64| 100.0 * (2.0 * (1.0 - x / length)).cosh() / 2f64.cosh();
        let state = run.state();
        let errors = state.position.iter().zip(state.value.iter());
        let largest = errors.map(|(x, u)| (u[0] - exact(x[0])).abs()).fold(0.0, f64::max);
        println!("{n:3} particles: largest error {largest:.2}");
    }
    Ok(())
}
