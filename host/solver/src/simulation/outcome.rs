//! What a run leaves behind, in the scenario's units.

use motes_core::digest::Digest;

/// One particle at the end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParticleRow {
    /// Position; 0 beyond the dimension.
    pub position: [f64; 3],
    /// Velocity; 0 beyond the dimension.
    pub velocity: [f64; 3],
    /// Mass.
    pub mass: f64,
    /// Density.
    pub density: f64,
    /// Pressure.
    pub pressure: f64,
    /// Internal energy per mass.
    pub energy: f64,
    /// Sound speed.
    pub sound_speed: f64,
    /// `div u`.
    pub divergence: f64,
    /// Factor of the viscosity's α.
    pub viscosity_factor: f64,
    /// Width of the cut-off.
    pub epsilon: f64,
    /// Partners within the support, without itself.
    pub neighbours: f64,
    /// Number of the material.
    pub material: u8,
}

impl ParticleRow {
    /// `|u|`.
    pub fn speed(&self) -> f64 {
        self.velocity.iter().map(|u| u * u).sum::<f64>().sqrt()
    }
}

/// Smallest, mean and largest of something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The smallest.
    pub min: f64,
    /// The mean.
    pub mean: f64,
    /// The largest.
    pub max: f64,
}

impl Spread {
    /// Of these values; all NaN if there are none.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let (mut min, mut max, mut sum, mut n) = (f64::INFINITY, f64::NEG_INFINITY, 0.0, 0.0);
        for value in values {
            (min, max, sum, n) = (min.min(value), max.max(value), sum + value, n + 1.0);
        }
        if n > 0.0 {
            Self {
                min,
                mean: sum / n,
                max,
            }
        } else {
            Self {
                min: f64::NAN,
                mean: f64::NAN,
                max: f64::NAN,
            }
        }
    }
}

/// One row of the time series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Time.
    pub time: f64,
    /// Steps made so far.
    pub steps: u64,
    /// The last time step; 0 at the start.
    pub time_step: f64,
    /// Sum of masses.
    pub mass: f64,
    /// Sum of momenta.
    pub momentum: [f64; 3],
    /// Sum of angular momenta about the origin.
    pub angular_momentum: [f64; 3],
    /// Sum of internal and kinetic energies, and of those in the external acceleration.
    pub energy: f64,
    /// The kinetic part of it.
    pub kinetic_energy: f64,
    /// Densities.
    pub density: Spread,
    /// Speeds `|u|`; in one dimension velocities.
    pub velocity: Spread,
    /// Pressures.
    pub pressure: Spread,
    /// Neighbour counts.
    pub neighbours: Spread,
}

/// How far the conserved sums have moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// Of mass, relative.
    pub mass: f64,
    /// Of momentum, its length over total mass times the reference speed.
    pub momentum: f64,
    /// Of angular momentum, over total mass times the reference speed times the size of the
    /// domain.
    pub angular_momentum: f64,
    /// Of energy, relative.
    pub energy: f64,
}

/// A particle with fewer neighbours than a density can be trusted with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lonely {
    /// Its id.
    pub particle: usize,
    /// When that was first seen.
    pub time: f64,
    /// How many it had.
    pub neighbours: f64,
}

/// All of a run's results.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The particles at the end, in id order, without those beyond inflow and outflow sides.
    pub particles: Vec<ParticleRow>,
    /// The time series.
    pub series: Vec<Sample>,
    /// Steps made.
    pub steps: u64,
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
    /// Drift of the sums from the first to the last state; with inflow and outflow sides what
    /// has flowed is in it.
    pub drift: Drift,
    /// Whether there are inflow or outflow sides.
    pub is_open: bool,
    /// The first particle seen with too few neighbours.
    pub lonely: Option<Lonely>,
}
