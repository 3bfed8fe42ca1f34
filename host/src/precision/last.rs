//! The particles of a run at its end: what is left of it to compare with other runs.

use std::ops::Range;

use crate::experiment::Experiment;
use crate::run::{Portion, RECONSTRUCTION, STATE};
use crate::scenario::{AnyScenario, Domain, Side};

/// The name of the positions among the fields.
pub const POSITION: &str = "position";

/// A field of a last state: one number or several.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Span {
    /// What it is called.
    pub name: String,
    /// Its place among the values of a particle.
    pub places: Range<usize>,
}

impl Span {
    fn new(name: &str, places: Range<usize>) -> Self {
        Self {
            name: name.to_owned(),
            places,
        }
    }
}

/// The particles of a run at its end, in id order and the scenario's units.
#[derive(Clone, Debug, PartialEq)]
pub struct LastState {
    pub(super) spans: Vec<Span>,
    /// Numbers of a particle: position, compared fields, reconstruction.
    width: usize,
    values: Vec<f64>,
    portions: Vec<Portion>,
}

impl LastState {
    /// Of an experiment: positions, what an exact solution has, and of one state all components
    /// together and their reconstruction.
    pub fn of(experiment: &Experiment) -> Self {
        let simulation = &experiment.simulation;
        let description = simulation.description();
        let fields = description.compared();
        let mut parts = vec![(POSITION, description.dimension)];
        parts.extend(fields.map(|field| (field.name.as_str(), field.components)));
        let mut spans: Vec<Span> = Vec::new();
        let mut width = 0;
        for (name, components) in parts {
            spans.push(Span::new(name, width..width + components));
            width += components;
        }
        let state = description.dimension..width;
        let smoothed: &[f64] = match description.is_state {
            true => &experiment.reconstruction,
            false => &[],
        };
        if description.is_state {
            spans.push(Span::new(STATE, state.clone()));
        }
        if !smoothed.is_empty() {
            spans.push(Span::new(RECONSTRUCTION, width..width + state.len()));
            width += state.len();
        }
        let mut smoothed = smoothed.chunks_exact(state.len().max(1));
        let (mut values, mut portions) = (Vec::new(), Vec::new());
        simulation.each(|row| {
            values.extend(&row.position[..description.dimension]);
            for field in description.compared() {
                values.extend(&row.values[field.places()]);
            }
            values.extend(smoothed.next().unwrap_or(&[]));
            portions.push(Portion {
                volume: row.volume,
                mass: 0.0,
            });
        });
        Self {
            spans,
            width,
            values,
            portions,
        }
    }

    /// Number of particles.
    pub fn particles(&self) -> usize {
        self.portions.len()
    }

    /// Volume and values of each particle.
    pub(super) fn rows(&self) -> impl Iterator<Item = (Portion, &[f64])> {
        let rows = self.values.chunks_exact(self.width.max(1));
        self.portions.iter().copied().zip(rows)
    }

    /// A cloud in one dimension, made up: positions and a density each, volumes of 1/2.
    #[cfg(test)]
    pub(super) fn line(rows: &[(f64, f64)]) -> Self {
        let portion = Portion {
            volume: 0.5,
            mass: 0.0,
        };
        Self {
            spans: vec![Span::new(POSITION, 0..1), Span::new("density", 1..2)],
            width: 2,
            values: rows.iter().flat_map(|&(x, u)| [x, u]).collect(),
            portions: vec![portion; rows.len()],
        }
    }
}

/// The domain of a scenario.
fn domain(scenario: &AnyScenario) -> &Domain {
    match scenario {
        AnyScenario::Gas(scenario) => &scenario.domain,
        AnyScenario::Linear(scenario) => &scenario.domain,
    }
}

/// The lengths of the edges of a domain, and along which it is periodic.
pub(super) fn edges(scenario: &AnyScenario) -> Vec<(f64, bool)> {
    let domain = domain(scenario);
    let extent = domain.extent.lower.iter().zip(&domain.extent.upper);
    let lengths = extent.map(|(lower, upper)| upper - lower);
    let sides = domain.sides.iter().map(|sides| sides[0] == Side::Periodic);
    lengths.zip(sides).collect()
}

/// Whether particles come and go, so that one of a run has no partner in another.
pub(super) fn is_open(scenario: &AnyScenario) -> bool {
    domain(scenario)
        .sides
        .iter()
        .flatten()
        .any(|side| side.is_open())
}
