//! What the user says by formulas of place and time.

use crate::exact::flow::{Flow, FlowState};
use crate::exact::solution::Solution;
use crate::scenario::formula::Formula;
use crate::scenario::{EquationOfState, StateFormulas};

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
    /// The formulas.
    pub state: StateFormulas,
    /// What gives the energy, and the pressure where they do not.
    pub law: EquationOfState,
}

impl Flow for FormulaFlow {
    fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        let variables = variables(position, time);
        let density = self.state.density.at(&variables);
        let velocity = &self.state.velocity;
        let pressure = match &self.state.pressure {
            Some(pressure) => pressure.at(&variables),
            None => self.law.pressure(density, 0.0),
        };
        FlowState {
            density,
            velocity: std::array::from_fn(|i| velocity.get(i).map_or(0.0, |u| u.at(&variables))),
            pressure,
            energy: self.law.energy(density, pressure),
        }
    }
}
