//! The particles that a cloud starts with.

use motes_core::equation::linear::Particle;
use motes_core::scalar::Scalar;

/// Those of a plan, in solver units, on their way into the memory of a run.
pub(in crate::families) struct Particles {
    /// `x_k`.
    pub(super) positions: Vec<[f64; 3]>,
    /// `w_k`.
    pub(super) weights: Vec<f64>,
    /// `u_k`, one after the other.
    pub(super) values: Vec<f64>,
    /// Numbers in each of them.
    pub(super) components: usize,
}

impl Particles {
    /// Each in the scalar and dimension of the run, with zeros for components beyond its own.
    pub fn rows<S: Scalar, const D: usize, const P: usize>(
        self,
    ) -> impl Iterator<Item = Particle<S, D, P>> {
        let Self {
            positions,
            weights,
            values,
            components,
        } = self;
        let places = positions.into_iter().zip(weights);
        places.enumerate().map(move |(id, (x, w))| {
            particle(x, w, &values[id * components..(id + 1) * components])
        })
    }
}

/// A particle with its numbers rounded once, and zeros for components that it does not have.
pub(super) fn particle<S: Scalar, const D: usize, const P: usize>(
    x: [f64; 3],
    w: f64,
    u: &[f64],
) -> Particle<S, D, P> {
    Particle {
        position: std::array::from_fn(|i| S::from_f64(x[i])),
        weight: S::from_f64(w),
        value: std::array::from_fn(|i| u.get(i).map_or(S::ZERO, |&u| S::from_f64(u))),
    }
}
