//! The initial state against the paper's formulae, the amplitude of known fields; and the run
//! that makes the reference amplitudes.

use super::super::finite_volume::sweep::{self, Conserved, GHOSTS, Scratch};
use super::*;

/// Equations (1) and (2) as printed, branch by branch, f for density or velocity.
fn as_printed(f1: f64, f2: f64, y: f64) -> f64 {
    let (m, l) = ((f1 - f2) / 2.0, 0.025);
    if y < 0.25 {
        f1 - m * ((y - 0.25) / l).exp()
    } else if y < 0.5 {
        f2 + m * ((-y + 0.25) / l).exp()
    } else if y < 0.75 {
        f2 + m * (-(0.75 - y) / l).exp()
    } else {
        f1 - m * (-(y - 0.75) / l).exp()
    }
}

#[test]
fn the_initial_state_is_that_of_the_paper() {
    for i in 0..100 {
        let (x, y) = (0.37 + 0.01 * f64::from(i), 0.01 * f64::from(i) + 0.003);
        let state = initial([x, y, 0.0]);
        assert!((state.density - as_printed(1.0, 2.0, y)).abs() < 1e-14);
        assert!((state.velocity[0] - as_printed(0.5, -0.5, y)).abs() < 1e-14);
        let seed = 0.01 * (4.0 * PI * x).sin();
        assert!((state.velocity[1] - seed).abs() < 1e-15);
        assert_eq!(state.pressure, 2.5);
    }
}

#[test]
fn the_initial_state_is_periodic() {
    let (a, b) = (initial([0.25, 0.125, 0.0]), initial([1.25, -0.875, 0.0]));
    assert_eq!(a, b);
}

/// The seed has amplitude 0.01 = M, whatever its phase, and a uniform or a shorter wave 0:
/// sums over whole periods of a regular lattice, exact but for rounding.
#[test]
fn the_amplitude_of_a_sine_is_its_own() {
    let amplitude = |v: &dyn Fn(f64) -> f64| {
        let samples = (0..64 * 64).map(|k| {
            let [x, y] = [k % 64, k / 64].map(|i| (f64::from(i) + 0.5) / 64.0);
            ModeSample {
                position: [x, y],
                velocity_y: v(x),
                volume: 1.0 + y,
            }
        });
        mode_amplitude(samples).unwrap()
    };
    for phase in [0.0, 1.0, 2.5] {
        let measured = amplitude(&|x| 0.01 * (4.0 * PI * x + phase).sin());
        assert!((measured / 0.01 - 1.0).abs() < 1e-13, "{measured}");
    }
    assert!(amplitude(&|_| 0.3) < 1e-14);
    assert!(amplitude(&|x| (8.0 * PI * x).sin()) < 1e-14);
    assert_eq!(mode_amplitude([]), None);
}

/// The unit square in n x n cells, rows of x with ghosts on either side.
struct Square {
    n: usize,
    cells: Vec<Conserved>,
    scratch: Scratch,
    row: Vec<Conserved>,
}

impl Square {
    fn new(n: usize) -> Self {
        let cells = (0..n * n).map(|k| {
            let [x, y] = [k % n, k / n].map(|i| (i as f64 + 0.5) / n as f64);
            let state = initial([x, y, 0.0]);
            let [u, v, _] = state.velocity;
            sweep::conserved([state.density, u, v, state.pressure], GAMMA)
        });
        Self {
            n,
            cells: cells.collect(),
            scratch: Scratch::default(),
            row: Vec::new(),
        }
    }

    /// One step along an axis, row by row, the velocities in the order along, across.
    fn sweep(&mut self, axis: usize, step: f64) {
        let n = self.n;
        let turned = |[density, a, b, energy]: Conserved| match axis {
            0 => [density, a, b, energy],
            _ => [density, b, a, energy],
        };
        let (stride, next) = if axis == 0 { (1, n) } else { (n, 1) };
        for line in 0..n {
            let place = |i: usize| line * next + (i % n) * stride;
            self.row.clear();
            let places = (n - GHOSTS..2 * n + GHOSTS).map(|i| turned(self.cells[place(i)]));
            self.row.extend(places);
            sweep::advance(&mut self.row, step * n as f64, GAMMA, &mut self.scratch);
            for i in 0..n {
                self.cells[place(i)] = turned(self.row[i + GHOSTS]);
            }
        }
    }

    /// To a later time by pairs of steps x y, y x: second order, G. Strang 1968.
    fn run(&mut self, mut time: f64, end: f64) {
        while time < end {
            let fastest = self.cells.iter().fold(0.0, |fastest: f64, q| {
                let [u, v, sound] = sweep::speeds(q, GAMMA).unwrap();
                fastest.max(u.max(v) + sound)
            });
            let step = (0.8 / (self.n as f64 * fastest)).min(0.5 * (end - time));
            for axis in [0, 1, 1, 0] {
                self.sweep(axis, step);
            }
            let last = 2.0 * step >= end - time;
            time = if last { end } else { time + 2.0 * step };
        }
    }

    fn amplitude(&self) -> f64 {
        let n = self.n;
        let samples = (0..n * n).map(|k| ModeSample {
            position: [k % n, k / n].map(|i| (i as f64 + 0.5) / n as f64),
            velocity_y: self.cells[k][2] / self.cells[k][0],
            volume: 1.0 / (n * n) as f64,
        });
        mode_amplitude(samples).unwrap()
    }
}

/// Amplitudes at t = 0, 0.1 .. and so on.
fn amplitudes(n: usize, times: usize) -> Vec<f64> {
    let mut square = Square::new(n);
    let mut all = vec![square.amplitude()];
    for pair in REFERENCE[..times].windows(2) {
        square.run(pair[0].time, pair[1].time);
        all.push(square.amplitude());
    }
    all
}

/// 64 x 64 cells, less than two to a layer: errors 8 to 16 times those of 128 x 128, which
/// are 2e-3 of the amplitude up to t = 0.4 (`reference.rs`).
#[test]
fn a_coarse_run_begins_like_the_reference() {
    for (measured, row) in amplitudes(64, 5).into_iter().zip(REFERENCE) {
        let error = measured / row.amplitude - 1.0;
        assert!(error.abs() < 0.03, "t = {}: {error:e}", row.time);
    }
}

#[test]
fn the_growth_rate_is_the_slope_of_the_reference() {
    let rows = &REFERENCE[6..=12];
    let ln = |row: &Reference| row.amplitude.ln();
    let mean_time = rows.iter().map(|row| row.time).sum::<f64>() / 7.0;
    let mean_ln = rows.iter().map(ln).sum::<f64>() / 7.0;
    let (mut product, mut square) = (0.0, 0.0);
    for row in rows {
        let time = row.time - mean_time;
        product += time * (ln(row) - mean_ln);
        square += time * time;
    }
    let rate = product / square;
    assert!((rate - GROWTH_RATE).abs() < 5e-5, "{rate}");
    for row in rows {
        let off = ln(row) - mean_ln - rate * (row.time - mean_time);
        assert!(off.abs() < 0.04, "t = {}: {off}", row.time);
    }
}

#[test]
#[ignore = "makes the table in reference.rs; two minutes in release"]
fn print_the_reference_amplitudes() {
    let [_, half, full] = [128, 256, 512].map(|n| {
        let amplitudes = amplitudes(n, REFERENCE.len());
        println!("{n} {amplitudes:?}");
        amplitudes
    });
    for ((row, half), full) in REFERENCE.into_iter().zip(half).zip(full) {
        assert!((row.amplitude - full).abs() <= 0.6e-8, "{row:?} {full}");
        assert!((half - full).abs() <= row.uncertainty, "{row:?} {half}");
    }
}
