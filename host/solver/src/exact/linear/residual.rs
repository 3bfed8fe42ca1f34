//! How far a solution is from its equation, by finite differences: a check of every exact
//! solution that knows nothing of how it was found.

use super::system::System;
use crate::exact::solution::Solution;

/// Step of the differences as a part of `length` and `pace`: fifth root of the rounding of
/// f64, which balances the error of the formula, O(STEP^4), against the rounding,
/// O(2e-16 / STEP).
const STEP: f64 = 7e-4;

/// Bound of [`residual`]. The differences are wrong by `STEP^4/30 = 8e-15` times the fifth
/// derivative in units of `length`, some tens for a Gaussian of that width: below 1e-12. The
/// values are wrong by some 3 roundings, `1.5 * 3 * 2e-16 / STEP = 1.4e-12` of u/length, and two
/// or three such terms add up. A wrong coefficient leaves more than its relative error.
pub(in crate::exact) const BOUND: f64 = 1e-11;

/// How many points in place and time.
const POINTS: u32 = 40;

/// The left-hand side less the derivative in time, and the right-hand side.
pub(in crate::exact) trait Equation {
    fn dimension(&self) -> usize;
    /// `A^i u` along an axis.
    fn flux(&self, position: [f64; 3], axis: usize, state: &[f64]) -> Vec<f64>;
    /// `A^0 u - f`.
    fn reaction(&self, state: &[f64]) -> Vec<f64>;
}

fn product(matrix: &[f64], state: &[f64]) -> Vec<f64> {
    let row = |row: &[f64]| row.iter().zip(state).map(|(a, u)| a * u).sum();
    matrix.chunks(state.len()).map(row).collect()
}

impl Equation for System {
    fn dimension(&self) -> usize {
        self.fluxes.len()
    }

    fn flux(&self, _: [f64; 3], axis: usize, state: &[f64]) -> Vec<f64> {
        product(&self.fluxes[axis], state)
    }

    fn reaction(&self, state: &[f64]) -> Vec<f64> {
        product(&self.reaction, state)
    }
}

/// Where to look, and how fast the solution varies there.
#[derive(Debug, Clone, Copy)]
pub(in crate::exact) struct Probe {
    /// The points lie within `size` of it in every direction.
    pub center: [f64; 3],
    pub size: f64,
    /// The times lie from 0 to it.
    pub duration: f64,
    /// Over which the solution varies by its own size.
    pub length: f64,
    /// The same in time.
    pub pace: f64,
}

impl Probe {
    /// A place and a time: multiples of irrational numbers, which leave no gaps.
    pub(in crate::exact) fn point(&self, i: u32, dimension: usize) -> ([f64; 3], f64) {
        let part = |root: f64| (f64::from(i + 1) * root.sqrt()).fract();
        let parts = [part(2.0), part(3.0), part(5.0)];
        let place = std::array::from_fn(|axis| {
            if axis < dimension {
                self.center[axis] + self.size * (2.0 * parts[axis] - 1.0)
            } else {
                0.0
            }
        });
        (place, self.duration * part(7.0))
    }
}

/// Fourth-order central difference.
fn derivative(f: impl Fn(f64) -> Vec<f64>, step: f64) -> Vec<f64> {
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|i| f(i * step));
    let slope = |i: usize| (a[i] - d[i] + 8.0 * (c[i] - b[i])) / (12.0 * step);
    (0..a.len()).map(slope).collect()
}

/// The largest residual of a component at any of the points as a part of the largest sum of
/// the magnitudes of its terms; the worst component's.
pub(in crate::exact) fn residual(
    equation: &dyn Equation,
    solution: &dyn Solution,
    probe: Probe,
) -> f64 {
    let p = solution.components();
    let (mut worst, mut size) = (vec![0.0_f64; p], vec![0.0_f64; p]);
    for i in 0..POINTS {
        let (place, time) = probe.point(i, equation.dimension());
        let in_time = |dt: f64| solution.at(place, time + dt);
        let mut terms = vec![derivative(in_time, STEP * probe.pace)];
        for axis in 0..equation.dimension() {
            let along = |dx: f64| {
                let mut place = place;
                place[axis] += dx;
                equation.flux(place, axis, &solution.at(place, time))
            };
            terms.push(derivative(along, STEP * probe.length));
        }
        terms.push(equation.reaction(&solution.at(place, time)));
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
pub(in crate::exact) fn assert_holds(
    equation: &dyn Equation,
    solution: &dyn Solution,
    probe: Probe,
) {
    let residual = residual(equation, solution, probe);
    assert!(residual < BOUND, "residual {residual:e} at {probe:?}");
}

/// `sin(x - c t)`, a solution of `u_t + u_x = 0` for c = 1 only.
struct Sine(f64);

impl Solution for Sine {
    fn components(&self) -> usize {
        1
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        state[0] = libm::sin(position[0] - self.0 * time);
    }
}

#[test]
fn a_speed_wrong_by_a_millionth_is_seen() {
    let equation = System::zero(1, 1).flux(0, [0, 0], 1.0);
    let probe = Probe {
        center: [0.0; 3],
        size: 3.0,
        duration: 5.0,
        length: 1.0,
        pace: 1.0,
    };
    assert_holds(&equation, &Sine(1.0), probe);
    let wrong = residual(&equation, &Sine(1.000_001), probe);
    // cos / (2 cos) of the terms at its largest.
    assert!((wrong / 0.5e-6 - 1.0).abs() < 1e-3, "{wrong:e}");
}
