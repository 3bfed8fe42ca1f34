//! What a run of a linear system leaves behind, in the scenario's units.

use motes_core::digest::Digest;

use crate::simulation::Spread;

/// The particles at some time, in id order.
#[derive(Clone, Debug, PartialEq)]
pub struct Cloud {
    /// Positions; 0 beyond the dimension.
    pub positions: Vec<[f64; 3]>,
    /// Weights.
    pub weights: Vec<f64>,
    /// Number of components of a value.
    pub components: usize,
    /// Values, one particle after the other.
    pub values: Vec<f64>,
    /// Partners within the support, without itself.
    pub neighbours: Vec<f64>,
}

impl Cloud {
    /// Number of particles.
    pub fn len(&self) -> usize {
        self.weights.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.weights.is_empty()
    }

    /// `u` of a particle.
    pub fn value(&self, id: usize) -> &[f64] {
        &self.values[id * self.components..(id + 1) * self.components]
    }

    /// One component of all particles.
    pub fn component(&self, component: usize) -> Vec<f64> {
        let of = |id| self.value(id)[component];
        (0..self.len()).map(of).collect()
    }
}

/// The energy norm `(Σ w u·Pu)^(1/2)` and what it may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy {
    /// It.
    pub norm: f64,
    /// What no solution exceeds; infinite where nothing bounds them.
    pub bound: f64,
}

/// One row of the time series.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Time.
    pub time: f64,
    /// Steps made so far.
    pub steps: u64,
    /// The last time step; 0 at the start.
    pub time_step: f64,
    /// `Σ_k q_k`.
    pub totals: Vec<f64>,
    /// `Σ_k |q_k|`.
    pub sizes: Vec<f64>,
    /// The energy norm.
    pub energy: Energy,
    /// Each component.
    pub spreads: Vec<Spread>,
    /// Neighbour counts.
    pub neighbours: Spread,
}

/// All of a run's results.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The particles at the end.
    pub cloud: Cloud,
    /// The reconstruction (1.13) at the particles, one after the other.
    pub reconstruction: Vec<f64>,
    /// The reconstruction at the points of the probe, one after the other; empty without one.
    pub probe: Vec<f64>,
    /// The time series.
    pub series: Vec<Sample>,
    /// Steps made.
    pub steps: u64,
    /// Right-hand sides made.
    pub sides: u64,
    /// The part of the state at the end in waves that the mixed form of diffusion does not damp.
    pub undamped: f64,
    /// The smallest time step; 0 without any.
    pub smallest_step: f64,
    /// The largest time step.
    pub largest_step: f64,
    /// Time reached.
    pub time: f64,
    /// Wall-clock seconds of the stepping alone.
    pub seconds: f64,
    /// Digest of the last state.
    pub digest: Digest,
    /// How far `Σ_k q_k` of each component has moved, over its `Σ_k |q_k|` at the start or the end,
    /// the larger one; `None` where sources, losses or walls change the sums.
    pub drift: Option<Vec<f64>>,
}
