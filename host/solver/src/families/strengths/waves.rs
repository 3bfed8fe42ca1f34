//! The waves of a system whose matrices are formulas: looked for all over the domain and the run.

use super::frame::times;
use crate::families::PlanError;
use crate::scenario::Extent;
use crate::scenario::formula::Formula;
use crate::scenario::linear::System;
use crate::symmetriser::Symmetriser;

/// What bounds the steps of a system whose matrices are formulas, in the scenario's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::families) struct WaveBounds {
    /// The largest `|eigenvalue|` of `Σ_i n_i A^i`, `|n| = 1`.
    pub speed: f64,
    /// A bound of the `|eigenvalues|` of `A⁰`.
    pub damping: f64,
}

/// Nodes along each direction: a symmetriser takes a thousand times what a formula does.
const NODES: [usize; 3] = [33, 7, 4];
/// What a speed may be between them, in those at them.
const BETWEEN: f64 = 1.1;

impl WaveBounds {
    /// Those of a system over a box, from 0 to a time; `None` for another system.
    ///
    /// # Errors
    /// A place where its matrices are no numbers or have no symmetriser: Remark 1.
    pub fn of(system: &System, extent: &Extent, duration: f64) -> Result<Option<Self>, PlanError> {
        let System::VariableMatrices {
            flux,
            decay,
            components,
            ..
        } = system
        else {
            return Ok(None);
        };
        let dimension = extent.lower.len();
        let nodes = NODES[dimension - 1];
        let mut waves = Self {
            speed: 0.0,
            damping: 0.0,
        };
        let mut last: Option<(Vec<Vec<f64>>, f64)> = None;
        for time in times(duration) {
            for mut number in 0..nodes.pow(dimension as u32) {
                let mut point = [0.0, 0.0, 0.0, time];
                for (i, x) in point.iter_mut().enumerate().take(dimension) {
                    let part = (number % nodes) as f64 / (nodes - 1) as f64;
                    *x = extent.lower[i] + part * (extent.upper[i] - extent.lower[i]);
                    number /= nodes;
                }
                let values =
                    |matrix: &Vec<Formula>| matrix.iter().map(|of| of.at(&point)).collect();
                let matrices: Vec<Vec<f64>> = flux.iter().map(values).collect();
                let speed = match &last {
                    Some((same, speed)) if *same == matrices => *speed,
                    _ => {
                        let found = Symmetriser::of(&matrices);
                        found
                            .map_err(|source| PlanError::Place {
                                position: point[..dimension].to_vec(),
                                time,
                                source,
                            })?
                            .speed
                    }
                };
                waves.speed = waves.speed.max(BETWEEN * speed);
                let decay: Vec<f64> = values(decay);
                waves.damping = waves.damping.max(BETWEEN * row_sum(&decay, *components));
                last = Some((matrices, speed));
            }
        }
        Ok(Some(waves))
    }
}

/// The largest sum of `|coefficients|` of a row: a bound of the eigenvalues.
pub(in crate::families) fn row_sum(matrix: &[f64], size: usize) -> f64 {
    let rows = matrix.chunks_exact(size);
    rows.map(|row| row.iter().map(|a| a.abs()).sum())
        .fold(0.0, f64::max)
}
