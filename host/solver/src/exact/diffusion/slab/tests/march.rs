//! Crank and Nicolson's scheme tends to the solution.

use super::super::*;
use super::slabs::{slab, stacks};

/// Crank's and Nicolson's march on `count` cells a layer, from 4 steps of Euler's, to t = 1.5.
fn march(layers: &[Layer], ends: &[End; 2], count: usize) -> Vec<f64> {
    let cells: Vec<(f64, f64)> = layers
        .iter()
        .flat_map(|layer| vec![(layer.thickness / count as f64, layer.diffusivity); count])
        .collect();
    let n = cells.len();
    let half = |(width, b): (f64, f64)| 0.5 * width / b;
    // Conductance to the neighbour above or to what drives an end, and that.
    let inner = |i: usize| 1.0 / (half(cells[i]) + half(cells[i + 1]));
    let outer = |side: usize, time: f64| {
        let cell = half(cells[side * (n - 1)]);
        match &ends[side] {
            End::NoFlux => [0.0, 0.0],
            End::Value(drive) => [1.0 / cell, drive.at(time) / cell],
            End::Flux(drive) => [0.0, -drive.at(time)],
            End::Exchange { rate, outside } => {
                let conductance = 1.0 / (cell + 1.0 / rate);
                [conductance, conductance * outside.at(time)]
            }
        }
    };
    let mut u = vec![0.25; n];
    let step = |u: &mut Vec<f64>, from: f64, dt: f64, implicit: f64| {
        let (ends_now, ends_then) = (
            [0, 1].map(|s| outer(s, from)),
            [0, 1].map(|s| outer(s, from + dt)),
        );
        let mut diagonal = vec![0.0; n];
        let mut right = vec![0.0; n];
        for i in 0..n {
            let below = if i > 0 { inner(i - 1) } else { 0.0 };
            let above = if i + 1 < n { inner(i) } else { 0.0 };
            let (mut now, mut given, mut loss) = (0.0, 0.0, below + above);
            if i > 0 {
                now += below * (u[i - 1] - u[i]);
            }
            if i + 1 < n {
                now += above * (u[i + 1] - u[i]);
            }
            for side in 0..2 {
                if i == side * (n - 1) {
                    now += ends_now[side][1] - ends_now[side][0] * u[i];
                    given += ends_then[side][1];
                    loss += ends_then[side][0];
                }
            }
            let rate = dt / cells[i].0;
            diagonal[i] = 1.0 / rate + implicit * loss;
            right[i] = u[i] / rate + (1.0 - implicit) * now + implicit * given;
        }
        for i in 1..n {
            let off = implicit * inner(i - 1);
            let factor = off / diagonal[i - 1];
            diagonal[i] -= factor * off;
            right[i] += factor * right[i - 1];
        }
        for i in (0..n).rev() {
            let next = if i + 1 < n {
                implicit * inner(i) * u[i + 1]
            } else {
                0.0
            };
            u[i] = (right[i] + next) / diagonal[i];
        }
    };
    let steps = 40 * count;
    let dt = 1.5 / steps as f64;
    for i in 0..4 {
        step(&mut u, 0.25 * dt * f64::from(i), 0.25 * dt, 1.0);
    }
    for i in 1..steps {
        step(&mut u, dt * i as f64, dt, 0.5);
    }
    u
}

/// Second order of the march: halved cells leave a quarter of the error.
#[test]
fn a_march_in_time_tends_to_it() {
    for ends in super::slabs::ends() {
        let slab = slab(&stacks()[1], &ends);
        let error = |count: usize| {
            let u = march(&stacks()[1], &ends, count);
            let (mut lower, mut worst) = (-0.3, 0.0_f64);
            for (layer, u) in stacks()[1].iter().zip(u.chunks(count)) {
                for (i, u) in u.iter().enumerate() {
                    let x = lower + layer.thickness * (i as f64 + 0.5) / count as f64;
                    worst = worst.max((u - slab.at([x, 0.0, 0.0], 1.5)[0]).abs());
                }
                lower += layer.thickness;
            }
            worst
        };
        if ends == [End::NoFlux, End::NoFlux] {
            // Rounding of 400 steps.
            assert!(error(10) < 1e-12);
            continue;
        }
        let errors = [10, 20, 40].map(error);
        assert!(errors[2] < 1e-3, "{ends:?}: {errors:?}");
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!(
                (order - 2.0).abs() < 0.2,
                "{ends:?}: order {order} of {errors:?}"
            );
        }
    }
}
