//! What a run leaves behind beside its particles, in the scenario's units.

use motes_core::digest::Digest;

use super::spread::Spread;

/// One row of the time series.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Time.
    pub time: f64,
    /// Steps made so far.
    pub steps: u64,
    /// The last time step; 0 at the start.
    pub time_step: f64,
    /// A number for each of the names of the series.
    pub values: Vec<f64>,
}

/// The time series of the diagnostics.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What is measured.
    pub names: Vec<String>,
    /// When, and what: the start first, the end last.
    pub samples: Vec<Sample>,
}

impl Series {
    /// The values of that name; empty if there is none.
    pub fn of(&self, name: &str) -> Vec<f64> {
        let place = self.names.iter().position(|known| known == name);
        let column = |place: usize| self.samples.iter().map(|s| s.values[place]).collect();
        place.map_or_else(Vec::new, column)
    }
}

/// What a run came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Particles at the end.
    pub particles: usize,
    /// The time series.
    pub series: Series,
    /// Steps made.
    pub steps: u64,
    /// Right-hand sides made.
    pub evaluations: u64,
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
    /// The same whatever the order of the particles.
    pub digest_unordered: Digest,
    /// How far each sum is off from what it should be at the end, over its size: from that of the
    /// start where it is conserved, from its decay where it decays. Sums of which that is not known
    /// are left out; where it is known of none, all are there, with what has come and gone in them.
    pub drift: Vec<(String, f64)>,
    /// Whether the sums are conserved: no sources, losses, open sides or walls.
    pub is_conserving: bool,
    /// Neighbour counts at the end.
    pub neighbours: Spread,
    /// The part of the state at the end in waves that the solver does not damp.
    pub undamped: f64,
    /// What was computed all the same where in fixed point it could not be proven to stay in range
    /// ([`Threads::allow_unproven`](crate::engine::Threads::allow_unproven)): the first of it.
    pub unproven: Option<String>,
}

impl Outcome {
    /// The drift of a sum; NaN where there is none of that name.
    pub fn drift_of(&self, sum: &str) -> f64 {
        let found = self.drift.iter().find(|(name, _)| name == sum);
        found.map_or(f64::NAN, |(_, drift)| *drift)
    }
}
