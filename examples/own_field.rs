//! A velocity field of your own: a whirl that turns back, and the tracer that it carries and returns.
//! `docs/own-system.md` explains each part. `cargo run --release --example own_field`
use std::f64::consts::{PI, TAU};

use motes_core::cloud::{Particle, Place, VelocityField};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::linear::systems::Transport;
use motes_core::equation::linear::{LinearDynamics, LinearStorage};
use motes_core::integrator::{RK4, Stepper};
use motes_core::pairs::{HalfLoop, Nothing};
use motes_core::{cutoff::QuinticSpline, error::Error, neighbours::cell_bound};

const SIDE: usize = 24;
const N: usize = SIDE * SIDE;
const CELLS: usize = cell_bound(N as u32) as usize + 1;

/// `a = g(t) (sin²(πx/L) sin(2πy/L), -sin²(πy/L) sin(2πx/L))`, `g(t) = speed cos(πt/period)`, in a box of
/// length L from 0: nothing passes its sides, and after a period all is back at its place.
#[derive(Clone, Copy)]
struct Whirl {
    length: f64,
    speed: f64,
    period: f64,
}

impl VelocityField<f64, 2> for Whirl {
    // a(x,t)
    fn velocity(&self, place: &Place<f64, 2>) -> [f64; 2] {
        let [x, y] = place.position.map(|x| PI * x / self.length);
        let now = self.speed * (PI * place.time / self.period).cos();
        let along = |x: f64, y: f64| now * x.sin() * x.sin() * (2.0 * y).sin();
        [along(x, y), -along(y, x)]
    }
    // div a: 2 sin(πx/L) cos(πx/L) sin(2πy/L) and the same with the other sign.
    fn divergence(&self, _: &Place<f64, 2>) -> f64 {
        0.0
    }
    // A bound of |∂_i a^j|: it limits the step.
    fn gradient(&self) -> f64 {
        TAU * self.speed / self.length
    }
    // A bound of -div a.
    fn convergence(&self) -> f64 {
        0.0
    }
}

#[rustfmt::skip]
fn main() -> Result<(), Error> {
    let length = SIDE as f64;
    let whirl = Whirl { length, speed: 1.0, period: 2.0 * length };
    let tracer = |[x, y]: [f64; 2]| (-((x - 6.0).powi(2) + (y - 12.0).powi(2)) / 18.0).exp();
    let place = |k: usize| [(k % SIDE) as f64 + 0.5, (k / SIDE) as f64 + 0.5];

    let mut memory = Box::new(LinearStorage::<f64, Nothing, 2, 1, N, CELLS>::new());
    for k in 0..N {
        memory.push(Particle { position: place(k), weight: 1.0, value: [tracer(place(k))] })?;
    }
    let wall = Axis::walls(0.0, length);
    let domain = Domain { axes: [wall, wall] };
    let system = Transport { velocity: whirl, decay: 0.0, source: 0.0 };
    let dynamics = LinearDynamics::new(domain, (QuinticSpline, 1.2), system, whirl, 0.8);
    let mut run = Stepper::new(dynamics, RK4, HalfLoop, &mut *memory)?;

    run.advance_to(0.5 * whirl.period)?;
    println!("half way: {:.1} spacings away at the most", farthest(run.state().position, place));
    run.advance_to(whirl.period)?;
    println!("at the end: {:.0e} spacings away at the most", farthest(run.state().position, place));
    let change = |(k, u): (usize, &[f64; 1])| (u[0] - tracer(place(k))).abs();
    let change = run.state().value.iter().enumerate().map(change).fold(0.0, f64::max);
    println!("the tracer has changed by {change:.0e} at the most");
    Ok(())
}

/// How far particles are from where they started.
fn farthest(positions: &[[f64; 2]], start: impl Fn(usize) -> [f64; 2]) -> f64 {
    let away = positions.iter().enumerate().map(|(k, x)| {
        let from = start(k);
        (x[0] - from[0]).hypot(x[1] - from[1])
    });
    away.fold(0.0, f64::max)
}
