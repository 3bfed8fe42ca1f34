//! How far a solution is from its equation, by finite differences: a check of every exact
//! solution that knows nothing of how it was found.

use super::super::linear::residual::Probe;
use crate::exact::solution::Solution;

/// Step of the differences as a part of `length` and `pace`.
const STEP: f64 = 0.01;

/// Bound of [`residual`]. A difference is wrong by `STEP^6/140 = 7e-15` times the seventh
/// derivative in units of `length`, below 1e4 where that is two thirds of the width of a
/// Gaussian: 1e-10 in all. Rounding leaves `2 (3e-16)/STEP^2 = 6e-12`. A wrong coefficient leaves
/// more than its relative error.
pub(super) const BOUND: f64 = 1e-9;

/// How many points in place and time.
const POINTS: u32 = 40;

/// `du/dt + div(a u) - div(B_c grad u_c) = f(u)`.
pub(super) trait Equation {
    fn dimension(&self) -> usize;
    /// a.
    fn velocity(&self, _position: [f64; 3]) -> [f64; 3] {
        [0.0; 3]
    }
    /// B of a component.
    fn diffusion(&self, position: [f64; 3], time: f64, component: usize) -> [[f64; 3]; 3];
    /// f.
    fn reaction(&self, state: &[f64]) -> Vec<f64> {
        vec![0.0; state.len()]
    }
}

/// The product with a matrix row by row; 0 for an empty one.
pub(super) fn product(matrix: &[f64], state: &[f64]) -> Vec<f64> {
    if matrix.is_empty() {
        return vec![0.0; state.len()];
    }
    let row = |row: &[f64]| row.iter().zip(state).map(|(a, u)| a * u).sum();
    matrix.chunks(state.len()).map(row).collect()
}

/// `b T`.
pub(super) fn scaled(tensor: [[f64; 3]; 3], b: f64) -> [[f64; 3]; 3] {
    tensor.map(|row| row.map(|entry| b * entry))
}

/// Sixth-order central difference.
fn derivative(f: impl Fn(f64) -> Vec<f64>, step: f64) -> Vec<f64> {
    let pair = |i: f64| (f(i * step), f(-i * step));
    let [a, b, c] = [pair(1.0), pair(2.0), pair(3.0)];
    let slope = |i: usize| {
        let [a, b, c] = [a.0[i] - a.1[i], b.0[i] - b.1[i], c.0[i] - c.1[i]];
        (45.0 * a - 9.0 * b + c) / (60.0 * step)
    };
    (0..a.0.len()).map(slope).collect()
}

/// `a u - B grad u` along an axis.
fn flux(
    equation: &dyn Equation,
    solution: &dyn Solution,
    (place, time, axis): ([f64; 3], f64, usize),
    step: f64,
) -> Vec<f64> {
    let velocity = equation.velocity(place)[axis];
    let mut flux: Vec<f64> = solution.at(place, time);
    flux.iter_mut().for_each(|u| *u *= velocity);
    for along in 0..equation.dimension() {
        let moved = |dx: f64| {
            let mut place = place;
            place[along] += dx;
            solution.at(place, time)
        };
        for (c, slope) in derivative(moved, step).into_iter().enumerate() {
            flux[c] -= equation.diffusion(place, time, c)[axis][along] * slope;
        }
    }
    flux
}

/// The largest residual of a component at any of the points as a part of the largest sum of
/// the magnitudes of its terms; the worst component's.
pub(super) fn residual(equation: &dyn Equation, solution: &dyn Solution, probe: Probe) -> f64 {
    let p = solution.components();
    let step = STEP * probe.length;
    let (mut worst, mut size) = (vec![0.0_f64; p], vec![0.0_f64; p]);
    for i in 0..POINTS {
        let (place, time) = probe.point(i, equation.dimension());
        let in_time = |dt: f64| solution.at(place, time + dt);
        let mut terms = vec![derivative(in_time, STEP * probe.pace)];
        for axis in 0..equation.dimension() {
            let along = |dx: f64| {
                let mut place = place;
                place[axis] += dx;
                flux(equation, solution, (place, time, axis), step)
            };
            terms.push(derivative(along, step));
        }
        let mut reaction = equation.reaction(&solution.at(place, time));
        reaction.iter_mut().for_each(|f| *f = -*f);
        terms.push(reaction);
        for c in 0..p {
            let sum = terms.iter().map(|term| term[c]).sum::<f64>();
            worst[c] = worst[c].max(sum.abs());
            size[c] = size[c].max(terms.iter().map(|term| term[c].abs()).sum());
        }
    }
    assert!(size.iter().all(|size| *size > 0.0), "nothing happens here");
    (0..p).fold(0.0, |most, c| most.max(worst[c] / size[c]))
}

/// That the equation holds.
pub(super) fn assert_holds(equation: &dyn Equation, solution: &dyn Solution, probe: Probe) {
    let residual = residual(equation, solution, probe);
    assert!(residual < BOUND, "residual {residual:e} at {probe:?}");
}

/// `e^(-b t) sin x`, a solution of `u_t = u_xx` for b = 1 only.
struct Sine(f64);

impl Solution for Sine {
    fn components(&self) -> usize {
        1
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        state[0] = libm::exp(-self.0 * time) * libm::sin(position[0]);
    }
}

impl Equation for Sine {
    fn dimension(&self) -> usize {
        1
    }

    fn diffusion(&self, _: [f64; 3], _: f64, _: usize) -> [[f64; 3]; 3] {
        super::tensor::IDENTITY
    }
}

#[test]
fn a_diffusivity_wrong_by_a_millionth_is_seen() {
    let probe = Probe {
        center: [0.0; 3],
        size: 3.0,
        duration: 1.0,
        length: 1.0,
        pace: 1.0,
    };
    assert_holds(&Sine(1.0), &Sine(1.0), probe);
    let wrong = residual(&Sine(1.0), &Sine(1.000_001), probe);
    // One of the two terms at its largest.
    assert!((wrong / 0.5e-6 - 1.0).abs() < 1e-3, "{wrong:e}");
}
