//! What becomes of the sums of the strengths: the pair terms of (1.18) and (4.3) are odd, so that only
//! walls, losses and sources change them.

use crate::exact::linear::modes::exponential::{exponential, product};
use crate::scenario::Side;
use crate::scenario::formula::Formula;
use crate::scenario::linear::{LinearScenario, Reaction, System};

/// What becomes of the sums of a run.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::families) struct Budget {
    /// Of which components it is known: those that nothing comes to or goes from but by `losses`.
    pub known: Vec<bool>,
    /// The matrix of `d(Σ q)/dt = -A⁰ Σ q`, row by row, 1 / time; empty where it is 0.
    losses: Vec<f64>,
}

impl Budget {
    /// That of a scenario.
    pub fn of(scenario: &LinearScenario) -> Self {
        let names = scenario.system.names(scenario.dimension);
        let losses = match scenario.source {
            Some(_) => None,
            None => losses(&scenario.system),
        };
        let known = match &losses {
            None => vec![false; names.len()],
            Some(losses) => {
                let passes = |name: &String| passes_walls(scenario, name);
                let closed = names.iter().map(|name| !passes(name)).collect();
                tied(closed, losses)
            }
        };
        Self {
            known,
            losses: losses.unwrap_or_default(),
        }
    }

    /// Whether no sum changes.
    pub fn is_conserving(&self) -> bool {
        self.losses.is_empty() && self.known.iter().all(|&known| known)
    }

    /// The sums after a time, from those at the start: `e^(-A⁰ t) Σ q`.
    pub fn after(&self, time: f64, sums: &[f64]) -> Vec<f64> {
        if self.losses.is_empty() {
            return sums.to_vec();
        }
        let n = sums.len();
        let matrix: Vec<f64> = self.losses.iter().map(|a| -a * time).collect();
        product(&exponential(&matrix, n), sums, n)
    }
}

/// Losses tie sums together: one that another is fed from is known where that one is.
fn tied(mut known: Vec<bool>, losses: &[f64]) -> Vec<bool> {
    let n = known.len();
    for _ in 0..n {
        for i in 0..losses.len() / n.max(1) {
            known[i] &= (0..n).all(|j| losses[i * n + j] == 0.0 || known[j]);
        }
    }
    known
}

/// `A⁰` of the sums, empty where it is 0; `None` where the equation of the sums is not so simple.
fn losses(system: &System) -> Option<Vec<f64>> {
    let losses = match system {
        System::Transport { decay, source, .. } => match *source == 0.0 {
            true => vec![*decay],
            false => return None,
        },
        System::Telegraph {
            inductance,
            capacitance,
            resistance,
            conductance,
        } => vec![conductance / capacitance, 0.0, 0.0, resistance / inductance],
        System::ShallowWater { coriolis: f, .. } => {
            vec![0.0, 0.0, 0.0, 0.0, 0.0, -f, 0.0, *f, 0.0]
        }
        System::Matrices { decay, .. } => decay.clone(),
        System::VariableMatrices { decay, .. } => {
            let numbers: Option<Vec<f64>> = decay.iter().map(Formula::value).collect();
            numbers?
        }
        System::ConvectionDiffusion(problem) => match &problem.reaction {
            Reaction::None => Vec::new(),
            Reaction::Linear { matrix, source } if source.iter().all(|&f| f == 0.0) => {
                matrix.iter().map(|m| -m).collect()
            }
            _ => return None,
        },
        _ => Vec::new(),
    };
    let is_zero = losses.iter().all(|&a| a == 0.0);
    Some(if is_zero { Vec::new() } else { losses })
}

/// Whether a sum changes at the walls. At a mirror normal velocities and what else is odd are 0. The
/// flux of what is even is odd, and that sum stays; what is even pushes on the odd ones.
fn passes_walls(scenario: &LinearScenario, component: &str) -> bool {
    if let System::ConvectionDiffusion(problem) = &scenario.system {
        return !problem.is_closed();
    }
    let sides = scenario.domain.sides.iter();
    let axes = ["x", "y", "z"].into_iter().zip(sides);
    let mut walls = axes
        .filter(|(_, sides)| sides.contains(&Side::Mirror))
        .peekable();
    if walls.peek().is_none() {
        return false;
    }
    match &scenario.system {
        System::Transport { .. } => false,
        System::Acoustics { .. } | System::ShallowWater { .. } | System::LinearisedGas { .. } => {
            // In one dimension the velocity has no axis in its name.
            let normal =
                |axis: &str| component == "velocity" || component == format!("velocity_{axis}");
            walls.any(|(axis, _)| normal(axis))
        }
        System::Telegraph { .. } => component == "current",
        // A conductor: the electric field along it is odd.
        System::MaxwellTe { .. } => walls.any(|(axis, _)| {
            component.starts_with("electric") && component != format!("electric_{axis}")
        }),
        // A wall on which a solid slides: the shear is odd, as what is normal.
        System::ElasticWaves { .. } => walls
            .any(|(axis, _)| component == "stress_xy" || component == format!("velocity_{axis}")),
        System::Matrices { .. }
        | System::VariableMatrices { .. }
        | System::ConvectionDiffusion(_) => true,
    }
}
