//! A Riemann solution laid along a direction in space.

use super::super::flow::{Flow, FlowError, FlowState, check};
use super::RiemannSolution;

/// Two gases that meet at a plane when t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RiemannFlow {
    solution: RiemannSolution,
    interface: f64,
    normal: [f64; 3],
}

impl RiemannFlow {
    /// The left gas where `x . normal < interface`. The normal has length 1, to 1e-12; the
    /// velocities of the solution are along it, and nothing moves across it.
    ///
    /// # Errors
    /// A number that is not finite, or a normal of another length.
    pub fn new(
        solution: RiemannSolution,
        interface: f64,
        normal: [f64; 3],
    ) -> Result<Self, FlowError> {
        let length = dot(normal, normal).sqrt();
        let unit = (length - 1.0).abs() <= 1e-12;
        check(&[
            ("interface", interface, "a finite number", true),
            ("length of the normal", length, "1", unit),
        ])?;
        Ok(Self {
            solution,
            interface,
            normal,
        })
    }

    /// The solution along the normal.
    pub fn solution(&self) -> &RiemannSolution {
        &self.solution
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Flow for RiemannFlow {
    /// On the interface when t = 0: the left gas.
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let distance = dot(position, self.normal) - self.interface;
        let xi = if time > 0.0 {
            distance / time
        } else if distance > 0.0 {
            f64::INFINITY
        } else {
            f64::NEG_INFINITY
        };
        let state = self.solution.sample(xi);
        FlowState {
            density: state.density,
            velocity: self.normal.map(|n| n * state.velocity),
            pressure: state.pressure,
            energy: self.solution.internal_energy(xi),
        }
    }
}
