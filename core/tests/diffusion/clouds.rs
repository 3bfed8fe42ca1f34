//! Clouds on a line and in the plane, and stepping them.

use motes_core::cutoff::Named;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::diffusion::{
    Condition, DiffusionDynamics, DiffusionProblem, DiffusionStorage, DiffusionWorkspace, Form,
    Heat, Mean,
};
use motes_core::equation::linear::{Particle, Place, State, Still, VelocityField};
use motes_core::integrator::{Clock, RungeKutta};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

pub type Storage<S, const D: usize, const N: usize> =
    DiffusionStorage<S, D, 1, N, { 4 * 4096 + 129 }>;

/// The memory of a step.
pub type Work<'a, S, const D: usize> = DiffusionWorkspace<'a, S, D, 1>;

/// Runs a test with room for storages that are made by value.
pub fn with_a_large_stack(test: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(64 << 20);
    thread.spawn(test).unwrap().join().unwrap();
}

/// A storage on the heap.
pub fn storage<S: Scalar, const D: usize, const N: usize>() -> Box<Storage<S, D, N>> {
    Box::new(DiffusionStorage::new())
}

/// The order between two errors at half the size.
pub fn order(coarse: f64, fine: f64) -> f64 {
    (coarse / fine).log2()
}

/// A slab between two walls of its own.
#[derive(Clone, Copy)]
pub struct Slab<S> {
    /// Conditions at the lower and the upper wall.
    pub ends: [Condition<S>; 2],
}

impl<S: Scalar> DiffusionProblem<S, 1, 1> for Slab<S> {
    fn diffusivity(&self, _: &Place<S, 1>) -> [S; 1] {
        [S::ONE.half()]
    }
    fn wall(&self, _: usize, end: usize, _: S) -> [Condition<S>; 1] {
        [self.ends[end.min(1)]]
    }
}

pub type Line<S, B> = DiffusionDynamics<S, Named, B, Still, 1, 1>;

/// A solver on `n` spacings between walls.
pub fn line<S: Scalar, B>(n: u32, problem: B, form: Form, epsilon: f64) -> Line<S, B> {
    let half = S::count(n).half();
    DiffusionDynamics {
        domain: Domain {
            axes: [Axis::walls(-half, half)],
        },
        cut_off: Named::QuinticSpline,
        epsilon: S::from_f64(epsilon),
        problem,
        field: Still,
        form,
        mean: Mean::Arithmetic,
        courant: S::ONE.half(),
    }
}

/// Particles at the middles of `n` cells.
pub fn fill<S: Scalar, const N: usize>(
    storage: &mut Storage<S, 1, N>,
    n: u32,
    u: impl Fn(f64) -> f64,
) {
    for k in 0..n {
        let x = f64::from(k) + 0.5 - 0.5 * f64::from(n);
        let particle = Particle {
            position: [S::from_f64(x)],
            weight: S::ONE,
            value: [S::from_f64(u(x))],
        };
        storage.push(particle).unwrap();
    }
}

/// Steps a problem to its end; how many right-hand sides that took.
pub fn run<S: Scalar, B, A, const D: usize>(
    solver: &DiffusionDynamics<S, Named, B, A, D, 1>,
    method: &RungeKutta,
    state: &mut State<'_, S, D, 1>,
    work: &mut Work<'_, S, D>,
    end: S,
) -> u32
where
    B: DiffusionProblem<S, D, 1>,
    A: VelocityField<S, D>,
{
    let engine = &mut HalfLoop;
    solver.prepare(engine, state, work).unwrap();
    let mut clock = Clock::new(end);
    let mut sides = 0;
    while let Some(left) = clock.left() {
        let radius = solver.radius(state, work).unwrap();
        let dt = solver
            .time_step(radius, S::from_f64(method.real), left)
            .unwrap();
        solver
            .advance(method, engine, state, work, (clock.time, dt))
            .unwrap();
        sides += 1 + method.stages.len() as u32;
        clock.tick(dt).unwrap();
    }
    sides
}

pub type Plane<A> = DiffusionDynamics<f64, Named, Heat<f64>, A, 2, 1>;

/// `n` x `n` particles under a smooth map of the square of side `n` onto itself.
pub fn distorted<const N: usize>(
    n: u32,
    amplitude: f64,
    u: impl Fn(f64, f64) -> f64,
) -> Box<Storage<f64, 2, N>> {
    use std::f64::consts::TAU;
    let mut storage = storage::<f64, 2, N>();
    let size = f64::from(n);
    for i in 0..n {
        for j in 0..n {
            let [s, t] = [i, j].map(|i| (f64::from(i) + 0.5) / size);
            let (a, b) = (TAU * s, TAU * t);
            let x = s + amplitude * a.sin() * b.cos();
            let y = t + amplitude * b.sin() * a.cos();
            let along = 1.0 + TAU * amplitude * a.cos() * b.cos();
            let across = TAU * amplitude * a.sin() * b.sin();
            let position = [(x - 0.5) * size, (y - 0.5) * size];
            let particle = Particle {
                position,
                weight: along * along - across * across,
                value: [u(x - 0.5, y - 0.5)],
            };
            storage.push(particle).unwrap();
        }
    }
    storage
}

pub fn plane<A>(n: u32, field: A, form: Form, diffusivity: f64, epsilon: f64) -> Plane<A> {
    let half = 0.5 * f64::from(n);
    DiffusionDynamics {
        domain: Domain {
            axes: [Axis::periodic(-half, half); 2],
        },
        cut_off: Named::QuinticSpline,
        epsilon,
        problem: Heat { diffusivity },
        field,
        form,
        mean: Mean::Arithmetic,
        courant: 0.5,
    }
}
