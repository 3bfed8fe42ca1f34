//! What is studied of a scenario unless told.

use motes_core::cutoff::CutOff;

use super::{ErrorNorm, Theory};
use crate::families::compared;
use crate::run::{RECONSTRUCTION, STATE};
use crate::scenario::linear::LinearScenario;
use crate::scenario::{AnyScenario, Side, Width, fineness};

/// What is studied.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// The fields that there are.
    pub fields: Vec<String>,
    /// The one that is compared.
    pub field: String,
    /// In which norm.
    pub norm: ErrorNorm,
    /// What the theorems say; there is none of gas dynamics.
    pub theory: Option<Theory>,
    /// The least number of particles of a level: below it periods are too short for the cut-off.
    pub least: usize,
}

impl Subject {
    /// Of a gas the field that it holds to a tolerance, of a system its reconstruction where
    /// particles carry their values exactly, else the state.
    pub fn of(scenario: &AnyScenario) -> Self {
        let fields = compared(scenario);
        match scenario {
            AnyScenario::Gas(_) => {
                let held = scenario.tolerances().into_iter().next();
                Self {
                    field: held.map_or_else(|| fields[0].clone(), |tolerance| tolerance.field),
                    fields,
                    norm: ErrorNorm::L1,
                    theory: None,
                    least: 0,
                }
            }
            AnyScenario::Linear(scenario) => Self {
                field: match scenario.is_carried() {
                    true => RECONSTRUCTION.to_owned(),
                    false => STATE.to_owned(),
                },
                fields,
                norm: ErrorNorm::L2,
                theory: Some(theory(scenario)),
                least: least(scenario),
            },
        }
    }
}

fn theory(scenario: &LinearScenario) -> Theory {
    let shape = scenario.cut_off.shape;
    Theory {
        order_r: shape.order(),
        smoothness: match scenario.dimension {
            1 => shape.smoothness::<1>(),
            2 => shape.smoothness::<2>(),
            _ => shape.smoothness::<3>(),
        },
        theta: match scenario.cut_off.width {
            Width::Adaptive { theta, .. } => theta,
            Width::Constant { .. } => 0.0,
        },
    }
}

/// The number of particles, to a factor of 2, from which on every period holds three reaches of
/// the cut-off.
fn least(scenario: &LinearScenario) -> usize {
    let (extent, dimension) = (&scenario.domain.extent, scenario.dimension as f64);
    let periods = scenario.domain.sides.iter().enumerate();
    let periods = periods.filter(|(_, sides)| sides[0] == Side::Periodic);
    let shortest = periods
        .map(|(axis, _)| extent.upper[axis] - extent.lower[axis])
        .fold(f64::INFINITY, f64::min);
    let support = f64::from(scenario.cut_off.shape.support());
    let fits = |&count: &usize| {
        let spacing = libm::pow(extent.volume() / count as f64, 1.0 / dimension);
        let fineness = fineness(count, scenario.dimension);
        let epsilon = scenario.cut_off.width.epsilon(spacing, fineness);
        // The solver's reach is 1/64 longer than the support, and cells round.
        3.1 * support * epsilon <= shortest
    };
    (0..30).map(|i| 1 << i).find(fits).unwrap_or(0)
}
