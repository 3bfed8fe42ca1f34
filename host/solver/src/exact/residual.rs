//! How far a flow is from satisfying the Euler equations, by finite differences: a check of
//! every smooth exact solution that knows nothing of how it was found.

use super::flow::{Flow, FlowState};

/// Step of the differences as a part of `length`: fifth root of the rounding of f64, which
/// balances the error of the formula, O(STEP^4), against the rounding, O(2e-16 / STEP).
const STEP: f64 = 7e-4;

/// Mass, momentum and total energy per volume.
fn conserved(state: &FlowState) -> [f64; 5] {
    let FlowState {
        density,
        velocity: [u, v, w],
        energy,
        ..
    } = *state;
    let kinetic = 0.5 * (u * u + v * v + w * w);
    let total = density * (energy + kinetic);
    [density, density * u, density * v, density * w, total]
}

/// Their fluxes along an axis.
fn flux(state: &FlowState, axis: usize) -> [f64; 5] {
    let u = state.velocity[axis];
    let mut flux = conserved(state).map(|q| q * u);
    flux[1 + axis] += state.pressure;
    flux[4] += state.pressure * u;
    flux
}

/// Fourth-order central difference.
fn derivative(f: impl Fn(f64) -> [f64; 5], step: f64) -> [f64; 5] {
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|i| f(i * step));
    std::array::from_fn(|i| (a[i] - d[i] + 8.0 * (c[i] - b[i])) / (12.0 * step))
}

/// The largest of the residuals of mass, momentum and energy at a point, as a part of
/// `rho c / length`, `rho c^2 / length` and `rho c^3 / length`, `c = |u| + sqrt(p/rho)`.
/// The flow varies over `length`.
pub(super) fn euler_residual(flow: &dyn Flow, position: [f64; 3], time: f64, length: f64) -> f64 {
    let here = flow.at(position, time);
    let speed = here.velocity.iter().map(|u| u * u).sum::<f64>().sqrt()
        + (here.pressure / here.density).sqrt();
    let step = STEP * length;
    let in_time = |dt: f64| conserved(&flow.at(position, time + dt));
    let mut residual = derivative(in_time, step / speed);
    for axis in 0..3 {
        let along = |dx: f64| {
            let mut place = position;
            place[axis] += dx;
            flux(&flow.at(place, time), axis)
        };
        let slope = derivative(along, step);
        for (sum, term) in residual.iter_mut().zip(slope) {
            *sum += term;
        }
    }
    let momentum = here.density * speed * speed;
    let scales = [
        here.density * speed,
        momentum,
        momentum,
        momentum,
        momentum * speed,
    ];
    let parts = residual.iter().zip(scales);
    parts.fold(0.0, |worst: f64, (r, scale)| {
        worst.max((r * length / scale).abs())
    })
}
