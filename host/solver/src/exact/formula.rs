//! What the user says by formulas of place and time.

use crate::exact::flow::{Flow, FlowState};
use crate::exact::solution::Solution;
use crate::scenario::formula::Formula;
use crate::scenario::{EquationOfState, Piece, StateFormulas};

/// The variables of a formula: the place and the time.
fn variables([x, y, z]: [f64; 3], time: f64) -> [f64; 4] {
    [x, y, z, time]
}

/// Components that are given as formulas.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaSolution {
    /// One a component.
    pub components: Vec<Formula>,
}

impl Solution for FormulaSolution {
    fn components(&self) -> usize {
        self.components.len()
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let variables = variables(position, time);
        for (slot, formula) in state.iter_mut().zip(&self.components) {
            *slot = formula.at(&variables);
        }
    }
}

/// A gas whose state is given as formulas.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaFlow {
    /// Boxes with their formulas; beyond all of them the first one goes on.
    pub pieces: Vec<Piece>,
    /// What gives the energy, and the pressure where they do not.
    pub law: EquationOfState,
}

impl FormulaFlow {
    /// The formulas of a place.
    fn state(&self, position: [f64; 3]) -> Option<&StateFormulas> {
        let holds = |piece: &&Piece| {
            let sides = piece.extent.lower.iter().zip(&piece.extent.upper);
            sides
                .zip(position)
                .all(|((lower, upper), x)| (*lower..=*upper).contains(&x))
        };
        let piece = self.pieces.iter().find(holds).or(self.pieces.first())?;
        Some(&piece.state)
    }
}

impl Flow for FormulaFlow {
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let variables = variables(position, time);
        let value = |of: Option<&Formula>| of.map_or(f64::NAN, |of| of.at(&variables));
        let state = self.state(position);
        let density = value(state.map(|state| &state.density));
        let pressure = match state.and_then(|state| state.pressure.as_ref()) {
            Some(pressure) => pressure.at(&variables),
            None => self.law.pressure(density, 0.0),
        };
        let velocity = state.map_or(&[][..], |state| &state.velocity);
        FlowState {
            density,
            velocity: std::array::from_fn(|i| velocity.get(i).map_or(0.0, |u| u.at(&variables))),
            pressure,
            energy: self.law.energy(density, pressure),
        }
    }
}
