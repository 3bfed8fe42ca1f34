//! What is measured of a run beside its errors against the exact solution.

use super::cavity::{Moving, deviation};
use crate::exact::kelvin_helmholtz::{GROWTH_RATE, ModeSample, mode_amplitude};
use crate::experiment::Experiment;
use crate::families::gas::ExactSolution;
use crate::report::suite::Check;
use crate::run::{ScalarName, Simulation};
use crate::scenario::{AnyScenario, Norm, Scenario};
use crate::study::order;

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// The relative drift of the total energy, in f64.
    EnergyDrift {
        /// The most.
        most: f64,
        /// Why.
        reason: &'static str,
    },
    /// The largest relative deviation of the pressure around the contact of a Riemann problem.
    ContactBlip {
        /// Half of the stretch that is looked at.
        within: f64,
        /// The most.
        most: f64,
        /// Why.
        reason: &'static str,
    },
    /// The relative error of the radius of a round shock: where the pressure, as a mean over the
    /// volume of rings one spacing wide, falls through half of what the exact shock leaves.
    ShockRadius {
        /// The exact radius.
        radius: f64,
        /// The most.
        most: f64,
        /// Why.
        reason: &'static str,
    },
    /// The relative error of the growth rate of the Kelvin-Helmholtz mode.
    Growth {
        /// The most.
        most: f64,
        /// Why.
        reason: &'static str,
    },
    /// The deviation of the cavity's velocities along its middle lines, root of the mean square, in those
    /// of the lid.
    Cavity {
        /// The most.
        most: f64,
        /// Why.
        reason: &'static str,
    },
    /// The relative error of the rate at which kinetic energy decays, over the whole run.
    Decay {
        /// The most.
        most: f64,
        /// Why.
        reason: &'static str,
    },
    /// How far the corners of the square have receded, in spacings.
    Corners {
        /// The most.
        most: f64,
        /// Why.
        reason: &'static str,
    },
    /// The order at which an error falls with the spacing: the slope of a straight line.
    Order {
        /// Of which field.
        field: &'static str,
        /// In which norm.
        norm: Norm,
        /// Numbers of particles, at least two.
        particles: &'static [usize],
        /// The least.
        least: f64,
        /// Why.
        reason: &'static str,
    },
}

impl Measure {
    /// The check of a run; `None` where it does not apply to the scalar.
    pub(super) fn check(
        &self,
        experiment: &Experiment,
        growth: &Amplitudes,
        scalar: ScalarName,
    ) -> Option<Check> {
        let (what, measured, bound, reason) = match *self {
            Self::EnergyDrift { most, reason } => {
                if scalar != ScalarName::F64 {
                    return None;
                }
                let drift = experiment.outcome.drift_of("energy").abs();
                ("energy drift", drift, most, reason)
            }
            Self::ContactBlip {
                within,
                most,
                reason,
            } => ("pressure blip", blip(experiment, within), most, reason),
            Self::ShockRadius {
                radius,
                most,
                reason,
            } => {
                let error = (shock_radius(experiment, radius) / radius - 1.0).abs();
                ("shock radius", error, most, reason)
            }
            Self::Growth { most, reason } => {
                let error = (growth.rate() / GROWTH_RATE - 1.0).abs();
                ("growth rate", error, most, reason)
            }
            Self::Cavity { most, reason } => ("middle lines", cavity(experiment), most, reason),
            Self::Decay { most, reason } => ("decay rate", decay(experiment), most, reason),
            Self::Corners { most, reason } => ("corners", corners(experiment), most, reason),
            Self::Order { .. } => return None,
        };
        Some(Check {
            what: what.to_owned(),
            measured,
            bound,
            reason: reason.to_owned(),
            lower: false,
        })
    }
}

/// What was run; only gases are measured so.
fn gas(experiment: &Experiment) -> Option<&Scenario> {
    match &experiment.scenario {
        AnyScenario::Gas(scenario) => Some(scenario),
        AnyScenario::Linear(_) => None,
    }
}

/// The solution that the scenario of a gas names.
fn exact(experiment: &Experiment) -> Option<ExactSolution> {
    ExactSolution::of(gas(experiment)?).ok().flatten()
}

/// Positions, volumes and one more column.
fn particles(simulation: &dyn Simulation, heading: &str) -> Vec<([f64; 3], f64, f64)> {
    let mut places = Vec::new();
    simulation.each(|row| places.push((row.position, row.volume)));
    let column = simulation.column(heading).unwrap_or_default();
    let rows = places.into_iter().zip(column);
    rows.map(|((position, volume), value)| (position, volume, value))
        .collect()
}

/// The deviation from the velocities of others in a unit square under a lid of velocity 1.
fn cavity(experiment: &Experiment) -> f64 {
    let Some(scenario) = gas(experiment) else {
        return f64::NAN;
    };
    let simulation = &*experiment.simulation;
    let across = particles(simulation, "velocity_x");
    let along = particles(simulation, "velocity_y");
    let rows = across.iter().zip(&along);
    let moving: Vec<Moving> = rows
        .map(|(&([x, y, _], _, u), &(.., v))| ([x, y], [u, v]))
        .collect();
    deviation(&moving, 1.0 / scenario.diffusion.viscosity)
}

/// `max |p/p* - 1|` over the particles near the contact.
fn blip(experiment: &Experiment, within: f64) -> f64 {
    let contact = exact(experiment).and_then(|exact| exact.contact(experiment.outcome.time));
    let Some((contact, pressure)) = contact else {
        return f64::NAN;
    };
    let near = |x: f64| (x - contact).abs() <= within;
    particles(&*experiment.simulation, "pressure")
        .iter()
        .filter(|(position, ..)| near(position[0]))
        .map(|(.., value)| (value / pressure - 1.0).abs())
        .fold(0.0, f64::max)
}

/// Where the mean pressure on rings of one spacing falls through half of that behind a shock
/// at `exact_radius`.
fn shock_radius(experiment: &Experiment, exact_radius: f64) -> f64 {
    let Some(exact) = exact(experiment) else {
        return f64::NAN;
    };
    // Inside even where the radius is rounded; the profile is flat on that scale.
    let behind = [exact_radius * (1.0 - 1e-4), 0.0, 0.0];
    let half = 0.5 * exact.state(behind, experiment.outcome.time).pressure;
    let dimension = experiment.scenario.dimension() as f64;
    let particles = particles(&*experiment.simulation, "pressure");
    let volume: f64 = particles.iter().map(|(_, volume, _)| volume).sum();
    let spacing = (volume / particles.len() as f64).powf(1.0 / dimension);
    let radius = |x: &[f64; 3]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let mut rings: Vec<(f64, f64)> = Vec::new();
    for (position, volume, pressure) in &particles {
        let ring = (radius(position) / spacing) as usize;
        if ring >= rings.len() {
            rings.resize(ring + 1, (0.0, 0.0));
        }
        rings[ring].0 += volume * pressure;
        rings[ring].1 += volume;
    }
    let means: Vec<f64> = rings.iter().map(|(sum, volume)| sum / volume).collect();
    let centre = |ring: usize| (ring as f64 + 0.5) * spacing;
    // From outside: the last ring above half.
    let last = means.iter().rposition(|&mean| mean >= half);
    last.filter(|&ring| ring + 1 < means.len())
        .map_or(f64::NAN, |ring| {
            let (above, below) = (means[ring], means[ring + 1]);
            centre(ring) + (above - half) / (above - below) * spacing
        })
}

/// `|r/R - 1|` of the rate r at which kinetic energy decays and that of the exact solution, R, at the places and with
/// the volumes of the particles.
fn decay(experiment: &Experiment) -> f64 {
    let outcome = &experiment.outcome;
    let energies = outcome.series.of("kinetic_energy");
    let (Some(exact), [first, .., last]) = (exact(experiment), &energies[..]) else {
        return f64::NAN;
    };
    let particles = particles(&*experiment.simulation, "density");
    let right: f64 = particles
        .iter()
        .map(|(position, volume, _)| {
            let state = exact.state(*position, outcome.time);
            let squares = state.velocity.iter().map(|u| u * u).sum::<f64>();
            0.5 * volume * state.density * squares
        })
        .sum();
    (libm::log(first / last) / libm::log(first / right) - 1.0).abs()
}

/// The largest distance of a corner of the square from the nearest particle of it, in
/// spacings, less half a diagonal: where the lattice put that particle.
fn corners(experiment: &Experiment) -> f64 {
    let Some(scenario) = gas(experiment) else {
        return f64::NAN;
    };
    let square = &scenario.regions[0].extent;
    let particles = particles(&*experiment.simulation, "material");
    let spacing = (1.0 / particles.len() as f64).sqrt();
    let mut largest = 0.0f64;
    for x in [square.lower[0], square.upper[0]] {
        for y in [square.lower[1], square.upper[1]] {
            let nearest = particles
                .iter()
                .filter(|(.., material)| *material == 0.0)
                .map(|(position, ..)| (position[0] - x).hypot(position[1] - y))
                .fold(f64::INFINITY, f64::min);
            largest = largest.max(nearest / spacing - 0.5f64.sqrt());
        }
    }
    largest
}

/// The amplitude of the Kelvin-Helmholtz mode over time.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Amplitudes(Vec<(f64, f64)>);

/// The time in which the mode grows exponentially, as the reference is fitted.
const LINEAR_PHASE: [f64; 2] = [0.6, 1.2];

impl Amplitudes {
    /// Adds the amplitude of now.
    pub(super) fn add(&mut self, simulation: &dyn Simulation) {
        let time = simulation.time();
        let due = self.0.last().is_none_or(|last| time >= last.0 + 0.02);
        let [first, last] = LINEAR_PHASE;
        if !due || !(first..=last).contains(&time) {
            return;
        }
        let rows = particles(simulation, "velocity_y");
        let samples = rows
            .iter()
            .map(|&(position, volume, velocity_y)| ModeSample {
                position: [position[0], position[1]],
                velocity_y,
                volume,
            });
        if let Some(amplitude) = mode_amplitude(samples) {
            self.0.push((time, amplitude));
        }
    }

    /// The slope of `ln M` over time, by least squares.
    fn rate(&self) -> f64 {
        let points: Vec<(f64, f64)> = self.0.iter().map(|(t, m)| (t.exp(), *m)).collect();
        order(&points)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rate_is_that_of_an_exponential() {
        let samples = (0..10).map(|i| f64::from(i) * 0.1);
        let growth = Amplitudes(samples.map(|t| (t, 0.01 * (2.5 * t).exp())).collect());
        assert!((growth.rate() - 2.5).abs() < 1e-12);
    }
}
